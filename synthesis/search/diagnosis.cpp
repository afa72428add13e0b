// Steps: for each limit alone, the best that designs can have of it while all others hold (that limit is the goal of its
// own search); the limit moved there, a little further so that rounding does no harm; the spec searched again with it.

#include "synthesis/search/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/problem/obstacle_reach.hpp"
#include "synthesis/search/best_design.hpp"
#include "synthesis/search/nearby_search.hpp"
#include "synthesis/search/steps/tolerances.hpp"

namespace kempe {
namespace {

/// A limit that can be moved: how a person knows it and how far it may go at most.
struct Movable {
  Goal goal;
  const char* key;
  double unit;     ///< the key's unit in mm or rad
  double loosest;  ///< in mm or rad
};

constexpr std::array movables{
    Movable{Goal::transmission, "limits.transmission_deg", pi / 180, 0},
    Movable{Goal::clearance, "limits.clearance_mm", 1, 0},
    Movable{Goal::longest, "links.longest_mm", 1, 1e5},
    Movable{Goal::sheets_gap, "limits.sheets_gap_mm", 1, 0},
    Movable{Goal::copy_error, "limits.copy_error_mm", 1, 1e3},
    Movable{Goal::pole_margin, "pole.within_mm", 1, 1e4},
};

/// To four digits, not more than the value.
double rounded_down(double value) {
  const double step = std::pow(10, std::floor(std::log10(value)) - 3);
  return std::floor(value / step) * step;
}

/// The limit's value, or nothing if the spec does not have it.
std::optional<double> value_of(const Requirements& limits, const Spec& spec, Goal goal) {
  switch (goal) {
    case Goal::transmission: return limits.transmission;
    case Goal::clearance: return limits.clearance;
    case Goal::longest: return limits.longest;
    case Goal::shortest: return limits.shortest;
    case Goal::sheets_gap: return limits.sheets_gap;
    case Goal::copy_error: return limits.copy_error;
    case Goal::pole_margin:
      return spec.pole.is_fixed() ? std::nullopt : std::optional<double>(limits.pole_margin);
    default: return std::nullopt;
  }
}

Requirements moved(Requirements limits, Goal goal, double value) {
  switch (goal) {
    case Goal::transmission: limits.transmission = value; break;
    case Goal::clearance: limits.clearance = value; break;
    case Goal::longest: limits.longest = value; break;
    case Goal::shortest: limits.shortest = value; break;
    case Goal::sheets_gap: limits.sheets_gap = value; break;
    case Goal::copy_error: limits.copy_error = value; break;
    case Goal::pole_margin: limits.pole_margin = value; break;
    default: break;
  }
  return limits;
}

/// The limit moved past the value attained (tolerance::give_of_value), in its own unit, then rounded outwards.
double possible_value(const Movable& limit, double demanded, double attained) {
  const double best = attained / limit.unit, way = std::abs(best - demanded / limit.unit);
  const double give =
      std::max(std::min(tolerance::give_of_value * std::abs(best), tolerance::give_of_way * way),
               tolerance::least_give);
  const double step = std::pow(10, std::floor(std::log10(give)));
  const double rounded =
      is_maximized(limit.goal) ? std::floor((best - give) / step) : std::ceil((best + give) / step);
  return rounded * step * limit.unit;
}

/// "two holes of 6 mm with a wall of 0.6 mm between them stand 6.6 mm apart"
std::string holes_sentence(const Spec& spec) {
  return fmt::format("two holes of {:.6g} mm with a wall of {:.6g} mm between them stand {:.6g} mm apart",
                     joint_width(spec), least_wall(spec), hole_distance(spec));
}

std::string holes_sentence(const Spec& spec, const char* key, double demanded, double possible) {
  return fmt::format("{} = {:.6g} is in the way: {}; {:.6g} would do", key, demanded, holes_sentence(spec),
                     possible);
}

std::string sentence_of(const Movable& limit, double demanded, double possible) {
  if (limit.goal == Goal::pole_margin)
    return fmt::format("{} is in the way; the pole {:.6g} mm outside it would do", limit.key, possible);
  return fmt::format("{} = {:.6g} is in the way; {:.6g} would do", limit.key, demanded / limit.unit,
                     possible / limit.unit);
}

RelaxedDesign start_at(const CopyingLinkage& linkage) {
  return {linkage.grounding(), linkage.assembly_mode(), linkage.VA(), linkage.VB(), linkage.pole(), {}};
}

/// The best that designs can have of a limit while all others hold. Its own search may miss where the pole wanders far: a
/// search for the spec's objective with the limit nearer to what is demanded finds what it missed.
SearchResult best_attained(const SearchTask& task, const Requirements& limits, const Movable& limit,
                           double demanded) {
  const DiagnosisBudget& budget = task.budgets().diagnosis;
  SearchResult best = best_design(task.with(moved(limits, limit.goal, limit.loosest), limit.goal));
  for (int rounds = 0; best.design && rounds < budget.rounds && !task.stopped(); ++rounds) {
    bool nearer = false;
    for (const double share : budget.nearer) {
      if (task.stopped()) break;
      const double attained = best.design->attained.of(limit.goal);
      const Requirements narrowed = moved(limits, limit.goal, demanded + share * (attained - demanded));
      SearchResult found = best_design(task.with(narrowed, task.goal));
      best.evaluations += found.evaluations;
      if (!found.design) continue;
      const SearchResult polished =
          best_from(start_at(found.design->linkage), task.with(narrowed, limit.goal), {});
      best.evaluations += polished.evaluations;
      best.design = polished.design ? polished.design : found.design;
      nearer = true;
      break;
    }
    if (!nearer) break;
  }
  return best;
}

std::optional<Relaxation> relaxation_of(const SearchTask& task, const Requirements& limits,
                                        const Movable& limit, std::uint64_t& evaluations) {
  const auto demanded = value_of(limits, task.spec(), limit.goal);
  if (!demanded || task.stopped()) return std::nullopt;
  const SearchResult widest = best_attained(task, limits, limit, *demanded);
  evaluations += widest.evaluations;
  if (!widest.design) return std::nullopt;
  const double possible = possible_value(limit, *demanded, widest.design->attained.of(limit.goal));
  const SearchResult again = best_design(task.with(moved(limits, limit.goal, possible), task.goal));
  evaluations += again.evaluations;
  return Relaxation{limit.goal,
                    limit.key,
                    *demanded,
                    possible,
                    sentence_of(limit, *demanded, possible),
                    again.design ? *again.design : *widest.design};
}

/// A thinner wall between two holes, of which something is left.
std::optional<Relaxation> thinner_wall(const SearchTask& task, const Requirements& limits,
                                       std::uint64_t& evaluations) {
  const Spec& spec = task.spec();
  const double bore = joint_width(spec), wall = least_wall(spec);
  const Movable limit{
      Goal::shortest, "links.wall_mm", 1,
      std::max({spec.links.shortest, (1 + tolerance::least_wall_share) * bore, tolerance::nearest_joints})};
  if (limit.loosest >= limits.shortest) return std::nullopt;
  auto relaxation = relaxation_of(task, limits, limit, evaluations);
  if (!relaxation) return std::nullopt;
  relaxation->possible = std::max(relaxation->possible, limit.loosest);
  relaxation->sentence = holes_sentence(spec, limit.key, wall, relaxation->possible - bore);
  return relaxation;
}

/// The same question of another spec.
SearchResult best_of_other_spec(const SearchTask& task, const Spec& spec, const Requirements& limits) {
  return best_design(pose(spec, task.control.silent_part()).with(limits, task.goal));
}

/// Thinner pins, which stand in fewer parts' way too: the thickest with which there is a design, by halving. Thinner ones
/// never forbid what thicker ones allow.
std::optional<Relaxation> thinner_pins(const SearchTask& task, const Requirements& limits,
                                       std::uint64_t& evaluations) {
  const double pin = task.spec().links.style.pin_diameter;
  const auto with_pins = [&](double diameter) {
    Spec spec = task.spec();
    spec.links.style.pin_diameter = diameter;
    Requirements thinner = limits;
    thinner.shortest = least_joint_distance(spec);
    SearchResult found = best_of_other_spec(task, spec, thinner);
    evaluations += found.evaluations;
    return found;
  };
  double enough = tolerance::least_wall_share * pin, too_much = pin;
  std::optional<FoundDesign> design = with_pins(enough).design;
  for (int i = 0; design && i < task.budgets().diagnosis.pin_halvings && !task.stopped(); ++i) {
    const double middle = rounded_down(0.5 * (enough + too_much));
    if (middle <= enough) break;
    const SearchResult found = with_pins(middle);
    (found.design ? enough : too_much) = middle;
    if (found.design) design = found.design;
  }
  if (!design) return std::nullopt;
  Spec spec = task.spec();
  spec.links.style.pin_diameter = enough;
  return Relaxation{Goal::shortest,
                    "links.pin_diameter_mm",
                    limits.shortest,
                    least_joint_distance(spec),
                    holes_sentence(task.spec(), "links.pin_diameter_mm", pin, enough),
                    *design};
}

/// The joints of a link are kept apart by shortest_mm or by their holes, whichever asks for more: that one may give.
std::optional<Relaxation> nearer_joints(const SearchTask& task, const Requirements& limits,
                                        std::uint64_t& evaluations) {
  const double holes = hole_distance(task.spec()), shortest = task.spec().links.shortest;
  if (shortest > holes)
    return relaxation_of(task, limits,
                         {Goal::shortest, "links.shortest_mm", 1, std::max(holes, tolerance::nearest_joints)},
                         evaluations);
  if (shortest == holes) return std::nullopt;
  if (auto wall = thinner_wall(task, limits, evaluations)) return wall;
  return thinner_pins(task, limits, evaluations);
}

std::optional<Relaxation> without_obstacles(const SearchTask& task, const Requirements& limits,
                                            const std::vector<Obstacle>& left, const std::string& gone,
                                            std::uint64_t& evaluations) {
  if (task.stopped()) return std::nullopt;
  Spec spec = task.spec();
  spec.obstacles = left;
  const SearchResult found = best_of_other_spec(task, spec, limits);
  evaluations += found.evaluations;
  if (!found.design) return std::nullopt;
  return Relaxation{
      {},
      "obstacles",
      0,
      0,
      fmt::format("{} in the way; without {} a design exists",
                  gone + (gone == "the obstacles" ? " are" : " is"), gone == "the obstacles" ? "them" : "it"),
      *found.design};
}

std::vector<Relaxation> obstacle_relaxations(const SearchTask& task, const Requirements& limits,
                                             std::uint64_t& evaluations) {
  const std::vector<Obstacle>& all = task.space().spec().obstacles;  // no other is in the way
  if (all.empty()) return {};
  const auto none_left =
      without_obstacles(task, limits, {}, all.size() == 1 ? all[0].name : "the obstacles", evaluations);
  if (!none_left) return {};
  std::vector<Relaxation> single;
  if (all.size() > task.budgets().diagnosis.single_obstacles) return {*none_left};
  for (std::size_t i = 0; i < all.size() && all.size() > 1; ++i) {
    std::vector<Obstacle> left = all;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
    if (const auto one = without_obstacles(task, limits, left, all[i].name, evaluations))
      single.push_back(*one);
  }
  return single.empty() ? std::vector{*none_left} : single;
}

NoDesign impossible(std::string requirement, std::string sentence) {
  return {.requirement = std::move(requirement), .sentence = std::move(sentence), .proven = true};
}

/// The share of itself by which a limit has to give; an obstacle is whole or away.
double give(const Relaxation& r) {
  return r.limit ? std::abs(r.possible - r.demanded) / std::max(std::abs(r.demanded), tolerance::least_demand)
                 : 1;
}

/// A length that some links must not exceed, and where the spec says so.
struct MostLength {
  std::string key;
  double length;  ///< mm
};

/// The least of the largest lengths that the spec leaves to some two joints of a link.
MostLength least_most_length(const LinkSpec& links) {
  MostLength most{"links.longest_mm", links.longest};
  const auto take = [&](std::string key, double length) {
    if (length < most.length) most = {std::move(key), length};
  };
  const WorkshopSpec& workshop = links.workshop;
  if (workshop.grid) take("links.grid_mm", std::floor(links.longest / *workshop.grid) * *workshop.grid);
  double stock = 0;
  for (const double length : workshop.stock)
    if (length <= links.longest) stock = std::max(stock, length);
  if (!workshop.stock.empty()) take("links.stock_mm", stock);
  for (std::size_t i = 0; i < workshop.locked.size(); ++i)
    if (workshop.locked[i]) take(fmt::format("links.{}_mm", LinkLengths::names[i]), *workshop.locked[i]);
  return most;
}

/// Holes that need more than the lengths that the workshop dictates.
std::optional<NoDesign> holes_too_near(const Spec& spec) {
  const MostLength most = least_most_length(spec.links);
  if (hole_distance(spec) <= most.length * (1 + tolerance::hole_rounding)) return std::nullopt;
  const double room = most.length - joint_width(spec), pin = pin_for_hole_distance(spec, most.length);
  const bool by_wall = spec.links.wall && room > tolerance::least_wall_share * joint_width(spec);
  const std::string key = by_wall ? "links.wall_mm" : "links.pin_diameter_mm";
  std::string sentence = fmt::format("{} = {:.6g} is in the way: {}, and {} leaves them {:.6g} mm", key,
                                     by_wall ? *spec.links.wall : spec.links.style.pin_diameter,
                                     holes_sentence(spec), most.key, most.length);
  if (const double enough = by_wall ? room : pin; enough > 0)
    sentence += fmt::format("; {:.6g} would do", rounded_down(enough));
  return impossible(key, std::move(sentence));
}

std::optional<NoDesign> pole_impossible(const Spec& spec) {
  if (!spec.pole.is_fixed()) return std::nullopt;
  const Point& pole = std::get<Point>(spec.pole.place);
  if (contains(spec.region, pole))
    return impossible("pole.at_mm",
                      "the pole stands inside the region, and no linkage brings its tracer to the pole");
  const double needed = spec.links.style.pin_diameter / 2 + spec.limits.clearance;
  for (const Obstacle& obstacle : spec.obstacles)
    if (obstacle.lowest_layer == 1 && distance(Region{{obstacle.shape}}, pole) < needed)
      return impossible("obstacles",
                        fmt::format("{} stands over the pole at ({:.6g}, {:.6g}) mm, or within its clearance",
                                    obstacle.name, pole.x(), pole.y()));
  return std::nullopt;
}

}  // namespace

std::optional<NoDesign> plainly_impossible(const Spec& spec) {
  if (auto none = pole_impossible(spec)) return none;
  return holes_too_near(spec);
}

NoDesign diagnose(const SearchTask& task, const SearchResult& nothing) {
  NoDesign none{.requirement = "limits",
                .sentence = "no design keeps all limits",
                .relaxations = {},
                .proven = nothing.proven_none,
                .obstacles_out_of_reach = names_out_of_reach(task.spec()),
                .evaluations = nothing.evaluations};
  if (!task.control.options().diagnose) return none;
  const Requirements limits = requirements_of(task.spec());
  for (const Movable& limit : movables)
    if (const auto relaxation = relaxation_of(task, limits, limit, none.evaluations))
      none.relaxations.push_back(*relaxation);
  if (auto relaxation = nearer_joints(task, limits, none.evaluations))
    none.relaxations.push_back(*std::move(relaxation));
  for (Relaxation& relaxation : obstacle_relaxations(task, limits, none.evaluations))
    none.relaxations.push_back(std::move(relaxation));
  none.diagnosed = !task.stopped();
  std::stable_sort(none.relaxations.begin(), none.relaxations.end(),
                   [](const Relaxation& a, const Relaxation& b) { return give(a) < give(b); });
  if (none.relaxations.empty()) {
    none.sentence += none.diagnosed ? ", and relaxing a single limit is not enough"
                                    : "; stopped before it was known which limit to relax";
  } else {
    none.sentence = none.relaxations.front().sentence;
    none.requirement = none.relaxations.front().key;
  }
  return none;
}

}  // namespace kempe
