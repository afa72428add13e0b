#pragma once
// How the parts are cut: the hole fit, the kerf, the stock sheets.

#include <optional>
#include <string_view>

#include "kempe/export.hpp"
#include "kempe/point.hpp"

namespace kempe {

/// How holes are made.
enum class Process { laser, mill, print, drill };
/// "laser", "mill", "print" or "drill".
KEMPE_EXPORT std::string_view name(Process process);
/// The fit (mm) that lets a link turn on its pin where holes are made so (docs/hardware.md has the sources): laser 0.1, mill
/// 0.05, print 0.3, drill 0.1.
KEMPE_EXPORT double usual_fit(Process process);

/// How the parts are cut: what their drawings allow for.
struct CuttingSpec {
  std::optional<Process> process{};  ///< absent: not said
  double hole_fit = 0;               ///< mm, a hole's diameter less the pin's; negative for a press fit
  double kerf = 0;  ///< mm, >= 0, the width that the cut takes away; drawings compensate half on each side
  std::optional<Point> stock_sheet{};  ///< mm, width and height of a sheet; absent: parts are not nested
  double gap = 5;                      ///< mm, >= 0, between parts on a sheet and to its edge
};

}  // namespace kempe
