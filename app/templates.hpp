#pragma once
// The specs that kempe init starts from: the files of specs/templates/, compiled in.

#include <span>
#include <string_view>

namespace kempe::app {

/// A commented spec of a job.
struct Template {
  std::string_view name;  ///< "sign-router"
  std::string_view spec;  ///< TOML; its first line is a note that says what it is for
};

/// All of them, in the order in which they are listed.
std::span<const Template> spec_templates();

/// What a template is for, in a line: its first note.
std::string_view purpose(const Template& one);

}  // namespace kempe::app
