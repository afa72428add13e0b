#include "specs/linkages/keys.hpp"

namespace kempe {
namespace {

constexpr LinkageKey known_keys[] = {
    {"", "name", "text"},
    {"", "unit", "\"mm\", \"cm\", \"m\" or \"in\""},
    {"", "points", "a list of names of points that belong to no link"},
    {"", "ground", "a table [ground] of points"},
    {"", "links", "a table [links]"},
    {"", "bars", "a table [bars] of lengths"},
    {"", "sliders", "tables [[sliders]]"},
    {"", "angles", "tables [[angles]]"},
    {"", "gears", "tables [[gears]]"},
    {"", "racks", "tables [[racks]]"},
    {"", "drivers", "tables [[drivers]]"},
    {"", "gravity", "[x, y] in m/s^2"},
    {"", "forces", "tables [[forces]]"},
    {"", "moments", "tables [[moments]]"},
    {"", "masses", "a table [masses]"},
    {"", "motion", "a table [motion]"},
    {"", "guess", "a table [guess] of points"},
    {"", "bounds", "a table [bounds]"},
    {"", "output", "a table [output]"},

    {"ground", "*", "a place [x, y]"},

    {"links.*", "joints", "a list of at least two different points"},
    {"links.*", "at", "a table of points of the link's own frame, such as {A = [0, 0], B = [3, 0]}"},
    {"links.*", "along", "rising distances of the joints from the first, which is 0, on a straight link"},
    {"links.*", "side", "\"left\" or \"right\": of the line from the first joint to the second"},
    {"links.*", "A-B", "the distance of two joints, > 0"},
    {"links.*", "A-B-C_deg", "the angle at the middle joint from the first arm to the second"},

    {"bars", "*", "the distance of two points, > 0, under a key such as A-B"},

    {"sliders", "point", "a point"},
    {"sliders", "link", "a link: it slides without turning"},
    {"sliders", "on", "a link or \"ground\""},
    {"sliders", "through", "a point of that link, or its place [x, y] in the link's frame"},
    {"sliders", "direction_deg", "the line's direction in the link's frame"},
    {"sliders", "towards", "a second point of that link on the line"},

    {"angles", "from", "a link or \"ground\""},
    {"angles", "to", "a link"},
    {"angles", "angle_deg", "the angle from the one to the other"},

    {"gears", "wheels", "two links"},
    {"gears", "carrier", "the link that holds both centres; \"ground\" if left out"},
    {"gears", "radii", "two radii, > 0"},
    {"gears", "teeth", "two whole numbers of teeth, > 0"},
    {"gears", "inner", "true if the second wheel has inner teeth"},
    {"gears", "mesh_deg", "two angles of the wheels against the carrier in which they mesh"},

    {"racks", "pinion", "a link"},
    {"racks", "centre", "a point of the pinion"},
    {"racks", "on", "the link that carries the rack, or \"ground\""},
    {"racks", "through", "a point of that link, or its place [x, y] in the link's frame"},
    {"racks", "direction_deg", "the rack's direction in the link's frame"},
    {"racks", "towards", "a second point of that link on the rack's line"},
    {"racks", "radius", "the pinion's radius, > 0"},
    {"racks", "side", "\"left\" or \"right\": where the pinion lies, seen along the rack's direction"},
    {"racks", "opposite_deg",
     "the pinion's angle against the rack when its centre stands opposite `through`"},

    {"drivers", "coordinate", "a coordinate such as \"P.x\""},
    {"drivers", "angle", "a link"},
    {"drivers", "relative_to", "a link or \"ground\""},
    {"drivers", "distance", "two points"},
    {"drivers", "slide", "the point or link of a slider"},
    {"drivers", "path", "a point"},
    {"drivers", "from", "a length"},
    {"drivers", "to", "a length"},
    {"drivers", "from_deg", "an angle"},
    {"drivers", "to_deg", "an angle"},
    {"drivers", "rate", "a speed in units a second"},
    {"drivers", "rate_deg", "an angular speed in degrees a second"},
    {"drivers", "polyline", "a list of at least two places [x, y]"},
    {"drivers", "circle", "a table such as {centre = [5, 5], radius = 1}"},
    {"drivers", "svg", "SVG path data, y upward"},
    {"drivers.circle", "centre", "a place [x, y]"},
    {"drivers.circle", "radius", "a length, > 0"},
    {"drivers.circle", "from_deg", "an angle"},
    {"drivers.circle", "sweep_deg", "an angle, not 0, at most 100 turns"},

    {"forces", "at", "a point"},
    {"forces", "link", "a link that holds the point"},
    {"forces", "newton", "[x, y] of a force at a point, a number of one between two points"},
    {"forces", "turns_with", "a link, or \"ground\""},
    {"forces", "between", "two different points"},

    {"moments", "on", "a link"},
    {"moments", "against", "a link or \"ground\""},
    {"moments", "newton_m", "a moment in N m, counter-clockwise positive"},

    {"masses", "*", "a table such as {kg = 2, at = [0.1, 0], kg_m2 = 0.03} of a link or {kg = 2} of a point"},
    {"masses.*", "kg", "a mass, > 0"},
    {"masses.*", "at", "the centre of mass: a point of the link, or [x, y] in its frame"},
    {"masses.*", "kg_m2", "the moment of inertia about the centre of mass, >= 0"},

    {"motion", "steps", "a whole number, 1 to 1000000, and 10000000 over the number of links"},
    {"motion", "duration_s", "seconds, at least 1e-6"},

    {"guess", "*", "a place [x, y]"},
    {"bounds", "*", "a table such as {x = [0, 1], y = [0, 2]} of a point or {angle_deg = [0, 90]} of a link"},
    {"bounds.*", "x", "two rising numbers"},
    {"bounds.*", "y", "two rising numbers"},
    {"bounds.*", "angle_deg", "two rising angles"},

    {"output", "points", "a list of points"},
    {"output", "velocities", "true or false"},
    {"output", "accelerations", "true or false"},
    {"output", "angles", "a list of links"},
    {"output", "transmission", "a list of three points each, the angle being at the middle one"},
    {"output", "trace", "a list of points"},
    {"output", "reactions", "true or false"},
};

}  // namespace

std::span<const LinkageKey> linkage_keys() { return known_keys; }

const LinkageKey* find_linkage_key(std::string_view table, std::string_view name) {
  for (const LinkageKey& key : known_keys)
    if (key.table == table && (key.name == name || key.name == "*")) return &key;
  return nullptr;
}

std::vector<std::string_view> linkage_key_names(std::string_view table) {
  std::vector<std::string_view> names;
  for (const LinkageKey& key : known_keys)
    if (key.table == table) names.push_back(key.name);
  return names;
}

}  // namespace kempe
