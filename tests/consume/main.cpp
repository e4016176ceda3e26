#include <contactlaws/contactlaws.hpp>
#include <iostream>

double length_in_other_unit();

int main() {
  const double length = contactlaws::norm<double>({3.0, 0.0, 4.0});
  std::cout << "contactlaws " << contactlaws::version << ": " << length << ' ' << length_in_other_unit() << '\n';
  return length == length_in_other_unit() ? 0 : 1;
}
