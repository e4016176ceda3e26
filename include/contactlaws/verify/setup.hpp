// SPDX-License-Identifier: MIT
// The common part of the checks: an update driven along paths, and the worst of what a measure finds there.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "contactlaws/verify/random_paths.hpp"
#include "contactlaws/verify/reduce.hpp"
#include "contactlaws/verify/report.hpp"

namespace contactlaws::verify {

/// Force on body 2, and the couple on it over R1 + R2 [N]. The couple is the part of the torque that is not arm x force.
using Load = Eigen::Matrix<double, 6, 1>;

inline double load_norm(const Load& load) { return norm<double>(load.head<3>()) + norm<double>(load.tail<3>()); }

inline Load load_of(const Bodies& b, const Interaction& interaction) {
  Vector couple(0, 0, 0);
  if (interaction.torque2) {
    const auto geometry = sphere_sphere<double>(b.one.position, b.one.radius, b.two.position, b.two.radius);
    couple = *interaction.torque2 - geometry.arm2.cross(interaction.force);
  }
  Load load;
  load << interaction.force, couple / b.length();
  return load;
}

/// What an update returned along a trajectory.
struct Record {
  std::vector<Interaction> interactions{};
  std::vector<Load> loads{};
  ForceUpdate::State state{};  ///< after the last step

  /// The largest force, to which errors are relative [N]; 1 where there is none.
  double largest_force() const {
    double largest = 0.0;
    for (const Interaction& i : interactions) largest = maximum<double>(largest, norm<double>(i.force));
    return largest > 0.0 ? largest : 1.0;
  }
};

inline Record drive(const ForceUpdate& update, const Trajectory& trajectory) {
  Record record;
  record.state = update.start();
  record.interactions.reserve(trajectory.size());
  record.loads.reserve(trajectory.size());
  for (const Instant& instant : trajectory) {
    record.interactions.push_back(update.step(instant.bodies, instant.dt, record.state));
    record.loads.push_back(load_of(instant.bodies, record.interactions.back()));
  }
  return record;
}

/// The load with the bodies at rest where they are, from a copy of the state: that of the springs, without the dashpots.
inline Load load_at_rest(const ForceUpdate& update, const Instant& instant, ForceUpdate::State state) {
  const Bodies bodies = at_rest(instant.bodies);
  return load_of(bodies, update.step(bodies, instant.dt, state));
}

using Measure = std::function<Finding(const Path&)>;

struct Setup {
  ForceUpdate update;
  Options options;
  Scales scales;
  std::vector<Path> paths{};  ///< the random paths that most properties share

  /// @throws std::invalid_argument on an option out of range, or an update without a push at the usual overlap
  Setup(const ForceUpdate& checked, const Options& with)
      : update(checked), options(checked_options(with)), scales{with.overlap, with.radius1 + with.radius2, 0, 0, 0} {
    const auto push = [this](double share) {  // slowly, since a law may build its force up by increments
      Path path;
      for (int i = 1; i <= 100; ++i)
        path.push_back({Vector(0, 0, 1), share * scales.overlap * i / 100, {0, 0, 0}, 1.0});
      set_normal_velocities(path);
      return drive(update, trajectory(path)).interactions.back().force.z();
    };
    scales.force = push(1.0);
    require_in(Range::positive(), scales.force, Options::name, "the law's force at the overlap", "N");
    using std::sqrt;
    scales.time = sqrt(options.mass1 * options.mass2 / (options.mass1 + options.mass2) * scales.overlap / scales.force);
    // The overlap is a difference of lengths, so their rounding is multiplied by length/overlap; a hundred of them:
    // 20 steps with a few each. The largest seen of our laws is three.
    scales.rounding = 100 * options.epsilon * scales.length / scales.overlap;
    Random random(options.seed);
    for (int i = 0; i < options.paths; ++i) paths.push_back(random_path(random, scales));
  }

  Trajectory trajectory(const Path& path) const { return verify::trajectory(path, options); }
  Record drive_along(const Path& path) const { return drive(update, trajectory(path)); }
  /// The load of one step, which advances the state.
  Load load(const Bodies& bodies, double dt, ForceUpdate::State& state) const {
    return load_of(bodies, update.step(bodies, dt, state));
  }

  /// Whether any interaction along the random paths has something: an open contact may return a force alone.
  bool returns(const std::function<bool(const Interaction&)>& has) const {
    return std::any_of(paths.begin(), paths.end(), [&](const Path& path) {
      const Record record = drive_along(path);
      return std::any_of(record.interactions.begin(), record.interactions.end(), has);
    });
  }
  /// A tenth of the number of random paths, for properties with long ones.
  int few() const { return options.paths / 10 + 1; }
  /// Random paths of one property, each from a random normal and a direction across it; `make` need not set normal velocities.
  template <class Make>
  std::vector<Path> make_paths(const char* name, int count, const Make& make) const {
    Random random(options.seed, name);
    std::vector<Path> all;
    for (int k = 0; k < count; ++k) {
      const Vector normal = random.direction();
      const Vector along = random.direction_across(normal);
      all.push_back(make(random, normal, along));
      set_normal_velocities(all.back());
    }
    return all;
  }

  /// One step to an overlap [m] with a slip [m] across the normal, in a tenth of the characteristic time.
  Motion move(const Vector& normal, double overlap, const Vector& slip = Vector(0, 0, 0)) const {
    const double dt = scales.time / 10;
    return {normal, overlap, slip / dt, dt};
  }

  /// The worst finding of all paths; the path of a failure is reduced.
  Result worst_of(const char* property, const char* unit, const std::vector<Path>& tried,
                  const Measure& measure) const {
    using std::isnan;
    Result result{property};
    result.measure = unit;
    const Path* worst = nullptr;
    for (const Path& path : tried) {
      const Finding finding = measure(path);
      const bool less =
          finding.error - finding.allowed <= result.worst.error - result.worst.allowed;  // false for a NaN
      if (worst && (less || isnan(result.worst.error))) continue;
      result.worst = finding;
      worst = &path;
    }
    if (!worst || !result.worst.failed()) return result;
    result.verdict = Verdict::fail;
    result.path = reduced(*worst, [&](const Path& path) {
      const Finding finding = measure(path);
      if (isnan(result.worst.error)) return isnan(finding.error);
      return finding.failed() && !(finding.error < result.worst.error / 10);
    });
    return result;
  }
  Result worst_of(const char* property, const char* unit, const Measure& measure) const {
    return worst_of(property, unit, paths, measure);
  }
};

}  // namespace contactlaws::verify
