#include "specs/spec_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/regions/region_checks.hpp"
#include "kempe/links.hpp"

namespace kempe {
namespace {

constexpr KeyRange any{};
constexpr KeyRange from(double lower, double upper) { return {lower, upper, false, false}; }
constexpr KeyRange above(double lower, double upper) { return {lower, upper, true, false}; }
constexpr KeyRange from_to_below(double lower, double upper) { return {lower, upper, false, true}; }

constexpr KeyRange coordinate = from(-largest_coordinate, largest_coordinate);
constexpr KeyRange length = above(0, 1e6);
constexpr KeyRange layer = from(1, most_layers);
constexpr bool required = true, optional = false;

using enum KeyKind;

constexpr SpecKey keys[] = {
    {"", "title", text, any, "", optional, "", "\"Router for the shop sign\"",
     "heads report and drawings: one line of at most 200 bytes"},
    {"", "units", choice, any, "mm|in", optional, "\"mm\"", "\"in\"",
     "the unit of all lengths: with \"in\" every key that ends in _mm ends in _in instead"},

    {"copy", "scale", ratio, above(0, 1e4), "", optional, "1", "1.4",
     "pen-side length over tracer-side length"},
    {"copy", "rotation_deg", number, from(-3600, 3600), "", optional, "0", "90",
     "the copy's turn against the original, counter-clockwise"},
    {"copy", "pairs_mm", pairs, coordinate, "", optional, "", "[[[75, 0], [0, 105]], [[56, 0], [0, 78.4]]]",
     "instead of scale and rotation: points of the original, each with its point of the copy"},

    {"region", "polygon_mm", rings, coordinate, "", optional, "", "[[62, -5], [70, -5], [70, 5], [62, 5]]",
     "what the tracer must cover: a ring, or several"},
    {"region", "holes_mm", rings, coordinate, "", optional, "", "[[[65, -1], [66, -1], [66, 1]]]",
     "rings inside that need not be covered"},
    {"region", "rectangle_mm", rectangle, any, "", optional, "", "{at = [62, -5], size = [8, 10]}",
     "an upright rectangle instead"},
    {"region", "circle_mm", circle, any, "", optional, "", "{centre = [50, 50], radius = 10}",
     "a circle instead"},
    {"region", "file", text, any, "", optional, "", "\"drawing.svg\"",
     "a drawing instead: .svg, .dxf or .geojson, beside the spec"},
    {"region", "margin_mm", number, from(0, 1e4), "", optional, "0", "2",
     "the region grows by this all around"},
    {"region", "cover", choice, any, "hull|outline|strokes", optional, "\"hull\"", "\"strokes\"",
     "of a .svg or .dxf drawing: its convex hull, what its outlines enclose, or its strokes grown by "
     "margin_mm"},
    {"region", "units", choice, any, "mm|cm|m|inch|foot", optional, "", "\"inch\"",
     "of a .dxf drawing that does not say its units, or says them wrongly"},

    {"pole", "at_mm", point, coordinate, "", optional, "[0, 0]", "[0, 0]", "the pole's place"},
    {"pole", "within_mm", rings, coordinate, "", optional, "",
     "[[-150, 320], [150, 320], [150, 420], [-150, 420]]", "instead: the area in which the pole may stand"},

    {"links", "width_mm", number, above(0, 1000), "", optional, "12", "15", "width of every link"},
    {"links", "pin_diameter_mm", number, above(0, 1000), "", optional, "6", "8",
     "diameter of pins and posts, at most the width"},
    {"links", "thickness_mm", number, above(0, 1000), "", optional, "4", "5", "thickness of every link"},
    {"links", "sections_mm", sections, above(0, 1000), "", optional, "", "[[15, 5], [20, 5]]",
     "width and thickness to choose from, all links alike, instead of width_mm and thickness_mm"},
    {"links", "hardware", joint_choices, any,
     "M3 bolt|M4 bolt|M5 bolt|M6 bolt|M8 bolt|M10 bolt|M12 bolt|M6 shoulder bolt|"
     "M8 shoulder bolt|M12 shoulder bolt|623 bearing|624 bearing|625 bearing|"
     "626 bearing|608 bearing|6000 bearing|3 mm dowel|4 mm dowel|5 mm dowel|"
     "6 mm dowel|8 mm dowel|10 mm dowel|3 mm dowel and bush|4 mm dowel and bush|"
     "5 mm dowel and bush|6 mm dowel and bush|8 mm dowel and bush|10 mm dowel and bush",
     optional, "", "\"M6 shoulder bolt\"",
     "what the joints are made of, all alike or each by its letter: gives the pins' diameters, the holes and "
     "the shopping list; left out: plain pins"},
    {"links", "plate", choice, any, "bent|triangle", optional, "\"bent\"", "\"triangle\"",
     "shape of the two links with three joints"},
    {"links", "layers", whole_number, from(2, most_layers), "", optional, "2", "4",
     "layers to build in, at most; some may stay empty"},
    {"links", "shortest_mm", number, length, "", optional, "15", "30",
     "least distance of two joints of a link"},
    {"links", "longest_mm", number, length, "", optional, "400", "600",
     "largest distance of two joints of a link"},
    {"links", "wall_mm", number, above(0, 1000), "", optional, "", "2",
     "least wall between two holes of a link; left out: a tenth of the pin's diameter"},
    {"links", "grid_mm", number, length, "", optional, "", "5", "lengths are whole multiples of this"},
    {"links", "stock_mm", numbers, length, "", optional, "", "[100, 150, 200]",
     "lengths are taken from this list"},
    {"links", "VA_mm", number, length, "", optional, "", "120", "locks the length VA"},
    {"links", "VB_mm", number, length, "", optional, "", "80", "locks the length VB"},
    {"links", "AC_mm", number, length, "", optional, "", "80", "locks the length AC"},
    {"links", "BC_mm", number, length, "", optional, "", "120", "locks the length BC"},
    {"links", "AX_mm", number, length, "", optional, "", "60", "locks the length AX"},
    {"links", "CX_mm", number, length, "", optional, "", "100", "locks the length CX"},
    {"links", "BY_mm", number, length, "", optional, "", "140", "locks the length BY"},
    {"links", "CY_mm", number, length, "", optional, "", "160", "locks the length CY"},

    {"limits", "clearance_mm", number, from(0, 1000), "", optional, "0.5", "1",
     "least gap between parts that may not touch"},
    {"limits", "transmission_deg", number, from_to_below(0, 90), "", optional, "30", "25",
     "least transmission angle over the region"},
    {"limits", "sheets_gap_mm", number, from(0, 1e5), "", optional, "", "5",
     "least distance of the original from its copy; 0: they may touch but not overlap; left out: they may "
     "overlap"},
    {"limits", "copy_error_mm", number, above(0, 1000), "", optional, "", "0.3",
     "largest copy error under [tolerance], worst case; left out: not limited"},
    {"limits", "longest_strip_mm", number, length, "", optional, "", "415",
     "largest length of a link over its ends: the strip that is at hand; left out: not limited"},
    {"limits", "load_error_mm", number, above(0, 1000), "", optional, "", "0.1",
     "most that the pen may give way under [load], in its worst direction in the plane; left out: not "
     "limited"},
    {"limits", "load_error_in_all", truth, any, "", optional, "false", "true",
     "pins, layers and the links' own weight count towards load_error_mm too; false: the links alone do"},
    {"limits", "sag_mm", number, above(0, 1000), "", optional, "", "0.5",
     "most that tracer or pen may sink by weight and play; left out: not limited"},

    {"tolerance", "length_mm", number, from(0, 10), "", optional, "0", "0.05",
     "tolerance of every length, plus or minus"},
    {"tolerance", "play_mm", number, from(0, 10), "", optional, "0", "0.02", "play of every pin"},
    {"tolerance", "robust", truth, any, "", optional, "false", "true",
     "every instrument within the tolerances must cover the region and keep the clearance"},

    {"tool", "follower_radius_mm", number, from(0, 1000), "", optional, "", "3",
     "radius of the follower at the tracer"},
    {"tool", "cutter_radius_mm", number, from(0, 1000), "", optional, "", "1.5",
     "radius of the cutter at the pen"},

    {"material", "name", text, any, "", optional, "", "\"steel\"",
     "one that is known by its name (docs/loads.md), or what to call one that the other keys describe"},
    {"material", "E_GPa", number, above(0, 1e4), "", optional, "", "200",
     "modulus of elasticity; left out: that of the name"},
    {"material", "density_kg_m3", number, above(0, 1e5), "", optional, "", "7850",
     "density; left out: that of the name"},
    {"material", "strength_MPa", number, above(0, 1e5), "", optional, "", "235",
     "stress that it bears in bending; left out: that of the name"},
    {"material", "G_GPa", number, above(0, 1e4), "", optional, "", "77",
     "shear modulus; left out: that of the name, else E_GPa / 2.6"},

    {"load", "pen_N", number, above(0, 1e6), "", required, "", "10",
     "force at the pen, in any direction in the plane"},
    {"load", "rests", choices, any, "tracer|pen", optional, "", "[\"tracer\", \"pen\"]",
     "what the table carries besides the pole's post; left out: nothing"},
    {"load", "pen_mass_kg", number, from(0, 1e4), "", optional, "0", "3",
     "mass that the pen carries: a router"},
    {"load", "tracer_mass_kg", number, from(0, 1e4), "", optional, "0", "0.2",
     "mass that the tracer carries"},
    {"load", "tilt_deg", number, from(0, 90), "", optional, "0", "90",
     "how steep the table stands: 0 lies, 90 is upright, with y uphill"},
    {"load", "grip_mm", number, above(0, 1000), "", optional, "", "20",
     "length over which a pin is held in the link that turns on it; left out: the links' thickness"},
    {"load", "friction", number, from(0, 2), "", optional, "0.15", "0.2",
     "coefficient of friction in the pins"},

    {"obstacles", "name", text, any, "", optional, "", "\"vice\"",
     "what the report calls it; left out: obstacle 1, 2, ..."},
    {"obstacles", "polygon_mm", rings, coordinate, "", optional, "",
     "[[0, 100], [40, 100], [40, 120], [0, 120]]", "its outline: a ring, or several"},
    {"obstacles", "rectangle_mm", rectangle, any, "", optional, "", "{at = [0, 100], size = [40, 20]}",
     "an upright rectangle instead"},
    {"obstacles", "circle_mm", circle, any, "", optional, "", "{centre = [20, 110], radius = 8}",
     "a circle instead"},
    {"obstacles", "layers", layer_range, layer, "", optional, "[1, 8]", "[1, 4]",
     "the layers it stands in, lowest and highest; 1 is next to the table"},

    {"bodies", "name", text, any, "", optional, "", "\"router\"",
     "what the report calls it; left out: body 1, 2, ..."},
    {"bodies", "at", choice, any, "tracer|pen", required, "", "\"pen\"", "the point that carries it"},
    {"bodies", "turns_with", choice, any, "VA|VB|ACX|BCY", optional, "", "\"BCY\"",
     "the link it is fixed to, one that has the point: its x axis runs from there to the link's nearest "
     "other joint; "
     "left out: it keeps its direction"},
    {"bodies", "polygon_mm", rings, coordinate, "", optional, "",
     "[[-40, -30], [40, -30], [40, 30], [-40, 30]]",
     "its outline seen from that point, along the table's axes or the link's: a ring, or several"},
    {"bodies", "rectangle_mm", rectangle, any, "", optional, "", "{at = [-40, -30], size = [80, 60]}",
     "an upright rectangle instead"},
    {"bodies", "circle_mm", circle, any, "", optional, "", "{centre = [0, 0], radius = 60}",
     "a circle instead"},
    {"bodies", "layers", layer_range, layer, "", optional, "[1, 8]", "[3, 8]",
     "the layers it takes, lowest and highest; 1 is next to the table"},

    {"table", "polygon_mm", rings, coordinate, "", optional, "", "[[0, 0], [600, 0], [600, 400], [0, 400]]",
     "the table's edge, a ring: links, pins, posts and bodies stay on it"},
    {"table", "rectangle_mm", rectangle, any, "", optional, "", "{at = [0, 0], size = [600, 400]}",
     "an upright rectangle instead"},
    {"table", "circle_mm", circle, any, "", optional, "", "{centre = [0, 0], radius = 500}",
     "a circle instead"},

    {"objective", "minimize", choice, any, "size|copy_error|footprint|load_error|mass", optional, "\"size\"",
     "\"footprint\"", "what is made small"},
    {"objective", "maximize", choice, any, "transmission", optional, "", "\"transmission\"",
     "what is made large instead"},
    {"objective", "groundings", choices, any, "pole|tracer|pen", optional, "[\"pole\", \"tracer\", \"pen\"]",
     "[\"pole\", \"pen\"]", "which points may stand at the parallelogram's vertex V"},

    {"mechanism", "vertex", choice, any, "pole|tracer|pen", required, "", "\"pole\"",
     "which point stands at V"},
    {"mechanism", "VA_mm", number, length, "", required, "", "50", "length of the bar VA"},
    {"mechanism", "VB_mm", number, length, "", required, "", "35", "length of the bar VB"},
    {"mechanism", "assembly", whole_number, from(0, 3), "", optional, "0", "2",
     "which usable interval of the opening, numbered from 0 upward from -180 degrees"},
    {"mechanism", "layers", link_layers, layer, "", optional, "", "[1, 2, 2, 1]",
     "layers of VA, VB, ACX, BCY; left out: the best are sought"},

    {"cutting", "process", choice, any, "laser|mill|print|drill", optional, "", "\"laser\"",
     "how holes are made: its usual fit stands in for hole_fit_mm"},
    {"cutting", "hole_fit_mm", number, from(-1, 10), "", optional, "", "0.1",
     "a hole's diameter less the pin's; left out: that of the process, or 0"},
    {"cutting", "kerf_mm", number, from(0, 10), "", optional, "0", "0.2", "width that the cut takes away"},
    {"cutting", "sheet_mm", point, above(0, 1e5), "", optional, "", "[600, 300]",
     "width and height of the sheet to nest the parts on; left out: not nested"},
    {"cutting", "gap_mm", number, from(0, 1000), "", optional, "5", "8",
     "gap between parts on the sheet and to its edge"},

    {"rectangle_mm", "at", point, coordinate, "", required, "", "[62, -5]", "the lower left corner"},
    {"rectangle_mm", "size", point, above(0, 2 * largest_coordinate), "", required, "", "[8, 10]",
     "width and height"},
    {"circle_mm", "centre", point, coordinate, "", required, "", "[50, 50]", "the centre"},
    {"circle_mm", "radius", number, above(0, largest_coordinate), "", required, "", "10", "the radius"},
};

constexpr std::array<std::string_view, 15> tables{
    "copy", "region",    "pole",   "links", "limits",    "tolerance", "tool",   "material",
    "load", "obstacles", "bodies", "table", "objective", "mechanism", "cutting"};

constexpr double mm_per_inch = 25.4;

/// What names of keys that are no lengths may end in, and the unit in words.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> suffixes{
    {{"_deg", "degrees"}, {"_N", "N"}, {"_kg", "kg"}, {"_GPa", "GPa"}, {"_MPa", "MPa"}, {"_kg_m3", "kg/m3"}}};

std::pair<std::string_view, std::string_view> unit_suffix(std::string_view name) {
  const auto* found = std::find_if(suffixes.begin(), suffixes.end(),
                                   [&](const auto& each) { return name.ends_with(each.first); });
  return found == suffixes.end() ? std::pair<std::string_view, std::string_view>{} : *found;
}

/// " mm", " degrees", " N", ... or nothing.
std::string unit_words(const SpecKey& key, SpecUnit unit) {
  if (is_length(key)) return fmt::format(" {}", name(unit));
  const auto [suffix, words] = unit_suffix(key.name);
  return suffix.empty() ? "" : fmt::format(" {}", words);
}

}  // namespace

