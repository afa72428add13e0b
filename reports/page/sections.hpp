#pragma once
// The report's sections, each as an HTML fragment; an empty string where there is nothing to say.

#include <string>

#include "reports/page/html_report.hpp"
#include "reports/pictures/map_picture.hpp"

namespace kempe::report_sections {

/// Title, one sentence about what the linkage does, and whether it is verified.
std::string header(const Design& design, const ReportExtras& extras);
/// The few figures a reader looks for first.
std::string key_figures(const Design& design);
/// The picture with its legend; the live part hooks in here.
std::string map(const MapPicture& picture, bool live);
/// Lengths to cut, joints and layers.
std::string making(const Design& design);
std::string quality(const Design& design, const ReportExtras& extras);
std::string workspace(const Design& design);
/// What the tolerances cost, source by source, and over the opening. Computed here
/// (synthesis/tolerance/copy_error.hpp).
std::string tolerance(const Design& design);
/// "Will it be stiff enough?": figure, picture, the whole error in one table with what would help. Empty without [load].
std::string loads(const Design& design);
/// "Weight, balance and feel": sag, friction, mass felt, counterweights and springs. Empty without [load].
std::string weight(const Design& design);
std::string verification(const Design& design);
std::string search(const Design& design);
std::string pareto(const ReportExtras& extras);
/// The links with their dimensions, and the pictures that the extras bring.
std::string parts(const Design& design, const ReportExtras& extras);
std::string spec(const ReportExtras& extras);
std::string footer(const ReportExtras& extras, bool live);

/// The design's title; if it has none, "Copying linkage 1.4 : 1, turned 90°". Not escaped.
std::string title(const Design& design);

}  // namespace kempe::report_sections
