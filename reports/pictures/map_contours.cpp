#include "reports/pictures/map_contours.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "reports/pictures/html_text.hpp"
#include "reports/pictures/round_step.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/load_error.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe {
namespace {

constexpr int steps = 720;

struct Row {
  double opening, error;
};

/// Of an opening.
using Error = std::function<double(double)>;

/// The error over the assembly mode but for its ends, where it grows beyond all bounds.
std::vector<Row> error_rows(const Error& error_at, const OpeningInterval& openings) {
  std::vector<Row> rows;
  for (int i = 0; i <= steps; ++i) {
    const double opening = openings.lower + openings.width() * i / steps;
    const double error = error_at(opening);
    if (std::isfinite(error)) rows.push_back({opening, error});
  }
  return rows;
}

/// Where the error passes the level between two rows on either side of it.
double crossing(const Error& error_at, Row from, Row to, double level) {
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (from.opening + to.opening);
    const double error = error_at(middle);
    ((error < level) == (from.error < level) ? from : to) = {middle, error};
  }
  return 0.5 * (from.opening + to.opening);
}

/// Round levels between the least and the largest error of the openings that the design uses.
std::vector<double> round_levels(const std::vector<Row>& rows, const OpeningInterval& used) {
  std::optional<double> least, largest;
  for (const Row& row : rows) {
    if (!used.empty() && !used.contains(row.opening)) continue;
    least = std::min(least.value_or(row.error), row.error);
    largest = std::max(largest.value_or(row.error), row.error);
  }
  if (!least || !(*largest > *least * (1 + 1e-9))) return {};
  return multiples_within(round_step((*largest - *least) / 6), *least, *largest);
}

std::vector<ContourCircle> circles_of(const Design& design, const Error& error_at) {
  std::vector<ContourCircle> circles;
  const OpeningInterval openings = shrink(design.linkage.assembly_mode().openings, radians(2));
  if (openings.empty()) return circles;
  const std::vector<Row> rows = error_rows(error_at, openings);
  for (const double level : round_levels(rows, design.opening))
    for (std::size_t i = 1; i < rows.size(); ++i)
      if ((rows[i - 1].error < level) != (rows[i].error < level))
        circles.push_back({level, design.linkage.radius_at(crossing(error_at, rows[i - 1], rows[i], level))});
  return circles;
}

}  // namespace

double step_of_levels(const std::vector<ContourCircle>& circles) {
  double step = 0;
  for (std::size_t i = 1; i < circles.size(); ++i)
    if (const double apart = std::abs(circles[i].level - circles[i - 1].level);
        apart > 0 && (step == 0 || apart < step))
      step = apart;
  return step;
}

std::string level_text(const ContourCircle& circle, double step, int decimals) {
  if (step == 0) return length_text(circle.level, decimals);
  return multiple_text(circle.level, step, decimals) + "\u00a0mm";
}

std::vector<ContourCircle> transmission_circles(const CopyingLinkage& linkage) {
  std::vector<ContourCircle> circles;
  for (int level = 10; level <= 80; level += 10) {
    const OpeningInterval openings = linkage.openings_with_transmission(radians(level));
    if (openings.empty()) break;
    for (const double opening : {openings.lower, openings.upper})
      circles.push_back({radians(level), linkage.radius_at(opening)});
  }
  return circles;
}

std::vector<ContourCircle> copy_error_circles(const Design& design) {
  if (!design.tolerance) return {};
  const CopyErrorProfile profile =
      copy_error_profile(design.linkage, CopyTolerance::uniform(*design.tolerance));
  return circles_of(design, [&](double opening) { return profile.at(opening).worst; });
}

std::vector<ContourCircle> load_error_circles(const Design& design) {
  if (!design.load || !design.material) return {};
  const CopyingLinkage& linkage = design.linkage;
  const LoadErrorProfile profile(linkage.k(), linkage.grounding(), design.style, *design.material,
                                 most_force_at_pen(*design.load));
  return circles_of(design, [&](double opening) {
    return profile.at({linkage.VA(), linkage.VB()}, opening).worst;
  });
}

}  // namespace kempe
