#pragma once
// What a spec allows beside its limits, back in a spec.

#include "synthesis/design/design.hpp"

namespace kempe {

/// What the spec allows beside its limits becomes this; all else stays. The way back is allowed_by().
void allow(Spec& spec, const Allowed& allowed);

}  // namespace kempe
