#include "tests/fuzz/structured.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "reports/audit/design_audit.hpp"
#include "reports/audit/recheck.hpp"
#include "reports/design_package.hpp"
#include "specs/materials.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/search/search.hpp"
#include "synthesis/verification/verification.hpp"
#include "tests/fuzz/choices.hpp"
#include "tests/geometry/grid_outlines.hpp"
#include "tests/random.hpp"

namespace kempe::fuzz {
namespace {

/// A star-shaped polygon of 3 .. 30 corners beside the pole; one in four is an outline on a grid.
Polygon polygon(Choices& choices) {
  const int corners = 3 + choices.upto(28);
  const double distance = choices.between(40, 400), radius = choices.between(2, 0.8 * distance);
  const double bearing = choices.between(-pi, pi);
  const Point centre = distance * Point(std::cos(bearing), std::sin(bearing));
  if (corners % 4 == 0) {
    std::mt19937_64 random(static_cast<unsigned>(corners * 65536) + static_cast<unsigned>(100 * distance));
    return {test::grid_polygon_about(random, centre, radius).outer, {}};
  }
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double at = 2 * pi * i / corners, r = radius * choices.between(0.3, 1);
    ring.push_back(centre + r * Point(std::cos(at), std::sin(at)));
  }
  return {ring, {}};
}

PoleSpec pole_beside(Choices& choices) {
  const double reach = choices.between(5, 60);
  return {Region{{{{{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}}, {}}}}};
}

/// A bar of any direction or an outline on a grid, somewhere about the pole.
Obstacle obstacle(Choices& choices) {
  const double distance = choices.between(20, 300), bearing = choices.between(-pi, pi),
               turn = choices.between(-pi, pi);
  const Point centre = distance * Point(std::cos(bearing), std::sin(bearing));
  const Point along = choices.between(1, 60) * Point(std::cos(turn), std::sin(turn));
  const Point across = choices.between(0.5, 10) / along.norm() * Point(-along.y(), along.x());
  const int lowest = 1 + choices.upto(2);
  const auto grid = static_cast<unsigned>(100 * distance);
  if (grid % 2 == 0) {  // an outline on a grid, perhaps with holes
    std::mt19937_64 random(grid);
    return {test::grid_polygon_about(random, centre, along.norm()), lowest, lowest + choices.upto(3), {}};
  }
  return {
      {{centre - along - across, centre + along - across, centre + along + across, centre - along + across},
       {}},
      lowest,
      lowest + choices.upto(3),
      {}};
}

/// Many small obstacles round about, most of them out of any instrument's reach.
void add_crowd(Choices& choices, Spec& spec) {
  const int count = 20 + choices.upto(180);
  const double far = choices.between(500, 5000);
  std::mt19937_64 random(static_cast<unsigned>(count));
  const auto share = [&] { return test::share(random); };
  for (int i = 0; i < count; ++i) {
    const double distance = far * (0.5 + share()), bearing = 2 * pi * share();
    const Point at = distance * Point(std::cos(bearing), std::sin(bearing));
    spec.obstacles.push_back({{{at, at + Point(5, 0), at + Point(5, 5), at + Point(0, 5)}, {}}, 1, 2, {}});
  }
}

Objective objective(Choices& choices) {
  switch (choices.upto(8)) {
    case 0:
    case 1: return Objective::transmission;
    case 2: return Objective::copy_error;
    case 3: return Objective::footprint;
    default: return Objective::size;
  }
}

LinkSpec links(Choices& choices) {
  LinkSpec links;
  links.style.width = choices.between(2, 25);
  links.style.pin_diameter = links.style.width * choices.between(0.2, 1);
  links.style.plate = choices.upto(2) == 0 ? PlateStyle::bent : PlateStyle::triangle;
  links.layers = 2 + choices.upto(2);
  links.shortest = choices.between(1, 40);
  links.longest = choices.between(200, 2000);
  if (choices.upto(8) == 0) links.stock_lengths.grid = choices.between(0.5, 5);
  return links;
}

Limits limits(Choices& choices) {
  Limits limits;
  limits.transmission = choices.between(0, radians(50));
  limits.clearance = choices.between(0, 3);
  if (choices.upto(4) == 0) limits.copy_gap = choices.between(0, 20);
  return limits;
}

/// Mostly none at all; else anything from a press fit to a hole wider than the link.
CuttingSpec cutting(Choices& choices) {
  CuttingSpec cutting;
  if (choices.upto(3) == 1) cutting.hole_fit = choices.between(-0.5, 3);
  if (choices.upto(3) == 1) cutting.kerf = choices.between(0, 2);
  if (choices.upto(2) == 1) {
    const double width = choices.between(100, 1500);  // drawn one by one: arguments have no order
    cutting.stock_sheet = Point(width, choices.between(100, 800));
  }
  return cutting;
}

/// Mostly none; else a load that a limit holds, or that is the objective.
void add_load(Choices& choices, Spec& spec) {
  if (choices.upto(4) != 1) return;
  const auto materials = known_materials();
  spec.material =
      as_material(materials[static_cast<std::size_t>(choices.upto(static_cast<int>(materials.size())))]);
  spec.load = Load{std::exp(choices.between(std::log(0.1), std::log(100)))};
  const int asked = choices.upto(4);
  if (asked == 1) spec.objective.objective = Objective::load_error;
  if (asked == 2) spec.objective.objective = Objective::mass;
  if (asked != 1) spec.limits.load_error = std::exp(choices.between(std::log(0.001), std::log(10)));
  if (choices.upto(3) != 1) return;
  const LinkStyle& own = spec.links.style;
  spec.links.sections = {{own.width, own.thickness}, {1.5 * own.width, 1.5 * own.thickness}};
}

Spec spec_from(Choices& choices) {
  Spec spec;
  const double scale = std::exp(choices.between(std::log(0.1), std::log(10)));
  const double rotation = choices.upto(3) == 0 ? choices.upto(4) * pi / 2 : choices.between(-pi, pi);
  spec.copy = Copy::of(scale, rotation);
  if (std::abs(spec.copy.k() - 1.0) < 1e-3) spec.copy = Copy::of(2, rotation);
  spec.region.polygons.push_back(polygon(choices));
  spec.links = links(choices);
  spec.limits = limits(choices);
  if (choices.upto(3) == 0) spec.pole = pole_beside(choices);
  spec.objective.objective = objective(choices);
  if (spec.objective.objective == Objective::copy_error || choices.upto(4) == 0)
    spec.tolerance = Tolerance{choices.between(0.01, 0.2), choices.between(0, 0.1)};
  if (spec.tolerance && choices.upto(2) == 0) spec.limits.copy_error = choices.between(0.2, 3);
  const int obstacles = choices.upto(3) == 0 ? 1 + choices.upto(3) : 0;
  for (int i = 0; i < obstacles; ++i) spec.obstacles.push_back(obstacle(choices));
  if (choices.upto(6) == 0)
    spec.objective.groundings = {all_groundings[static_cast<std::size_t>(choices.upto(3))]};
  spec.cutting = cutting(choices);
  if (choices.upto(3) == 1) spec.links.wall = choices.between(0.01, 5);
  if (choices.upto(7) == 1) add_crowd(choices, spec);
  add_load(choices, spec);
  return spec;
}

void require(bool condition, const std::string& name, const std::string& what) {
  if (condition) return;
  std::fprintf(stderr, "%s: a design that was found does not hold: %s\n", name.c_str(), what.c_str());
  std::abort();
}

/// Every file of the design's folder, read again; the holes keep their wall, and only links without one beside their holes
/// go without parts.
void require_whole_files(const Spec& spec, const Design& design, const std::string& name) {
  std::vector<OutputFile> files;
  const auto left_out = make_design_package(design, spec.cutting, {},
                                            [&](const OutputFile& file) -> tl::expected<void, std::string> {
                                              files.push_back(file);
                                              return {};
                                            });
  require(left_out.has_value(), name, left_out ? "" : left_out.error());
  const auto faults = recheck(files, design, spec.cutting);
  require(faults.empty(), name, faults.empty() ? "" : faults.front());
  const double pin = spec.links.style.pin_diameter, hole = pin + spec.cutting.hole_fit;
  const double apart = std::max(pin, hole) + spec.links.wall.value_or(pin / 10);
  for (const double length : design.linkage.lengths().values())
    require(length >= apart * (1 - 1e-9), name, "two holes of a link are too near");
  const bool can_be_cut = design.style.width - hole > 0.002 * hole && hole - spec.cutting.kerf > 0.001 * hole;
  const auto solids = std::count_if(files.begin(), files.end(),
                                    [](const OutputFile& file) { return file.name.extension() == ".stl"; });
  require(solids == (can_be_cut ? 4 : 0), name, "the number of solids");
}

}  // namespace