bool KeyRange::contains(double value) const {
  return (without_lower ? value > lower : value >= lower) && (without_upper ? value < upper : value <= upper);
}

std::string KeyRange::describe(double share) const {
  const auto end = [share](double value) {
    return share == 1 ? fmt::format("{}", value) : fmt::format("{:.6g}", share * value);
  };
  return fmt::format("{} {} and {} {}", without_lower ? ">" : ">=", end(lower),
                     without_upper ? "<" : "<=", end(upper));
}

double in_mm(SpecUnit unit) { return unit == SpecUnit::inch ? mm_per_inch : 1; }
std::string_view name(SpecUnit unit) { return unit == SpecUnit::inch ? "in" : "mm"; }

bool is_length(const SpecKey& key) {
  return key.name.ends_with("_mm") || key.table == "rectangle_mm" || key.table == "circle_mm";
}

std::span<const SpecKey> spec_keys() { return keys; }
std::span<const std::string_view> spec_tables() { return tables; }

const SpecKey* find_spec_key(std::string_view table, std::string_view name) {
  const auto found = std::find_if(std::begin(keys), std::end(keys),
                                  [&](const SpecKey& key) { return key.table == table && key.name == name; });
  return found == std::end(keys) ? nullptr : found;
}

std::vector<std::string_view> words_of(const SpecKey& key) {
  std::vector<std::string_view> words;
  std::string_view rest = key.words;
  while (!rest.empty()) {
    const std::size_t bar = std::min(rest.find('|'), rest.size());
    words.push_back(rest.substr(0, bar));
    rest.remove_prefix(std::min(bar + 1, rest.size()));
  }
  return words;
}

