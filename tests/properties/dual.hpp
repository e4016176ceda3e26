// A number with derivatives by every input of a step.
#pragma once

#include "contactlaws/scalars/autodiff.hpp"

namespace contactlaws::test {

constexpr int inputs = 12;  // normal, overlap, velocity, dt, spin, relative spin
using Gradient = Eigen::Matrix<double, inputs, 1>;
using Dual = Eigen::AutoDiffScalar<Gradient>;

}  // namespace contactlaws::test
