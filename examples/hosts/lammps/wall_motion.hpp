// SPDX-License-Identifier: MIT
// The motion of a wall along one axis: none, or one of three.
//
//   wiggle DIM AMPLITUDE PERIOD    displacement A (1 - cos(2 pi t / T))
//   shear DIM SPEED                the surface moves, the wall does not
//   velocity DIM SPEED             the wall moves at this speed
#pragma once

#include <cmath>
#include <string>

#include "contactlaws/contactlaws.hpp"

namespace contactlaws {

class WallMotion {
 public:
  /// How many numbers follow DIM; 0: no word for a motion.
  static int numbers(const std::string& name) {
    return name == "wiggle" ? 2 : name == "shear" || name == "velocity" ? 1 : 0;
  }

  /// @throws std::invalid_argument if the dimension is none, a period is not positive, or there is a motion already
  void set(const std::string& name, const std::string& dimension, double first, double second) {
    if (kind_ != Kind::none) reject("a wall has one motion, not " + name + " too");
    if (dimension != "x" && dimension != "y" && dimension != "z")
      reject(name + " is along x, y or z, not '" + dimension + "'");
    axis_ = dimension[0] - 'x';
    if (name == "wiggle") {
      require_in(Range::positive(), second, "wall", "period", "s");
      kind_ = Kind::wiggle;
      amplitude_ = first;
      angular_frequency_ = 2.0 * pi<double>() / second;
    } else {
      kind_ = name == "shear" ? Kind::shear : Kind::velocity;
      speed_ = first;
    }
  }

  int axis() const { return axis_; }  ///< 0, 1 or 2; 2 where nothing moves
  bool shears() const { return kind_ == Kind::shear; }

  /// At a time since the beginning [s].
  double displacement(double time) const {
    if (kind_ == Kind::wiggle) return amplitude_ * (1.0 - std::cos(angular_frequency_ * time));
    return kind_ == Kind::velocity ? speed_ * time : 0.0;
  }
  double velocity(double time) const {
    if (kind_ == Kind::wiggle) return amplitude_ * angular_frequency_ * std::sin(angular_frequency_ * time);
    return speed_;
  }

 private:
  enum class Kind { none, wiggle, shear, velocity };
  Kind kind_ = Kind::none;
  int axis_ = 2;
  double speed_ = 0.0, amplitude_ = 0.0, angular_frequency_ = 0.0;
};

}  // namespace contactlaws
