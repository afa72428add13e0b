#pragma once
// The specs of some jobs to start from, as `kempe init` lists and writes them.

#include <span>
#include <string_view>

#include "kempe/export.hpp"

namespace kempe {

/// A spec of a job, with notes.
struct SpecTemplate {
  std::string_view name;     ///< "sign-router"
  std::string_view purpose;  ///< what it is for, a line: its first note
  std::string_view spec;     ///< TOML (docs/spec.md)
};

/// All of them, in the order in which they are listed.
KEMPE_EXPORT std::span<const SpecTemplate> spec_templates();

}  // namespace kempe
