// SPDX-License-Identifier: MIT
#include "drive.hpp"

template void contact_path::drive<double>(const LawSpec&, const std::string&, std::ostream&);
