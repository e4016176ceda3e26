// SPDX-License-Identifier: MIT
#include "drive.hpp"

template void contact_path::drive<float>(const LawDescription&, const std::string&, std::ostream&);
