#include "specs/linkages/straight_bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace kempe {
namespace {

/// Share of the longer one: lengths that differ by no more are one, so that rounded sums of bars still make a row.
constexpr double same_row_length = 1e-9;

using Row = std::map<std::string, double>;  ///< a point's place along the row, mm

class StraightRows {
 public:
  explicit StraightRows(const std::vector<FileBar>& bars) {
    for (const FileBar& bar : bars) {
      lengths_[{std::min(bar.a, bar.b), std::max(bar.a, bar.b)}] = bar.length;
      points_.insert(bar.a);
      points_.insert(bar.b);
    }
  }

  std::vector<Row> find() {
    for (const auto& [ends, whole] : lengths_)
      for (const std::string& middle : points_) {
        const auto first = length(ends.first, middle), second = length(middle, ends.second);
        if (first && second && same(*first + *second, whole))
          add(ends.first, middle, *first, ends.second, whole);
      }
    while (merge_one()) {
    }
    return rows_;
  }

  static bool same(double a, double b) {
    return std::abs(a - b) <= same_row_length * std::max(std::abs(a), std::abs(b));
  }

 private:
  std::optional<double> length(const std::string& a, const std::string& b) const {
    const auto found = lengths_.find({std::min(a, b), std::max(a, b)});
    return found == lengths_.end() ? std::nullopt : std::optional(found->second);
  }

  void add(const std::string& a, const std::string& b, double ab, const std::string& c, double ac) {
    rows_.push_back({{a, 0}, {b, ab}, {c, ac}});
  }

  /// Two rows with two points in common are one.
  bool merge_one() {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (std::size_t j = i + 1; j < rows_.size(); ++j) {
        std::vector<std::string> common;
        for (const auto& [name, place] : rows_[i])
          if (rows_[j].contains(name)) common.push_back(name);
        if (common.size() < 2) continue;
        const double at = rows_[i][common[0]], there = rows_[j][common[0]];
        const bool same_way = (rows_[i][common[1]] > at) == (rows_[j][common[1]] > there);
        for (const auto& [name, place] : rows_[j])
          rows_[i].try_emplace(name, at + (same_way ? place - there : there - place));
        rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(j));
        return true;
      }
    return false;
  }

  std::map<std::pair<std::string, std::string>, double> lengths_;
  std::set<std::string> points_;
  std::vector<Row> rows_;
};

/// The end that the bars name first comes first.
FileLink link_of(const Row& row, const std::vector<FileBar>& bars) {
  std::vector<std::pair<double, std::string>> sorted;
  for (const auto& [name, place] : row) sorted.emplace_back(place, name);
  std::sort(sorted.begin(), sorted.end());
  const auto first_bar = [&](const std::string& name) {
    return std::find_if(bars.begin(), bars.end(),
                        [&](const FileBar& bar) { return bar.a == name || bar.b == name; });
  };
  if (first_bar(sorted.back().second) < first_bar(sorted.front().second)) {
    std::reverse(sorted.begin(), sorted.end());
    for (auto& [place, name] : sorted) place = -place;
  }
  FileLink link;
  for (const auto& [place, name] : sorted) {
    link.name += (link.name.empty() ? "" : "-") + name;
    link.joints.emplace_back(name, Point(place - sorted.front().first, 0));
  }
  return link;
}

std::string note_about(const FileLink& link, const LengthUnit& unit) {
  std::string joints, along;
  for (const auto& [name, place] : link.joints) {
    joints += (joints.empty() ? "" : ", ") + fmt::format("\"{}\"", name);
    along += (along.empty() ? "" : ", ") + fmt::format("{:.10g}", place.x() / unit.in_mm);
  }
  return fmt::format(
      "the bars between {} hold points in a line, which distances alone do not determine to first order; "
      "they are read as one straight link. Write: [links] {} = {{joints = [{}], along = [{}]}}",
      link.name, link.joints.front().first + link.joints.back().first, joints, along);
}

}  // namespace

StraightBars join_straight_bars(const std::vector<FileBar>& bars, const LengthUnit& unit) {
  StraightBars result;
  const std::vector<Row> rows = StraightRows(bars).find();
  for (const Row& row : rows) {
    result.links.push_back(link_of(row, bars));
    result.notes.push_back(note_about(result.links.back(), unit));
  }
  for (const FileBar& bar : bars) {
    const bool inside = std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
      return row.contains(bar.a) && row.contains(bar.b) &&
             StraightRows::same(std::abs(row.at(bar.a) - row.at(bar.b)), bar.length);
    });
    if (!inside) result.remaining.push_back(bar);
  }
  return result;
}

}  // namespace kempe
