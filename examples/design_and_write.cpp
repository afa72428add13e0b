// The best plagiograph for a small region, and all files that a workshop needs to build it.
//
// usage: design_and_write FOLDER

#include <iostream>
#include <kempe/kempe.hpp>

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: design_and_write FOLDER\n";
    return 2;
  }
  kempe::Spec spec;
  spec.copy = kempe::Copy::of(1.4, 90 * kempe::degree);
  spec.region = kempe::Region::rectangle({62, -5}, {8, 10});
  spec.links.style.width = 6;
  spec.links.style.pin_diameter = 3;

  const kempe::Outcome outcome = kempe::design(spec);
  if (!outcome) {
    std::cerr << outcome.reason() << '\n';
    return 1;
  }
  const kempe::LinkLengths lengths = outcome->lengths();
  std::cout << "VA " << lengths.VA << " mm, VB " << lengths.VB << " mm, size " << outcome->size() << " mm";
  if (const auto bound = outcome->proven_bound()) std::cout << ", none below " << *bound << " mm";
  std::cout << '\n';

  const kempe::Written written = kempe::write(*outcome, arguments[1], {.title = "design_and_write"});
  if (!written) {
    std::cerr << written.reason << '\n';
    return 1;
  }
  std::cout << written.files.size() << " files in " << arguments[1] << '\n';
}
