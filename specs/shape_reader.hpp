#pragma once
// Shapes in a table of the spec: rings, rectangles, circles.

#include <optional>
#include <string_view>
#include <vector>

#include "geometry/region.hpp"
#include "kempe/spec.hpp"
#include "specs/text/complaints.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {

/// The rings of a key that holds one ring or a list of rings; an absent key holds none. Nothing comes back
/// after a complaint.
std::optional<std::vector<Ring>> read_rings(const TableView& table, std::string_view key,
                                            Complaints& complaints);

/// The one of `keys` that the table has; a complaint and nothing if it has none of them or several.
std::optional<std::string_view> exactly_one_of(const TableView& table,
                                               const std::vector<std::string_view>& keys,
                                               Complaints& complaints);

/// The disc of circle_mm, in either of its forms; a radius of 0 if the key is not there.
Disc read_disc(const TableView& table);

/// The ring of rectangle_mm or circle_mm, whichever `key` is.
Ring read_figure(const TableView& table, std::string_view key);

/// The region of a key of rings, rectangle_mm or circle_mm, whichever `key` is, without holes_mm if there is
/// such a key. Polygons that overlap or touch are united.
std::optional<Region> read_shape(const TableView& table, std::string_view key, Complaints& complaints);

}  // namespace kempe
