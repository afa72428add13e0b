#include "synthesis/search/diagnosis/plain_reasons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/regions/region_algebra.hpp"
#include "specs/grid_lengths.hpp"
#include "specs/hardware.hpp"
#include "synthesis/bound/copy_gap.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/sag.hpp"
#include "synthesis/search/diagnosis/relaxation_words.hpp"
#include "synthesis/search/steps/search_task.hpp"
#include "synthesis/search/steps/slack.hpp"
#include "workspace/obstructions.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

NoDesign impossible(std::string requirement, std::string sentence) {
  return {.requirement = std::move(requirement), .sentence = std::move(sentence), .proven = true};
}

/// A length that some links must not exceed, and where the spec says so.
struct MostLength {
  std::string key;
  double length;  ///< mm
};

/// The least of the largest lengths that the spec leaves to some two joints of a link.
MostLength least_most_length(const Spec& spec) {
  const LinkSpec& links = spec.links;
  MostLength most{"links.longest_mm", links.longest};
  const auto take = [&](std::string key, double length) {
    if (length < most.length) most = {std::move(key), length};
  };
  take("limits.longest_strip_mm", largest_joint_distance(spec));
  const StockLengths& stock_lengths = links.stock_lengths;
  if (stock_lengths.grid) take("links.grid_mm", longest_multiple(*stock_lengths.grid, links.longest));
  double stock = 0;
  for (const double length : stock_lengths.stock)
    if (length <= links.longest) stock = std::max(stock, length);
  if (!stock_lengths.stock.empty()) take("links.stock_mm", stock);
  for (std::size_t i = 0; i < stock_lengths.locked.size(); ++i)
    if (stock_lengths.locked[i])
      take(fmt::format("links.{}_mm", LinkLengths::names[i]), *stock_lengths.locked[i]);
  return most;
}

/// Holes that need more than the stock lengths.
std::optional<NoDesign> holes_too_near(const Spec& spec, SpecUnit unit) {
  const MostLength most = least_most_length(spec);
  if (hole_distance(spec) <= most.length * (1 + slack::hole_rounding)) return std::nullopt;
  const double room = most.length - joint_width(spec), pin = pin_for_hole_distance(spec, most.length);
  const bool by_wall = spec.links.wall && room > slack::least_wall_share * joint_width(spec);
  const std::string leave = fmt::format("{}, and {} leaves them {} {}", holes_sentence(spec, unit),
                                        name_in(unit, most.key), six_digits(most.length, unit), name(unit));
  if (!by_wall && !spec.links.hardware.none())
    return impossible("links.hardware", fmt::format("links.hardware = \"{}\" is in the way: {}",
                                                    words(spec.links.hardware), leave));
  const std::string key = by_wall ? "links.wall_mm" : "links.pin_diameter_mm";
  std::string sentence =
      fmt::format("{} = {} is in the way: {}", name_in(unit, key),
                  six_digits(by_wall ? *spec.links.wall : spec.links.style.pin_diameter, unit), leave);
  if (const double enough = by_wall ? room : pin; enough > 0)
    sentence += fmt::format("; {} would fit", six_digits(rounded_down(enough, unit), unit));
  return impossible(key, std::move(sentence));
}

/// An obstacle whose distance from the pole is less than its post and clearance need, by more than rounding.
std::optional<NoDesign> pole_under_obstacle(const Spec& spec, const Point& pole, SpecUnit unit) {
  const double needed = spec.links.style.pin_diameter / 2 + spec.limits.clearance;
  const double rounding = slack::place_rounding * (needed + pole.norm());
  for (const Obstacle& obstacle : spec.obstacles)
    if (obstacle.lowest_layer == 1 && distance(Region{{obstacle.shape}}, pole) < needed - rounding)
      return impossible(
          "obstacles",
          fmt::format("{} stands over the pole at {}, or within its clearance; the pole or the obstacle "
                      "must move",
                      obstacle.name, place_text(pole, unit)));
  return std::nullopt;
}

/// A pole that does not stand on the table, its post and clearance included, by more than rounding.
std::optional<NoDesign> pole_off_table(const Spec& spec, const Point& pole, SpecUnit unit) {
  if (!spec.table) return std::nullopt;
  const double needed = spec.links.style.pin_diameter / 2 + spec.limits.clearance;
  const double rounding = slack::place_rounding * (needed + pole.norm());
  if (distance(Region{{off_the_table(*spec.table, {})}}, pole) >= needed - rounding &&
      contains(Region{{*spec.table}}, pole))
    return std::nullopt;
  return impossible("table",
                    fmt::format("the pole at {} stands off the table, or nearer to its edge than post and "
                                "clearance need; the pole or the table must move",
                                place_text(pole, unit)));
}

