// A law, a pair and a motion drawn from bytes: all that the headers allow, at any magnitude at which no product of five
// of them overflows (lengths 2^-40 to 2^21 m, moduli 1 to 2^61 Pa, speeds up to 2^40 m/s, overlaps down to the denormals).
#pragma once

#include <stdexcept>
#include <string>

#include "bytes.hpp"
#include "contactlaws/contactlaws.hpp"
#include "properties/erased_law.hpp"

namespace fuzz {

using namespace contactlaws;
using Motion = ContactKinematics<double>;
using Vector = Vec3<double>;

/// Draws each parameter of a law anew from its range.
inline void draw_parameters(test::ErasedLaw<double>& law, Bytes& bytes) {
  for (const auto& p : law.parameters()) {
    double& value = *p.value;
    if (p.range.low_included && bytes.one_in(8)) {
      value = p.range.low;
    } else if (p.range.high < Range::unbounded) {
      value = bytes.one_in(8) ? p.range.high : p.range.low + (p.range.high - p.range.low) * bytes.fraction();
    } else if (p.unit == "Pa") {
      value = bytes.magnitude(-10, 60);
    } else if (p.unit == "N/m") {
      value = bytes.magnitude(-20, 60);
    } else if (p.unit == "m^3") {
      value = bytes.magnitude(-160, 60);
    } else if (p.unit == "m") {
      value = bytes.magnitude(-60, -1);
    } else if (p.unit == "N") {
      value = bytes.magnitude(-120, 20);
    } else {
      value = bytes.one_in(4) ? bytes.magnitude(-20, 10) : bytes.magnitude(-4, 0);
    }
  }
}

inline ContactBody<double> drawn_side(Bytes& bytes, bool may_be_wall) {
  const double poisson = bytes.one_in(8) ? 0.5 : 0.5 - 1.5 * bytes.fraction();
  const double young = bytes.magnitude(0, 60);
  const double density = bytes.magnitude(-10, 20);
  const ElasticMaterial<double> material{young, poisson, density};
  const double radius = bytes.magnitude(-40, 20);
  const unsigned kind = bytes.byte() % 8;
  if (!may_be_wall) return sphere(material, radius);
  if (kind == 0) return plane(material);
  if (kind == 1) return plane(material).rigid();
  if (kind == 2) return spherical_cup(material, radius);
  if (kind == 3) return sphere(material, radius).fixed();
  return sphere(material, radius);
}

inline PairProperties<double> drawn_pair(Bytes& bytes) {
  const ContactBody<double> ball = drawn_side(bytes, false);
  try {
    return pair_properties(ball, drawn_side(bytes, true));
  } catch (const std::invalid_argument&) {  // a ball too large for its concave wall
    return pair_properties(ball, ball);
  }
}

/// How a contact moves from step to step: at one depth for most of the time, and now and then at any other.
class Mover {
 public:
  /// `wild`: any finite number may come, beyond what the law can answer with finite forces.
  Mover(const PairProperties<double>& pair, Bytes& bytes, bool wild)
      : bytes_(bytes),
        wild_(wild),
        radius_(pair.effective_radius),
        depth_(radius_ * bytes.magnitude(-30, 0)),
        spins_(bytes.one_in(2)) {
    motion_.normal = direction();
    motion_.velocity = Vector::Zero();
    motion_.dt = bytes.magnitude(-60, 5);
  }

  const Motion& next() {
    turn();
    motion_.overlap = overlap();
    motion_.velocity = velocity();
    if (bytes_.one_in(16)) motion_.dt = bytes_.one_in(2) ? 0.0 : bytes_.magnitude(-60, 5);
    if (spins_ && bytes_.one_in(4)) twist_ = number(-200, 2);
    motion_.normal_spin = motion_.dt > 0.0 ? twist_ / motion_.dt : 0.0;
    motion_.relative_spin = velocity() / radius_;
    return motion_;
  }

 private:
  double number(int low, int high) { return wild_ ? bytes_.number(-1074, 1023) : bytes_.number(low, high); }

  /// Three numbers, drawn from x to z.
  template <class Draw>
  static Vector vector(const Draw& draw) {
    Vector v;
    for (int i = 0; i < 3; ++i) v[i] = draw();
    return v;
  }
  Vector direction() {
    for (;;) {
      const Vector v = vector([this] { return 2.0 * bytes_.fraction() - 1.0; });
      if (v.squaredNorm() > 0.01) return v.normalized();
    }
  }

  void turn() {
    Vector& n = motion_.normal;
    switch (bytes_.byte() % 8) {
      case 0:
        n = direction();
        break;
      case 1:
        n = -n;
        break;
      case 2: {
        const int axis = bytes_.between(0, 2);
        n = Vector::Unit(axis) * bytes_.sign();
        break;
      }
      case 3:
      case 4: {
        const Vector aside = direction();
        n = (n + aside * bytes_.magnitude(-60, -2)).normalized();
        break;
      }
      default:
        break;
    }
  }

  double overlap() {
    const unsigned kind = bytes_.byte() % 16;
    if (kind == 0 && wild_) return bytes_.number(-1074, 1023);
    if (kind == 3) return motion_.overlap;
    if (kind == 5) return depth_;
    const double sign = kind == 0 || kind == 1 || kind == 4 ? bytes_.sign() : 1.0;
    if (kind == 0) return sign * bytes_.magnitude(-1074, -41);
    if (kind == 1) return sign * 0.0;
    if (kind == 2) return -depth_ * bytes_.magnitude(-10, 10);
    if (kind == 4) return std::nextafter(motion_.overlap, sign);
    return depth_ * bytes_.fraction();
  }

  Vector velocity() {
    if (bytes_.one_in(8)) return Vector::Zero();
    if (bytes_.one_in(4)) return vector([this] { return number(-200, 40); });
    const double speed = motion_.dt > 0.0 ? depth_ / motion_.dt * bytes_.magnitude(-20, 2) : 1.0;
    return direction() * std::fmin(speed, 0x1p40);
  }

  Bytes& bytes_;
  bool wild_;
  double radius_, depth_;
  bool spins_;
  double twist_ = 0.0;  ///< about the normal, in a step [rad]
  Motion motion_{};
};

}  // namespace fuzz
