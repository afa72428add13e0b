#pragma once
// Small charts of the report as inline SVG.

#include <string>

#include "reports/html_report.hpp"

namespace kempe {

/// A bar of `share` (0..1) of its cell.
std::string share_bar(double share);
/// Copy error over the opening: worst case, typical, distortion. Empty without rows.
std::string copy_error_chart(const std::vector<CopyErrorRow>& rows);
/// The front between two objectives, this design marked.
std::string pareto_chart(const ParetoFront& front);

}  // namespace kempe
