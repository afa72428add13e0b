#include "reports/front_folder.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reports/earlier_design.hpp"
#include "reports/publication.hpp"
#include "specs/objective_unit.hpp"

namespace kempe {
namespace {

constexpr const char* page_name = "report.html";

/// For the table: a millionth of a micrometre is nothing (design.json has every digit).
double coordinate(double value) { return std::abs(value) < 1e-9 ? 0 : value; }

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
  const std::string number = point_folder(index);
  with_section_ = with_section_ || (design.allowed && design.allowed->sections.size() > 1);
  FolderDraft& draft = points_.emplace_back(folder_ / number);
  const auto drafted = draft_design(design, extras_, draft, time);
  if (!drafted) return tl::unexpected("point " + number + ": " + drafted.error().sentence);
  if (auto synchronised = draft.synchronise(); !synchronised) return synchronised;
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
  names.insert(names.end(), {page_name, front_table_name});
  return names;
}

tl::expected<void, std::string> FrontFolder::put_in_place() {
  ReportExtras extras = extras_;
  extras.pareto = chart_;
  const std::vector<OutputFile> own{{page_name, html_report(middle_design_.value(), extras)},
                                    {front_table_name, csv_head(first_, second_, with_section_) + rows_}};
  const std::vector<std::string> earlier = design_files_in(folder_);
  for (FolderDraft& point : points_)
    if (auto placed = point.put_in_place(); !placed) return placed;
  auto placed = write_whole(folder_, own);
  if (!placed) return placed;
  if (const auto removed = remove_left_over(folder_, earlier, names()); !removed.empty())
    left_out_.push_back(removed_sentence(removed));
  return placed;
}

}  // namespace kempe
