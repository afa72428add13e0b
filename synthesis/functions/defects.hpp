#pragma once
// The defects of a function generator: branch defect, order defect and what else stands against a four-bar that passes the
// precision points.

#include <cstddef>
#include <string_view>

namespace kempe {

/// What stands against a candidate.
enum class FunctionDefect {
  none,
  does_not_assemble,  ///< the loop does not close over the whole range
  branch,             ///< the precision points lie on both branches
  order,         ///< the output crank passes the points in another order (it turns back within the range)
  transmission,  ///< the transmission angle falls below the limit
  lengths,       ///< a link vanishes or outgrows longest_ratio
  start          ///< a crank would have to start half a turn from the start given
};
inline constexpr std::size_t defect_kinds = 7;
std::string_view name(FunctionDefect defect);

}  // namespace kempe
