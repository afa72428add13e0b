#include "reports/front_folder.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reports/earlier_design.hpp"
#include "reports/publication.hpp"
#include "specs/objective_unit.hpp"

namespace kempe {
namespace {

constexpr const char* page_name = "report.html";
constexpr const char* table_name = "front.csv";

/// For the table: a millionth of a micrometre is nothing (design.json has every digit).
double coordinate(double value) { return std::abs(value) < 1e-9 ? 0 : value; }

/// Of the folder of a point.
std::string number_of(std::size_t index) { return fmt::format("{:02}", index + 1); }

std::string csv_head(Objective first, Objective second, bool with_section) {
  return fmt::format("point,{}_{},{}_{},vertex,assembly,VA_mm,VB_mm,pole_x_mm,pole_y_mm{}\n", name(first),
                     unit_of(first), name(second), unit_of(second),
                     with_section ? ",width_mm,thickness_mm" : "");
}

std::string csv_row(const ParetoRow& row, const Design& design, bool with_section) {
  const CopyingLinkage& l = design.linkage;
  return fmt::format("{},{},{},{},{},{},{},{},{}{}\n", row.name, row.first, row.second, name(l.grounding()),
                     l.assembly_mode().number, l.VA(), l.VB(), coordinate(l.pole().x()),
                     coordinate(l.pole().y()),
                     with_section ? fmt::format(",{},{}", design.style.width, design.style.thickness) : "");
}

}  // namespace

FrontFolder::FrontFolder(std::filesystem::path folder, Objective first, Objective second, std::size_t points,
                         ReportExtras extras)
    : folder_(std::move(folder)), first_(first), second_(second), middle_(points / 2),
      extras_(std::move(extras)), chart_{std::string(name(first)),
                                         std::string(unit_of(first)),
                                         std::string(name(second)),
                                         std::string(unit_of(second)),
                                         {}} {}

tl::expected<void, std::string> FrontFolder::add(Design design, double first, double second,
                                                 const TimeToFinish& time) {
  const std::size_t index = chart_.rows.size();
  const std::string number = number_of(index);
  with_section_ = with_section_ || (design.allowed && design.allowed->sections.size() > 1);
  FolderDraft& draft = points_.emplace_back(folder_ / number);
  const auto drafted = draft_design(design, extras_, draft, time);
  if (!drafted) return tl::unexpected("point " + number + ": " + drafted.error().sentence);
  for (const std::string& name : draft.names()) names_.push_back(number + "/" + name);
  for (const std::string& sentence : drafted->left_out)
    left_out_.push_back("point " + number + ": " + sentence);
  complete_ = complete_ && design.map.complete;
  chart_.rows.push_back(
      {number, in_file_unit(first_, first), in_file_unit(second_, second), index == middle_});
  rows_ += csv_row(chart_.rows.back(), design, with_section_);
  if (index == middle_) middle_design_ = std::move(design);
  return {};
}

std::vector<std::string> FrontFolder::names() const {
  std::vector<std::string> names = names_;
  names.insert(names.end(), {page_name, table_name});
  return names;
}

tl::expected<void, std::string> FrontFolder::put_in_place() {
  ReportExtras extras = extras_;
  extras.pareto = chart_;
  const std::vector<OutputFile> own{{page_name, html_report(middle_design_.value(), extras)},
                                    {table_name, csv_head(first_, second_, with_section_) + rows_}};
  std::vector<std::string> removed;
  const auto remove = [&](std::size_t index, const std::vector<std::string>& earlier,
                          const std::vector<std::string>& written) {
    for (const std::string& name : remove_left_over(folder_ / number_of(index), earlier, written))
      removed.push_back(number_of(index) + "/" + name);
  };
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto earlier = design_files_in(folder_ / number_of(i));
    if (auto placed = points_[i].put_in_place(); !placed) return placed;
    remove(i, earlier, points_[i].names());
  }
  auto placed = write_whole(folder_, own);
  for (std::size_t i = points_.size(); placed; ++i) {  // a longer front was here
    const auto earlier = design_files_in(folder_ / number_of(i));
    if (earlier.empty()) break;
    remove(i, earlier, {});
  }
  if (!removed.empty()) left_out_.push_back(removed_sentence(removed));
  return placed;
}

}  // namespace kempe
