#pragma once
// Specs filled in a program, held to the reader's rules by the reader's own checks.

#include <string>
#include <tl/expected.hpp>

#include "kempe/input_error.hpp"
#include "kempe/spec.hpp"

namespace kempe {

/// The spec with its regions as the reader would have them: rings the right way round, overlaps united, obstacles in simple
/// rings. All numbers stay as they are to the last bit. The error is that of a file that says the same, without file and
/// line.
tl::expected<Spec, InputError> check_spec(const Spec& spec);

/// The spec as a file would say it, without what is as it would be unsaid.
std::string spec_as_toml(const Spec& spec);

}  // namespace kempe
