#pragma once
// One limit with a value, relaxed.

#include "synthesis/search/diagnosis/movable_limits.hpp"
#include "synthesis/search/diagnosis/relaxations.hpp"

namespace kempe {

/// The least change of a limit with which there is a design, and that design; nothing where not even its loosest value is
/// enough, or where it has that already.
std::optional<Relaxation> relaxed(Questions& questions, const MovableLimit& limit);

}  // namespace kempe
