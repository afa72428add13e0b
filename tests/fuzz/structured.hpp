#pragma once
// Random specs that are valid by construction, from the bytes of a fuzzer.

#include <string_view>

namespace kempe::fuzz {

/// Reads the bytes as choices, makes a spec of them, and designs, maps and verifies it. Aborts if a design that was found
/// fails its verification or breaks a limit of its spec.
void design_from_choices(std::string_view input);

}  // namespace kempe::fuzz
