#pragma once
// The tables about loads, [material] and [load], and the sections of [links]. Each function reads a table whose keys have been checked.

#include <optional>
#include <vector>

#include "specs/spec.hpp"
#include "specs/text/complaints.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {

/// The material of that name (materials.hpp), with what else the table says of it in place of the name's own.
std::optional<Material> read_material(const TableView& table, Complaints& complaints);
std::optional<Load> read_load(const TableView& table);
/// `links.sections_mm` as LinkSpec::sections wants them; empty if it is absent.
std::vector<LinkSection> read_sections(const TableView& links);

/// What loads, limits and objective need of each other and of the material.
void check_loads(const Spec& spec, const toml::table& root, Complaints& complaints);

}  // namespace kempe
