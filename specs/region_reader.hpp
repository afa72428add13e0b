#pragma once
// The tables about places: [region], [pole], [[obstacles]], [[bodies]] and [table].

#include <filesystem>
#include <optional>
#include <vector>

#include "specs/spec.hpp"
#include "specs/text/complaints.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {

/// Reads a [region] table whose keys have been checked; files are looked for in `folder`.
std::optional<Region> read_region(const TableView& table, const std::filesystem::path& folder,
                                  Complaints& complaints);

/// Reads a [pole] table whose keys have been checked. Without it the pole is fixed at `natural`.
PoleSpec read_pole(const TableView& table, const Point& natural, Complaints& complaints);

/// Reads the [[obstacles]] tables, whose keys have been checked. An outline of several rings makes an
/// obstacle a ring; one that crosses itself falls apart into simple rings, which cover all that it winds
/// around (ring_loops.hpp) and may overlap. Zero area is refused.
std::vector<Obstacle> read_obstacles(const toml::array& tables, Complaints& complaints);

/// Reads the [[bodies]] tables in the same way; a circle stays one.
std::vector<Body> read_bodies(const toml::array& tables, Complaints& complaints);

/// Complains about bodies whose outlines meet obstacles, the table's edge and each other in more corners than can be dealt
/// with: a body is taken away from each of them, convex part by convex part.
void check_body_outlines(const Spec& spec, Complaints& complaints);

/// Those of the groundings in which every link that a body turns with has the body's point; none after a complaint about a link that has
/// it in none of those that the bodies before leave.
std::vector<Grounding> groundings_with_links_of(const toml::array& tables, std::vector<Grounding> groundings,
                                                Complaints& complaints);

/// Reads a [table] table whose keys have been checked: one ring that does not cross itself.
std::optional<Polygon> read_table_edge(const TableView& table, Complaints& complaints);

}  // namespace kempe
