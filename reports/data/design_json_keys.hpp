#pragma once
// The keys of design.json (docs/design-file.md). For the sources of its reader only.

#include "reports/data/design_json.hpp"
#include "reports/data/json_fields.hpp"

namespace kempe {

/// Notes which tables of the top level stand in the file, and what of it this version does not know.
void note_keys(const JsonField& root, StoredDesign& design);

}  // namespace kempe
