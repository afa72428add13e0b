#pragma once
// The tables about the instrument itself: [links], [limits], [tolerance], [tool], [objective], [mechanism],
// [cutting]; those about its loads are read by load_reader.hpp. Each function reads a table whose keys have been checked, or gives the defaults if it is absent,
// and checks what concerns several of its keys.

#include <optional>

#include "specs/spec.hpp"
#include "specs/text/complaints.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {

LinkSpec read_links(const TableView& table, Complaints& complaints);
Limits read_limits(const TableView& table);
std::optional<Tolerance> read_tolerance(const TableView& table);
ToolSpec read_tool(const TableView& table);
ObjectiveSpec read_objective(const TableView& table, Complaints& complaints);
CuttingSpec read_cutting(const TableView& table);

/// Checked against the copy ratio (the number of assembly modes) and against the layers that [links] allows, too.
std::optional<MechanismSpec> read_mechanism(const TableView& table, const Copy& copy, int layers,
                                            Complaints& complaints);

}  // namespace kempe
