#include "reports/linkages/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/linkages/json.hpp"

namespace kempe {
namespace {

std::string count_of(int count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// "binary", "ternary", ..., then "of 7 joints".
std::string kind_of_link(std::size_t joints) {
  constexpr std::array<std::string_view, 4> names{"binary", "ternary", "quaternary", "pentagonal"};
  return joints < names.size() + 2 ? std::string(names[joints - 2]) : fmt::format("of {} joints", joints);
}

/// "4 binary, 2 ternary"
std::string assortment_text(const LinkAssortment& assortment) {
  std::string text;
  for (std::size_t i = 0; i < assortment.count.size(); ++i)
    if (assortment.count[i] > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", assortment.count[i], kind_of_link(i + 2));
  return text;
}

/// A line for each, the label before the first.
std::string assortment_lines(std::string_view label, const std::vector<LinkAssortment>& assortments) {
  std::string text;
  for (const LinkAssortment& assortment : assortments)
    text += fmt::format("{:<12} {}\n", text.empty() ? label : "", assortment_text(assortment));
  return text;
}

/// Assortments that fit the count and make no chain, under the reason.
std::string left_out_lines(const std::string& why, const std::vector<LinkAssortment>& assortments) {
  if (assortments.empty()) return "";
  std::string text = fmt::format("left out     {}:\n", why);
  for (const LinkAssortment& assortment : assortments)
    text += fmt::format("             {}\n", assortment_text(assortment));
  return text;
}

/// Six digits, and nothing of what is rounding against the linkage's size.
std::string shown_length(double mm, const LinkageFile& file, const LinkageModel& model) {
  const bool is_rounding = std::abs(mm) < 1e-9 * model.linkage.size();
  return fmt::format("{:.6g}", is_rounding ? 0.0 : mm / file.unit.in_mm);
}

std::string driver_line(const LinkageFile& file, const LinkageModel& model, std::size_t driver, double value,
                        double speed) {
  const Constraint& constraint =
      model.linkage.constraints()[static_cast<std::size_t>(model.linkage.drivers()[driver])].constraint;
  const bool is_angle = std::holds_alternative<RelativeAngle>(constraint);
  const std::string label = model.driver_label(static_cast<int>(driver));
  if (is_angle)
    return fmt::format("driver       {} = {:.6g} degrees, moving at {:.6g} degrees/s\n", label,
                       degrees(value), degrees(speed));
  return fmt::format("driver       {} = {} {}, moving at {:.6g} {}/s\n", label,
                     shown_length(value, file, model), file.unit.name, speed / file.unit.in_mm,
                     file.unit.name);
}

}  // namespace

std::string mobility_text(const LinkageFile& file, const LinkageModel& model, const Mobility& m) {
  std::string text = fmt::format("linkage      {}: {}", file.name, count_of(m.links, "link", "links"));
  if (m.particles > 0) text += ", " + count_of(m.particles, "point without a link", "points without a link");
  text += fmt::format(", {}", count_of(m.full_joints - m.sliding_pairs, "revolute joint", "revolute joints"));
  if (m.sliding_pairs > 0) text += ", " + count_of(m.sliding_pairs, "sliding pair", "sliding pairs");
  if (m.half_joints > 0) text += ", " + count_of(m.half_joints, "half joint", "half joints");
  text += fmt::format(
      "\nGruebler     {}\n             {} unknowns - {} equations; n links with the ground, j1 full joints, "
      "j2 half joints{}\n",
      gruebler_in_numbers(m), m.unknowns, m.equations, m.particles > 0 ? ", p points without a link" : "");
  text +=
      fmt::format("mobility     {}: {} of the {} equations independent\n", m.mobility, m.rank, m.equations);
  text += fmt::format("drivers      {}\n", model.linkage.drivers().size());
  const char* label = "result";
  for (const std::string& sentence : mobility_sentences(model, m)) {
    text += fmt::format("{:<12} {}\n", label, sentence);
    label = "";
  }
  return text;
}

std::string number_synthesis_text(int links, int freedoms, const NumberSynthesis& synthesis) {
  std::string text = fmt::format("chains       of {} with {}\n", count_of(links, "link", "links"),
                                 count_of(freedoms, "freedom", "freedoms"));
  if (const std::string why = why_no_chain(links, freedoms, synthesis); !why.empty())
    return text + "none         " + why + "\n";
  text += fmt::format("joints       {}, in {}; a link has at most {}\n", synthesis.joints,
                      count_of(synthesis.loops, "loop", "loops"), synthesis.largest_link);
  text += assortment_lines("links", synthesis.assortments);
  if (synthesis.assortments.empty()) text += "links        no assortment makes a chain\n";
  const std::string of_one = fmt::format("one link would have more than {} joints", synthesis.largest_link);
  text += left_out_lines(of_one, synthesis.too_large);
  return text + left_out_lines("some of the links would be stiff among themselves", synthesis.stiff);
}

std::string centre_place_text(const LinkageFile& file, const LinkageModel& model,
                              const InstantCentre& centre) {
  if (centre.kind == InstantCentre::Kind::finite)
    return fmt::format("({}, {}) {}", shown_length(centre.at.x(), file, model),
                       shown_length(centre.at.y(), file, model), file.unit.name);
  if (centre.kind == InstantCentre::Kind::at_infinity)
    return fmt::format("at infinity, direction {:.6g} degrees",
                       degrees(std::atan2(centre.direction.y(), centre.direction.x())));
  return "undetermined";
}

std::string centres_text(const LinkageFile& file, const LinkageModel& model, double step,
                         const RunFrame& frame, const std::vector<double>& speeds,
                         const std::vector<InstantCentre>& centres) {
  std::string text = fmt::format("linkage      {}, step {:.6g} of {} ({:.6g} s)\n", file.name, step,
                                 file.steps, frame.share * file.duration);
  for (std::size_t i = 0; i < speeds.size(); ++i)
    text += driver_line(file, model, i, frame.values[i], speeds[i]);
  text += fmt::format("centres      {}\n", centres.size());
  std::vector<std::array<std::string, 3>> rows;
  for (const InstantCentre& centre : centres)
    rows.push_back({model.linkage.body_name(centre.first) + ", " + model.linkage.body_name(centre.second),
                    centre_place_text(file, model, centre), source_of(model, centre)});
  std::array<std::size_t, 2> widths{};
  for (const auto& row : rows)
    for (std::size_t i = 0; i < 2; ++i) widths[i] = std::max(widths[i], row[i].size());
  for (const auto& row : rows)
    text += fmt::format("  {:<{}}  {:<{}}  {}\n", row[0], widths[0], row[1], widths[1], row[2]);
  return text;
}

}  // namespace kempe
