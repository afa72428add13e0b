#pragma once
// Whether interval arithmetic holds on this machine.

namespace kempe::studio {

/// True if quotients, sums and roots that no double holds lie strictly between the ends of their intervals. Where the rounding
/// mode cannot be changed and nobody has thought of it, intervals have no width: then nothing may be called proven.
bool intervals_hold();

}  // namespace kempe::studio
