// SPDX-License-Identifier: MIT
// All of contactlaws but the adapters for foreign scalars (contactlaws/adapt/).
#pragma once

#include "contactlaws/energy.hpp"
#include "contactlaws/laws.hpp"
#include "contactlaws/restitution.hpp"
#include "contactlaws/timestep.hpp"
#include "contactlaws/version.hpp"
