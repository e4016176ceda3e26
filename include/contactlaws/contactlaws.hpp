// SPDX-License-Identifier: MIT
// All of contactlaws but the headers for further scalars (contactlaws/scalars/) and the checks (contactlaws/verify/).
#pragma once

#include "contactlaws/core/version.hpp"
#include "contactlaws/damping/restitution.hpp"
#include "contactlaws/energy.hpp"
#include "contactlaws/laws.hpp"
#include "contactlaws/normal/linear_hysteretic.hpp"
#include "contactlaws/rolling/rolling_spring_dashpot.hpp"
#include "contactlaws/rolling/rolling_torque.hpp"
#include "contactlaws/rolling/twisting_spring.hpp"
#include "contactlaws/rolling/twisting_spring_dashpot.hpp"
#include "contactlaws/tangential/mindlin_deresiewicz.hpp"
#include "contactlaws/timestep.hpp"
