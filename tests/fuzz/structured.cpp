#include "tests/fuzz/structured.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "synthesis/assemble.hpp"
#include "synthesis/search.hpp"
#include "synthesis/verification.hpp"

namespace kempe::fuzz {
namespace {

/// Numbers from bytes, two each; zeros once the bytes are used up.
class Choices {
 public:
  explicit Choices(std::string_view bytes) : bytes_(bytes) {}

  double between(double lower, double upper) { return lower + (upper - lower) * next() / 65535.0; }
  int upto(int count) { return static_cast<int>(next()) % count; }

 private:
  unsigned next() {
    unsigned value = 0;
    for (int i = 0; i < 2; ++i) {
      value = value * 256;
      if (at_ < bytes_.size()) value += static_cast<unsigned char>(bytes_[at_++]);
    }
    return value;
  }
  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// A star-shaped polygon of 3 .. 30 corners beside the pole.
Polygon polygon(Choices& choices) {
  const int corners = 3 + choices.upto(28);
  const double distance = choices.between(40, 400), radius = choices.between(2, 0.8 * distance);
  const double bearing = choices.between(-pi, pi);
  const Point centre = distance * Point(std::cos(bearing), std::sin(bearing));
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double at = 2 * pi * i / corners, r = radius * choices.between(0.3, 1);
    ring.push_back(centre + r * Point(std::cos(at), std::sin(at)));
  }
  return {ring, {}};
}

Spec spec_from(Choices& choices) {
  Spec spec;
  spec.copy.scale = std::exp(choices.between(std::log(0.1), std::log(10)));
  spec.copy.rotation = choices.upto(3) == 0 ? choices.upto(4) * pi / 2 : choices.between(-pi, pi);
  spec.copy.k = copy_ratio(spec.copy.scale, spec.copy.rotation);
  if (std::abs(spec.copy.k - 1.0) < 1e-3) spec.copy.k = copy_ratio(spec.copy.scale = 2, spec.copy.rotation);
  spec.region.polygons.push_back(polygon(choices));
  spec.links.style.width = choices.between(2, 25);
  spec.links.style.pin_diameter = spec.links.style.width * choices.between(0.2, 1);
  spec.links.style.plate = choices.upto(2) == 0 ? PlateStyle::bent : PlateStyle::triangle;
  spec.links.layers = 2 + choices.upto(2);
  spec.links.shortest = choices.between(1, 40);
  spec.links.longest = choices.between(200, 2000);
  spec.limits.transmission = choices.between(0, radians(50));
  spec.limits.clearance = choices.between(0, 3);
  if (choices.upto(3) == 0) {
    const double reach = choices.between(5, 60);
    spec.pole.place = Region{{{{{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}}, {}}}};
  }
  if (choices.upto(3) == 0) spec.objective.objective = Objective::transmission;
  return spec;
}

void require(bool condition, const std::string& what) {
  if (condition) return;
  std::fprintf(stderr, "a design that was found does not hold: %s\n", what.c_str());
  std::abort();
}

}  // namespace

void design_from_choices(std::string_view input) {
  Choices choices(input);
  const Spec spec = spec_from(choices);
  SearchOptions options;
  options.diagnose = false;
  const SearchOutcome outcome = synthesize(spec, options);
  const auto* found = std::get_if<FoundDesign>(&outcome);
  if (found == nullptr) return;
  MapOptions map;
  map.largest_sheets = false;
  Design design = assemble_design(spec, *found, map);
  require(design.map.coverage.covered, "coverage: " + design.map.coverage.why_not);
  VerificationTask task = verification_task(design);
  task.shortest = spec.links.shortest;
  task.longest = spec.links.longest;
  const Verification verification = verify(task);
  require(verification.certified, verification.failure);
}

}  // namespace kempe::fuzz
