// SPDX-License-Identifier: MIT
#include "contactlaws/scalars/multiprecision.hpp"
#include "drive.hpp"

template void contact_path::drive<contactlaws::Binary200>(const LawSpec&, const std::string&, std::ostream&);
