// SPDX-License-Identifier: MIT
#include "drive.hpp"

template void contact_path::drive<long double>(const LawSpec&, const std::string&, std::ostream&);
