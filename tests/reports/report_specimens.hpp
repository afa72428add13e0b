#pragma once
// Whole designs for looking at the report: filled by hand, so that every section has something to show.

#include <string>
#include <vector>

#include "reports/page/html_report.hpp"

namespace kempe::testing {

struct ReportSpecimen {
  std::string name;
  Design design;
  ReportExtras extras;
};

/// The plagiograph of the report (k = 1.4 at 90 degrees), with tolerances, an obstacle, parts and a front.
ReportSpecimen plagiograph_specimen();
/// The MATLAB pantograph: ratio 1.5, straight plates, the circle about (5, 5), in cm as mm * 10; no search.
ReportSpecimen matlab_circle_specimen();
/// k = 1/3 at 180 degrees with a text region of several polygons; triangle plates do not differ here.
ReportSpecimen half_turn_specimen();
/// Rotation by 60 degrees, triangle plates, everything from outside hostile.
ReportSpecimen hostile_specimen();

std::vector<ReportSpecimen> report_specimens();

}  // namespace kempe::testing
