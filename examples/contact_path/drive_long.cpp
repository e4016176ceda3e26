// SPDX-License-Identifier: MIT
#include "drive.hpp"

template void contact_path::drive<long double>(const LawDescription&, const std::string&, std::ostream&);