Spec spec_from_choices(std::string_view input) {
  Choices choices(input);
  return spec_from(choices);
}

Outcome design_from_choices(std::string_view input, const std::string& name) {
  const Spec spec = spec_from_choices(input);
  SearchOptions options;
  options.diagnose = false;
  const SearchOutcome outcome = synthesize(spec, options);
  const auto* found = std::get_if<FoundDesign>(&outcome);
  if (found == nullptr) return Outcome::none;
  MapOptions map;
  map.largest_sheets = false;
  Design design = assemble_design(spec, *found, map);
  require(design.map.coverage.covered, name, "coverage: " + design.map.coverage.why_not);
  VerificationTask task = verification_task(design);
  task.shortest = spec.links.shortest;
  task.longest = spec.links.longest;
  design.verification = verify(task);
  require(design.verification.holds, name, design.verification.failure);
  const auto stored = read_design(design_json(design), name);
  require(stored.has_value(), name, stored ? "" : stored.error().message());
  const auto audited = audit(*stored, name);
  require(audited.has_value(), name, audited ? "" : audited.error().message());
  if (!audited->holds() && audited->broken[0].limit == "cutting.hole_fit_mm") return Outcome::none;
  require(audited->holds(), name,
          audited->holds() ? "" : audited->broken[0].limit + ": " + audited->broken[0].sentence);
  require_whole_files(spec, design, name);
  return Outcome::design;
}

}  // namespace kempe::fuzz
