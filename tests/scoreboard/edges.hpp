// Two kinds of random paths that finite.cpp and forces.cpp try: what happens to a contact in the field, and at the edges.
#pragma once

#include "properties/paths.hpp"
#include "row.hpp"

namespace contactlaws::test {

/// What happens to a contact in the field: grains from a micrometre to a metre, from gel to steel.
struct Field {
  static constexpr int length = 10;
  Path path(Random& random) const { return random_path(random, length); }
  template <class T>
  void tune(ErasedLaw<T>&, Random&) const {}
};

/// What happens to it at the edges of everything: planes, rigid and fixed sides, size ratios to 1e9, nu at both its ends,
/// overlaps from the smallest denormal to the radius, jumps from separation to full overlap in one step, steps over 12
/// decades, no friction or 1e9 of it, no dashpots or alpha = 1.
struct Edges {
  static constexpr int length = 6;
  double denormal;  ///< the smallest number of the precision at hand

  Path path(Random& random) const {
    const auto material = [&random] {
      const double poisson[] = {-1.0 + 1e-6, -0.5, 0.0, 0.3, 0.5 - 1e-7, 0.5};
      const double young = random.log_uniform(1e3, 1e12);
      const int which = random.integer(0, 5);
      return ElasticMaterial<double>{young, poisson[which], random.log_uniform(1.0, 3e4)};
    };
    const double radius = random.log_uniform(1e-5, 1.0);
    const double other = radius * random.log_uniform(1e-4, 1e5);
    const double nine_decades = radius * (random.chance(0.5) ? 1e9 : 1.0);
    const ContactBody<double> one = sphere(material(), radius);
    const ContactBody<double> sides[] = {sphere(material(), other),
                                         sphere(material(), nine_decades),
                                         plane(material()),
                                         plane(material()).rigid(),
                                         sphere(material(), other).fixed(),
                                         sphere(material(), other).rigid().fixed(),
                                         spherical_cup(material(), 2 * radius)};
    const int side = random.integer(0, 6);
    Path path{pair_properties(sides[side], one), {}, random.chance(0.5)};
    const double dt = random.log_uniform(1e-12, 1.0);
    for (int i = 0; i < length; ++i) {
      const double overlaps[] = {denormal,      2 * denormal,
                                 0.0,           -denormal,
                                 1e-30,         path.pair.effective_radius,
                                 -1e3 * radius, path.pair.effective_radius * random.log_uniform(1e-15, 1.0)};
      const Vec3<double> axes[] = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
      const Vec3<double> normal = random.chance(0.3) ? axes[random.integer(0, 2)] : random.direction();
      const Vec3<double> way = random.chance(0.2) ? normal : random.direction();
      const double speed = random.chance(0.2) ? 0.0 : random.log_uniform(denormal, 1e6);
      const double overlap = overlaps[random.integer(0, 7)];
      const double step = random.chance(0.05) ? 0.0 : dt;
      const double spin = random.chance(0.5) ? 0.0 : random.uniform(-3.0, 3.0) / dt;
      const Vec3<double> rolling = spin * random.direction();
      path.steps.push_back({normal, overlap, speed * way, step, spin, rolling});
    }
    return path;
  }
  template <class T>
  void tune(ErasedLaw<T>& law, Random& random) const {
    const double friction = random.chance(0.3) ? 0.0 : random.chance(0.5) ? 1e9 : 0.5;
    const double damping = random.chance(0.5) ? 0.0 : 1.0;
    const double suction = random.chance(0.5) ? 0.0 : 1e9;
    for (const auto& p : law.parameters()) {
      if (p.name.find("friction") != std::string::npos) *p.value = T(friction);
      if (p.name.find("damping") != std::string::npos) *p.value = T(damping);
      if (p.name == "suction") *p.value = T(suction);
    }
  }
};

}  // namespace contactlaws::test