std::string describe_allowed(const SpecKey& key, SpecUnit in_unit) {
  const std::string range = key.range.describe(is_length(key) ? 1 / in_mm(in_unit) : 1);
  const std::string words = fmt::format("\"{}\"", fmt::join(words_of(key), "\", \""));
  const std::string unit = unit_words(key, in_unit);
  switch (key.kind) {
    case number: return fmt::format("a number {}{}", range, unit);
    case ratio:
      return fmt::format(
          "a number {}, or two as text: \"1:3\"; scale -c is scale c with 180 degrees more rotation", range);
    case whole_number: return fmt::format("a whole number {}", range);
    case truth: return "true or false";
    case choice: return "one of " + words;
    case choices: return fmt::format("a list of one or more of {}, each once", words);
    case joint_choices:
      return fmt::format("one of {}, or a table of these by joint: {{default = ..., V = ..., A = ...}}",
                         words);
    case text: return "text between quotation marks";
    case numbers: return fmt::format("a list of numbers {}{}", range, unit);
    case point: return fmt::format("[x, y], numbers {}{}", range, unit);
    case sections:
      return fmt::format("[[width, thickness], ...], 1 to {}, numbers {}{}", most_sections, range, unit);
    case layer_range: return fmt::format("[lowest, highest], whole numbers {}", range);
    case link_layers: return fmt::format("the layers of [VA, VB, ACX, BCY], whole numbers {}", range);
    case rings:
      return fmt::format("a ring [[x, y], [x, y], [x, y], ...] or a list of rings, numbers {}{}", range,
                         unit);
    case rectangle:
      return fmt::format("{{at = [x, y], size = [width, height]}} or [x, y, width, height], {}",
                         name(in_unit));
    case circle: return fmt::format("{{centre = [x, y], radius = r}} or [x, y, radius], {}", name(in_unit));
    case pairs:
      return fmt::format("[[[x, y], [x, y]], ...]: tracer and pen, at least two pairs, numbers {}{}", range,
                         unit);
  }
  return "";
}

}  // namespace kempe
