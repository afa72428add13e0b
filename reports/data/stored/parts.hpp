#pragma once
// The parts of a stored design (docs/design-file.md), each read into it. For the sources of its reader only.

#include "reports/data/design_json.hpp"
#include "reports/data/json_fields.hpp"

namespace kempe::stored {

/// `mechanism`: links and plates, joints, lengths, opening.
void read_mechanism(const JsonField& field, StoredDesign& design);
/// `copy`.
void read_copy(const JsonField& field, StoredDesign& design);

/// What the file claims, not yet believed: `quality`, `workspace`, `verification`.
void read_claims(const JsonField& root, StoredDesign& design);
/// The same of the search: `tool`, `search`.
void read_search(const JsonField& root, StoredDesign& design);

/// What the spec asked for, as far as the file says it: `title`, `limits`, `tolerance`, `material`, `load`, `obstacles`, `bodies`,
/// `table`, `cutting`.
void read_task(const JsonField& root, StoredDesign& design);
/// `pole`, `links` and `objective` come together: what the spec of a searched design allows.
void read_allowed(const JsonField& root, StoredDesign& design);

/// Notes which tables of the top level stand in the file, and what of it this version does not know.
void note_keys(const JsonField& root, StoredDesign& design);

}  // namespace kempe::stored
