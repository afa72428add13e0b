#pragma once
// Random specs that are valid by construction, from the bytes of a fuzzer.

#include <string>
#include <string_view>

#include "specs/spec.hpp"

namespace kempe::fuzz {

/// Reads the bytes as choices, two each (zeros once they are used up; 200 suffice), and makes a spec of them: any ratio,
/// region, links, limits, objective, cutting, with or without obstacles and tolerances.
Spec spec_from_choices(std::string_view input);

enum class Outcome { design, none };

/// Designs, maps and verifies the spec of the bytes, makes all its files and reads them again. Aborts if a design that was
/// found fails its verification, breaks a limit of its spec or has files that are not whole, with a message that begins with
/// `name`.
Outcome design_from_choices(std::string_view input, const std::string& name = "fuzzed spec");

}  // namespace kempe::fuzz
