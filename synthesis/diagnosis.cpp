// Steps: for each limit alone, the best that designs can have of it while all others hold (that limit is the goal of its
// own search); the limit moved there, a little further so that rounding does no harm; the spec searched again with it.

#include "synthesis/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace kempe {
namespace {

constexpr int most_rounds = 8;  ///< of looking for a design nearer to what is demanded

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
    Movable{Goal::shortest, "links.shortest_mm", 1, 1e-3},
    Movable{Goal::sheets_gap, "limits.sheets_gap_mm", 1, 0},
    Movable{Goal::copy_error, "limits.copy_error_mm", 1, 1e3},
    Movable{Goal::pole_margin, "pole.within_mm", 1, 1e4},
};

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

/// The attained value given way by a thousandth of itself, or less where it is near what was demanded: by less than a
/// fiftieth of the way between them, in the limit's own unit rounded on the loose side.
double possible_value(const Movable& limit, double demanded, double attained) {
  const double best = attained / limit.unit, way = std::abs(best - demanded / limit.unit);
  const double give = std::max(std::min(1e-3 * std::abs(best), 8e-3 * way), 1e-6);
  const double step = std::pow(10, std::floor(std::log10(give)));
  const double rounded =
      is_maximized(limit.goal) ? std::floor((best - give) / step) : std::ceil((best + give) / step);
  return rounded * step * limit.unit;
}

std::string sentence_of(const Movable& limit, double demanded, double possible) {
  if (limit.goal == Goal::pole_margin)
    return fmt::format("{} is in the way; the pole {:.6g} mm outside it would do", limit.key, possible);
  return fmt::format("{} = {:.6g} is in the way; {:.6g} would do", limit.key, demanded / limit.unit,
                     possible / limit.unit);
}

/// The best that designs can have of a limit while all others hold. Its own search may miss where the pole wanders far: a
/// search for the spec's objective with the limit nearer to what is demanded finds what it missed.
SearchResult best_attained(const SearchRun& run, const Requirements& limits, const Movable& limit,
                           double demanded) {
  SearchResult best = run.best(moved(limits, limit.goal, limit.loosest), limit.goal);
  for (int rounds = 0; best.design && rounds < most_rounds; ++rounds) {
    bool nearer = false;
    for (const double share : {0.5, 0.9, 0.98}) {
      const double attained = best.design->attained.of(limit.goal);
      const Requirements narrowed = moved(limits, limit.goal, demanded + share * (attained - demanded));
      SearchResult found = run.best(narrowed, goal_of(run.spec().objective.objective));
      best.evaluations += found.evaluations;
      if (!found.design) continue;
      const CopyingLinkage& linkage = found.design->linkage;
      const SearchResult polished = run.best_from(
          {linkage.vertex(), linkage.assembly(), linkage.VA(), linkage.VB(), linkage.pole(), {}}, narrowed,
          limit.goal, {});
      best.evaluations += polished.evaluations;
      best.design = polished.design ? polished.design : found.design;
      nearer = true;
      break;
    }
    if (!nearer) break;
  }
  return best;
}

std::optional<Relaxation> relaxation_of(const SearchRun& run, const Requirements& limits,
                                        const Movable& limit, std::uint64_t& evaluations) {
  const auto demanded = value_of(limits, run.spec(), limit.goal);
  if (!demanded) return std::nullopt;
  const SearchResult widest = best_attained(run, limits, limit, *demanded);
  evaluations += widest.evaluations;
  if (!widest.design) return std::nullopt;
  const double possible = possible_value(limit, *demanded, widest.design->attained.of(limit.goal));
  const SearchResult again =
      run.best(moved(limits, limit.goal, possible), goal_of(run.spec().objective.objective));
  evaluations += again.evaluations;
  return Relaxation{limit.goal, *demanded, possible, sentence_of(limit, *demanded, possible),
                    again.design ? *again.design : *widest.design};
}

/// Obstacles looked at one by one; with more of them only all together.
constexpr std::size_t most_single_obstacles = 12;

std::optional<Relaxation> without_obstacles(const SearchRun& run, const Requirements& limits,
                                            const std::vector<Obstacle>& left, const std::string& gone,
                                            std::uint64_t& evaluations) {
  Spec spec = run.spec();
  spec.obstacles = left;
  SearchOptions options = run.options_from_now();
  options.progress = nullptr;
  const SearchResult found = SearchRun(spec, options).best(limits, goal_of(spec.objective.objective));
  evaluations += found.evaluations;
  if (!found.design) return std::nullopt;
  return Relaxation{
      {},
      0,
      0,
      fmt::format("{} in the way; without {} there is a design",
                  gone + (gone == "the obstacles" ? " are" : " is"), gone == "the obstacles" ? "them" : "it"),
      *found.design};
}

std::vector<Relaxation> obstacle_relaxations(const SearchRun& run, const Requirements& limits,
                                             std::uint64_t& evaluations) {
  const std::vector<Obstacle>& all = run.spec().obstacles;
  if (all.empty()) return {};
  const auto none_left =
      without_obstacles(run, limits, {}, all.size() == 1 ? all[0].name : "the obstacles", evaluations);
  if (!none_left) return {};
  std::vector<Relaxation> single;
  for (std::size_t i = 0; i < all.size() && all.size() > 1 && all.size() <= most_single_obstacles; ++i) {
    std::vector<Obstacle> left = all;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
    if (const auto one = without_obstacles(run, limits, left, all[i].name, evaluations))
      single.push_back(*one);
  }
  return single.empty() ? std::vector{*none_left} : single;
}

NoDesign impossible(std::string requirement, std::string sentence) {
  return {.requirement = std::move(requirement), .sentence = std::move(sentence), .proven = true};
}

/// The share of itself by which a limit has to give; an obstacle is whole or away.
double give(const Relaxation& r) {
  return r.limit ? std::abs(r.possible - r.demanded) / std::max(std::abs(r.demanded), 1e-3) : 1;
}

std::string key_of(const Relaxation& relaxation) {
  for (const Movable& limit : movables)
    if (limit.goal == relaxation.limit) return limit.key;
  return "obstacles";
}

}  // namespace

std::optional<NoDesign> plainly_impossible(const Spec& spec) {
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

NoDesign diagnose(const SearchRun& run, const SearchResult& nothing) {
  NoDesign none{.requirement = "limits",
                .sentence = "no design keeps all limits",
                .relaxations = {},
                .proven = nothing.proven_none,
                .evaluations = nothing.evaluations};
  if (!run.options().diagnose) return none;
  const Requirements limits = requirements_of(run.spec());
  for (const Movable& limit : movables)
    if (const auto relaxation = relaxation_of(run, limits, limit, none.evaluations))
      none.relaxations.push_back(*relaxation);
  for (Relaxation& relaxation : obstacle_relaxations(run, limits, none.evaluations))
    none.relaxations.push_back(std::move(relaxation));
  std::stable_sort(none.relaxations.begin(), none.relaxations.end(),
                   [](const Relaxation& a, const Relaxation& b) { return give(a) < give(b); });
  if (none.relaxations.empty()) {
    none.sentence += ", and no limit moved alone makes one possible";
  } else {
    none.sentence = none.relaxations.front().sentence;
    none.requirement = key_of(none.relaxations.front());
  }
  return none;
}

}  // namespace kempe
