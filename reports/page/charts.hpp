#pragma once
// Small charts of the report as inline SVG.

#include <string>

#include "reports/page/html_report.hpp"

namespace kempe {

/// A bar of `share` (0..1) of its cell.
std::string share_bar(double share);
/// The copy error over the opening, rad and mm.
struct CopyErrorChart {
  struct Row {
    double opening, worst, rss;
  };
  std::vector<Row> rows;        ///< in the order of the opening; at least two, else nothing is drawn
  OpeningInterval used;         ///< the openings at which the region is traced
  std::optional<double> limit;  ///< of the worst case, mm
  std::string title = "Copy error over the opening", y_name = "copy error, mm";
  std::string worst_name = "worst case", rss_name = "typical";  ///< of the two curves
  std::string limit_name = "limit";
};
std::string copy_error_chart(const CopyErrorChart& chart);
/// The front between two objectives, this design marked.
std::string pareto_chart(const ParetoFront& front);
/// Where the report of a front's point lies, seen from the front's page: in the folder of its name.
std::string report_of(const ParetoRow& row);

}  // namespace kempe
