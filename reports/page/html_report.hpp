#pragma once
// report.html: one self-contained page about a design, to read, to move and to print. It loads nothing from a
// network.

#include <optional>
#include <string>
#include <vector>

#include "kempe/drawing_options.hpp"
#include "reports/pictures/map_picture.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// One design of a front between two objectives.
struct ParetoRow {
  std::string name;
  double first = 0, second = 0;  ///< in the units of the front
  bool is_this_design = false;
};
struct ParetoFront {
  std::string first_name, first_unit, second_name, second_unit;
  std::vector<ParetoRow> rows;
};

/// A part's drawing: the text of a whole SVG document.
struct PartPicture {
  std::string name;
  std::string svg;
};

/// What the page shows beside the design. Every text may be anything: it is escaped.
struct ReportExtras {
  std::string program_version;  ///< "0.1.0"
  std::string spec_name;        ///< the spec's file name
  std::string spec_text;        ///< as the user wrote it; the middle of a very long one is left out
  std::optional<ParetoFront> pareto;
  std::vector<PartPicture> parts;
  /// The file with the log of the bound's proof, which stands beside the page; empty: there is none.
  std::string proof_log{};
  std::string why_no_parts{};  ///< why there are no files to cut the links by; empty: there are
  /// The studio's page with the spec inside, which stands beside the report; empty: there is none.
  std::string studio_page{};
  /// What workshop.pdf, which stands beside the page, is drawn on.
  Paper paper = Paper::A4;
};

/// The page. Depends on its arguments alone: the same design gives the same bytes.
///
/// Guarantees:
///  1. nothing is loaded from elsewhere, and the page's content security policy forbids it;
///  2. no text of the extras becomes markup or script;
///  3. without JavaScript and in print the design is drawn on its map, with every table.
std::string html_report(const Design& design, const ReportExtras& extras);
/// The same with map_picture(design), which takes most of the time, made before.
std::string html_report(const Design& design, const ReportExtras& extras, const MapPicture& picture);

/// True if this build's report can be moved (built with the dynamic geometry of reports/web).
bool report_is_live();

}  // namespace kempe