/// Original and copy as the pole alone places them: by places of the region that come too near (bound/copy_gap.hpp).
std::optional<NoDesign> copy_too_near(const Spec& spec, const Point& pole, SpecUnit unit) {
  if (!spec.limits.copy_gap || spec.region.empty()) return std::nullopt;
  const RegionReach region(spec.region);
  if (bounding::CopyGap(spec, region).verdict(pole, 0) != bounding::CopyGap::Verdict::too_near)
    return std::nullopt;
  const auto nearest = nearest_places(spec.region, similar_image(spec.region, spec.copy.k(), pole));
  const double apart = nearest ? nearest->distance : 0;
  const std::string key = "limits.sheets_gap_mm";
  return impossible(
      key,
      fmt::format("{0} = {1} is in the way: with the pole at {2} the copy {3}, whatever the links are; "
                  "the pole must move (or be free), or {0} must be {4}",
                  name_in(unit, key), six_digits(*spec.limits.copy_gap, unit), place_text(pole, unit),
                  apart > 0 ? fmt::format("lies {} {} from the original", six_digits(apart, unit), name(unit))
                            : "overlaps the original",
                  apart > 0 ? "less or left out" : "left out"));
}

/// On an upright table play alone lets tracer and pen sink, and of that the post's part depends on the distance from the pole alone: whatever the
/// links are, a unit force there turns the post by that distance. A link may tilt on it by play / grip. By more than rounding.
std::optional<NoDesign> post_tilts_too_far(const Spec& spec, const Point& pole, SpecUnit unit) {
  if (!spec.limits.sag || !spec.material || !spec.load || !spec.load->rests.empty() || spec.region.empty())
    return std::nullopt;
  const SagConditions conditions = sag_conditions(spec, {});
  if (!(conditions.play > 0) || gravity_across(conditions.tilt) > 0) return std::nullopt;
  // With stock lengths the ratio may be another, and so the pen's distance.
  const bool by_pen = spec.copy.scale() > 1 && !has_stock_lengths(spec);
  const double distance = distance_range(spec.region, pole).farthest,
               rounding = slack::place_rounding * (distance + pole.norm()),
               farthest = (distance - rounding) * (by_pen ? spec.copy.scale() : 1),
               sinks = farthest * conditions.play / conditions.grip, limit = *spec.limits.sag;
  if (!(sinks > limit * (1 + slack::place_rounding))) return std::nullopt;
  const std::string key = "limits.sag_mm";
  const auto text = [&](double length) { return six_digits(length, unit); };
  return impossible(
      key,
      fmt::format(
          "{} = {} is in the way: {} is up to {} {} from the pole, and play of {} {} over a grip of {} {} "
          "in the post's bearing alone lets it sink by {} {} there, whatever the links are; the limit must "
          "be more than that, {} more than {} or {} less than {}",
          name_in(unit, key), text(limit), by_pen ? "the pen" : "the tracer", text(farthest), name(unit),
          text(conditions.play), name(unit), text(conditions.grip), name(unit), text(sinks), name(unit),
          name_in(unit, "load.grip_mm"), text(conditions.grip * sinks / limit),
          name_in(unit, "tolerance.play_mm"), text(conditions.play * limit / sinks)));
}

std::optional<NoDesign> pole_impossible(const Spec& spec, SpecUnit unit) {
  if (!spec.pole.is_fixed()) return std::nullopt;
  const Point& pole = std::get<Point>(spec.pole.place);
  if (contains(spec.region, pole))
    return impossible(
        "pole.at_mm",
        fmt::format("the pole at {} stands inside the region, where no linkage brings its tracer to the "
                    "pole; it must move out of the region (or be free)",
                    place_text(pole, unit)));
  if (auto none = pole_blocked(spec, unit)) return none;
  if (auto none = copy_too_near(spec, pole, unit)) return none;
  return post_tilts_too_far(spec, pole, unit);
}

}  // namespace

std::optional<NoDesign> pole_blocked(const Spec& spec, SpecUnit unit) {
  if (!spec.pole.is_fixed()) return std::nullopt;
  const Point& pole = std::get<Point>(spec.pole.place);
  if (auto none = pole_under_obstacle(spec, pole, unit)) return none;
  return pole_off_table(spec, pole, unit);
}

std::optional<NoDesign> plainly_impossible(const Spec& spec, SpecUnit unit) {
  if (auto none = pole_impossible(spec, unit)) return none;
  return holes_too_near(spec, unit);
}

}  // namespace kempe
