#pragma once
// The folder of a front between two objectives: a folder a point with all files of its design, and the front's own.

#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "kempe/spec.hpp"
#include "reports/design_package.hpp"
#include "reports/page/html_report.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// The front's table, in its folder.
inline constexpr const char* front_table_name = "front.csv";

/// Written beside its place, point by point, then put in place.
class FrontFolder {
 public:
  /// For so many points. `extras`: what their reports and the front's own show beside the designs.
  FrontFolder(std::filesystem::path folder, Objective first, Objective second, std::size_t points,
              ReportExtras extras);

  /// Verifies the next point's design and drafts its folder ("01", "02", ...); the values are mm, rad, mm^2 or kg. The error names
  /// the point.
  tl::expected<void, std::string> add(Design design, double first, double second,
                                      const TimeToFinish& time = {});

  /// The names of all files, below the front's folder. Once all points are there.
  std::vector<std::string> names() const;
  /// Puts all files in place, the points' first: the front's page leads to them.
  tl::expected<void, std::string> put_in_place();

  const ParetoFront& chart() const { return chart_; }  ///< the points' values, in the units of files
  const std::vector<std::string>& left_out() const { return left_out_; }  ///< sentences, each with its point
  bool complete() const { return complete_; }  ///< false: stopped early, maps and verification are coarse

 private:
  std::filesystem::path folder_;
  Objective first_, second_;
  std::size_t middle_;  ///< the point whose report is the front's
  ReportExtras extras_;
  std::vector<FolderDraft> points_;
  std::vector<std::string> names_;
  std::optional<Design> middle_design_;
  bool with_section_ = false;  ///< there were sections to choose from
  std::string rows_;           ///< of front.csv
  ParetoFront chart_;
  std::vector<std::string> left_out_;
  bool complete_ = true;
};

}  // namespace kempe
