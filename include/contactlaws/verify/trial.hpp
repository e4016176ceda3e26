// SPDX-License-Identifier: MIT
// A law on trial: driven along paths, judged by what is measured there.
#pragma once

#include <string>
#include <vector>

#include "contactlaws/verify/random_paths.hpp"
#include "contactlaws/verify/report.hpp"
#include "contactlaws/verify/shrink.hpp"

namespace contactlaws::verify {

using Answers = std::vector<Interaction>;

/// What the law answers along the scene, from `state` on, which it moves.
template <class Law>
Answers answers(const Law& law, const Scene& scene, detail::State<Law>& state) {
  Answers all;
  for (const Moment& moment : scene) all.push_back(law(moment.bodies, moment.dt, state));
  return all;
}
template <class Law>
Answers answers(const Law& law, const Scene& scene) {
  detail::State<Law> state = start_of(law);
  return answers(law, scene, state);
}

/// The force with the bodies at rest where they are, of a copy of the state: what springs hold, without the dashpots.
template <class Law>
Vector force_at_rest(const Law& law, const Moment& moment, detail::State<Law> state) {
  return law(at_rest(moment.bodies), moment.dt, state).force;
}

/// The largest force, which errors are measured in [N]; 1 where there is none.
inline double largest_force(const Answers& all) {
  double largest = 0.0;
  for (const Interaction& a : all) largest = maximum<double>(largest, norm<double>(a.force));
  return largest > 0.0 ? largest : 1.0;
}

/// The largest difference between two answers, in forces of `force` [N] and arms of `arm` [m].
inline double difference(const Interaction& a, const Interaction& b, double force, double arm) {
  double largest = norm<double>(a.force - b.force) / force;
  const auto compare = [&](const std::optional<Vector>& x, const std::optional<Vector>& y, double scale) {
    if (!x || !y) return;
    const double off = norm<double>(*x - *y) / scale;
    if (!(off <= largest)) largest = off;  // takes a NaN
  };
  compare(a.force1, b.force1, force);
  compare(a.torque1, b.torque1, force * arm);
  compare(a.torque2, b.torque2, force * arm);
  return largest;
}

template <class Law>
class Trial {
 public:
  /// @throws std::invalid_argument on an option out of range, or a law that does not push at the usual overlap
  Trial(const Law& tried, const Options& of)
      : law(tried), options(checked_options(of)), scales{options.overlap, 1.0, 1.0}, random(options.seed) {
    scales.force = approach();
    require_in(Range::positive(), scales.force, Options::name, "the law's force at the overlap", "N");
    const double mass = options.mass1 * options.mass2 / (options.mass1 + options.mass2);
    using std::sqrt;
    scales.time = sqrt(mass * options.overlap / scales.force);
    for (int i = 0; i < options.paths; ++i) paths.push_back(random_path(random, scales));
  }

  const Law& law;
  const Options options;
  Scales scales;
  std::vector<Path> paths;
  mutable Random random;

  Scene scene(const Path& path) const { return staged(path, options); }
  double length() const { return options.radius1 + options.radius2; }

  /// Rounding that a force may show, relative to the largest: the overlap is a difference of lengths, so their rounding
  /// is multiplied by length/overlap; a hundred of them: 20 steps with a few each. Seen of our laws: three.
  double rounding() const { return 100 * options.epsilon * length() / options.overlap; }

  /// A step from the last: overlap [m] and slip [m] across the normal, in a tenth of the natural time.
  Motion move(const Vector& normal, double overlap, const Vector& slip = Vector(0, 0, 0)) const {
    const double dt = scales.time / 10;
    return {normal, overlap, slip / dt, dt, 0.0};
  }

  /// Measures each path; a failure's worst path is reduced.
  template <class Measure>
  Result judge(const char* property, const char* unit, const std::vector<Path>& tried, const Measure& measure) const {
    using std::isnan;
    Result result{property};
    result.measure = unit;
    const Path* worst = nullptr;
    for (const Path& path : tried) {
      const Finding finding = measure(path);
      const bool less = finding.error - finding.allowed <= result.worst.error - result.worst.allowed;  // not of a NaN
      if (worst && (less || isnan(result.worst.error))) continue;
      result.worst = finding;
      worst = &path;
    }
    if (!worst || !result.worst.failed()) return result;
    result.verdict = Verdict::fail;
    result.path = shrunk(*worst, [&](const Path& path) {
      const Finding finding = measure(path);
      if (isnan(result.worst.error)) return isnan(finding.error);
      return finding.failed() && !(finding.error < result.worst.error / 10);
    });
    return result;
  }
  template <class Measure>
  Result judge(const char* property, const char* unit, const Measure& measure) const {
    return judge(property, unit, paths, measure);
  }

 private:
  /// Slowly, since a law may build its force up by increments [N].
  double approach() const {
    Path path;
    for (int i = 1; i <= 100; ++i)
      path.push_back({Vector(0, 0, 1), options.overlap * i / 100, Vector(0, 0, 0), 1.0, 0.0});
    settle(path);
    return answers(law, staged(path, options)).back().force.z();
  }
};

inline Result not_claimed(const char* property) { return {property, Verdict::not_claimed}; }
inline Result not_offered(const char* property) { return {property, Verdict::not_offered}; }

}  // namespace contactlaws::verify
