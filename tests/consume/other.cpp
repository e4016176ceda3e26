#include <contactlaws/contactlaws.hpp>

double length_in_other_unit() { return contactlaws::norm<double>({4.0, 3.0, 0.0}); }
