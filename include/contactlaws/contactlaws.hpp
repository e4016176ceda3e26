// SPDX-License-Identifier: MIT
// All of contactlaws but the adapters for foreign scalars (contactlaws/adapt/).
#pragma once

#include "contactlaws/core/version.hpp"
#include "contactlaws/damping/restitution.hpp"
#include "contactlaws/energy.hpp"
#include "contactlaws/laws.hpp"
#include "contactlaws/timestep.hpp"
