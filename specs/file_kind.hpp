#pragma once
// Which of the program's files a text is, so that one given to the wrong command is told the right one.

#include <optional>
#include <string>
#include <string_view>

#include "kempe/input_error.hpp"

namespace kempe {

/// The files that commands read.
enum class FileKind {
  spec,          ///< of a copying linkage (docs/spec.md)
  json_spec,     ///< the same as JSON, as batches take it
  sweep,         ///< specs by axes, of a batch (docs/batch.md)
  linkage,       ///< any planar linkage (docs/linkage-file.md)
  measurements,  ///< of a real instrument (docs/calibration.md)
  function,      ///< of a function generator (docs/function-generator.md)
  inversor,      ///< of an inversor (docs/inversor.md)
  path,          ///< of a path generator (docs/path.md)
  design,        ///< design.json (docs/design-file.md)
  drawing        ///< SVG, DXF or GeoJSON
};

/// What a text is by its first characters or the names of its tables, sound or not; nothing if it is none of them for certain.
std::optional<FileKind> recognised_kind(std::string_view text);

/// The faults of a text that was read as a file of kind `expected`; of a text of another kind instead one fault, which says what
/// the file is and which command takes it.
InputError or_other_kind(InputError faults, std::string_view text, FileKind expected);

}  // namespace kempe
