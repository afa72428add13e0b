// Steps: scattered ratios, angles and timings, judged by linear least squares; the best that differ refined within the limits; the best
// of these moved by the general solver.

#include "synthesis/paths/path_generator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/convex_hull.hpp"
#include "synthesis/paths/path_program.hpp"
#include "synthesis/paths/slack.hpp"
#include "synthesis/solvers/van_der_corput.hpp"

namespace kempe {
namespace {

constexpr std::size_t scattered_linkages = 20000, finished_linkages = 40, polished_linkages = 5,
                      raised_linkages = 12;

/// Unknowns nearer to an end, from x.
using PathStep = std::function<Eigen::VectorXd(const PathProgram& program, const Eigen::VectorXd& x)>;

struct PathStart {
  Eigen::VectorXd x;
  FourBarBranch branch;
  bool rising;
  double cost;
};

/// Shares of the way along the points, by their distances.
std::vector<double> shares_along(const std::vector<Point>& points) {
  std::vector<double> shares{0};
  for (std::size_t i = 1; i < points.size(); ++i)
    shares.push_back(shares.back() + std::max((points[i] - points[i - 1]).norm(), slack::path_least_step));
  for (double& share : shares) share /= shares.back();
  return shares;
}

/// How far the limits are broken, in all.
double broken_by(const PathProgram& program, const Eigen::VectorXd& x) {
  Eigen::VectorXd value;
  program.limits(x, value, nullptr);
  return value.cwiseMax(0).cwiseMin(10).sum();
}

std::vector<PathStart> scattered_starts(const PathTask& task, PathEffort& effort) {
  std::vector<PathStart> starts;
  const std::vector<double> shares = shares_along(task.points);
  Eigen::VectorXd errors;
  for (std::size_t i = 1; i <= scattered_linkages; ++i) {
    const bool rising = task.turns.empty() ? i % 4 < 2 : task.turns.back() > 0;
    const FourBarBranch branch = i % 2 == 0 ? FourBarBranch::first : FourBarBranch::second;
    PathProgram program(task, branch, rising);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(program.size());
    const auto between = [&](unsigned base, double low, double high) {
      return low + (high - low) * van_der_corput(i, base);
    };
    const double longest = std::log(6.0);
    x[6] = between(3, -longest, longest);
    x[7] = between(5, -longest, longest);
    x[8] = between(7, -longest, longest);
    const double first = task.first_angle ? *task.first_angle : between(11, -pi, pi);
    x[PathProgram::angles_at] = first;
    if (!program.timed()) {
      const double span = (rising ? 1 : -1) * between(13, 0.3, 6.2);
      const double bend = between(17, -0.7, 0.7);  // slower at one end than at the other
      for (int k = 0; k < program.count(); ++k) {
        const double share = shares[static_cast<std::size_t>(k)];
        x[PathProgram::angles_at + k] = first + span * share * (1 + bend * (share - 1));
      }
    }
    ++effort.starts;
    if (!program.project(x) || !program.errors(x, errors, nullptr)) continue;
    program.watch_extremes(x);
    program.choose_motion(x);
    const double broken = broken_by(program, x);
    starts.push_back({x, branch, rising, errors.squaredNorm() / program.count() + 0.01 * broken});
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const PathStart& a, const PathStart& b) { return a.cost < b.cost; });
  return starts;
}

/// The first `most` that differ.
std::vector<PathStart> different(const std::vector<PathStart>& starts, std::size_t most, double apart) {
  std::vector<PathStart> kept;
  for (const PathStart& one : starts) {
    if (kept.size() == most) break;
    const bool seen = std::any_of(kept.begin(), kept.end(), [&](const PathStart& other) {
      const auto tail = one.x.size() - PathProgram::ratios_at;
      return one.branch == other.branch && one.rising == other.rising &&
             (one.x.tail(tail) - other.x.tail(tail)).lpNorm<Eigen::Infinity>() < apart;
    });
    if (!seen) kept.push_back(one);
  }
  return kept;
}

/// Refines within the limits, and again where the crank now passes another place in line with the ground link. Nothing if a limit
/// stays broken.
std::optional<PathStart> refined_start(const PathTask& task, PathStart start, const PathStep& step) {
  PathProgram program(task, start.branch, start.rising);
  program.watch_extremes(start.x);
  program.choose_motion(start.x);
  for (int round = 0; round < 3; ++round) {
    start.x = step(program, start.x);
    const int watched = program.limit_count();
    program.watch_extremes(start.x);
    if (program.limit_count() == watched) break;
  }
  Eigen::VectorXd errors;
  if (!program.errors(start.x, errors, nullptr) || broken_by(program, start.x) > slack::path_limit_broken)
    return std::nullopt;
  start.cost = errors.squaredNorm() / program.count();
  return start;
}

/// Whether x meets the points within the limits, with a larger least transmission angle than y has.
bool moves_better(const PathProgram& program, const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  Eigen::VectorXd value, errors;
  if (!program.errors(x, errors, nullptr) || errors.norm() > slack::path_met ||
      broken_by(program, x) > slack::path_limit_broken)
    return false;
  program.limits(x, value, nullptr);
  const double now = value.head(program.transmission_rows()).maxCoeff();
  program.limits(y, value, nullptr);
  return now < value.head(program.transmission_rows()).maxCoeff() - slack::path_limit_broken;
}

std::optional<PathAnswer> judged_end(const PathTask& task, const PathStart& end) {
  const PathProgram program(task, end.branch, end.rising);
  return judged_path(task, program.linkage(end.x), program.crank_angles(end.x));
}

/// Of the linkages that meet their points those that move best, led on within the family that meets them to a larger transmission angle.
std::vector<PathAnswer> raised_answers(const PathTask& task, const std::vector<PathStart>& ends,
                                       PathEffort& effort) {
  std::vector<PathAnswer> raised;
  for (PathStart end : ends) {
    PathProgram program(task, end.branch, end.rising);
    if (!program.has_families()) break;
    program.watch_extremes(end.x);
    program.choose_motion(end.x);
    double reach = 0.2;
    for (int round = 0; round < 12 && reach > slack::path_least_reach; ++round) {
      PathStart trial = end;
      trial.x = led_to_larger_transmission(program, reach, 80, trial.x, effort.evaluations);
      program.watch_extremes(trial.x);
      if (moves_better(program, trial.x, end.x))
        end = std::move(trial);
      else
        reach /= 4;
    }
    auto answer = judged_end(task, end);
    if (answer && meets_points(task, *answer)) raised.push_back(std::move(*answer));
  }
  return raised;
}

double aimed_error(const PathTask& task, const PathAnswer& answer) {
  return task.aim == PathAim::mean_square ? answer.error_rms : answer.error_max;
}

bool alike(const CouplerFourBar& a, const CouplerFourBar& b) {
  const double size = std::max(a.longest(), b.longest()) * slack::path_answers_apart;
  return (a.crank_pivot - b.crank_pivot).norm() < size && (a.rocker_pivot - b.rocker_pivot).norm() < size &&
         std::abs(a.crank - b.crank) < size;
}

/// One linkage, or the other's cognate that is driven by its crank.
bool alike(const PathAnswer& a, const PathAnswer& b) {
  return alike(a.linkage, b.linkage) || (b.cognates && alike(a.linkage, (*b.cognates)[1].linkage));
}

/// Whether the crank's pivot, the ground link's direction and the crank's first angle are those that the task gives, to rounding.
bool as_given(const PathTask& task, const CouplerFourBar& linkage, double first_angle) {
  const double longest = linkage.longest();
  const double ground = std::arg(as_complex(linkage.rocker_pivot - linkage.crank_pivot));
  const auto differs = [](double angle, const std::optional<double>& given) {
    return given && std::abs(std::remainder(angle - *given, 2 * pi)) > slack::path_given;
  };
  const bool moved =
      task.crank_pivot && (linkage.crank_pivot - *task.crank_pivot).norm() > slack::path_given * longest;
  return !moved && !differs(ground, task.ground_angle) && !differs(first_angle - ground, task.first_angle);
}

double size_of(const std::vector<Point>& points) {
  double size = 0;
  for (const Point& p : points) size = std::max(size, (p - points.front()).norm());
  return size;
}

/// SLSQP as a step.
PathStep sqp(PathAim aim, int most_evaluations, PathEffort& effort) {
  return [=, &effort](const PathProgram& program, const Eigen::VectorXd& x) {
    return refined_path(program, aim, most_evaluations, x, effort.evaluations);
  };
}

/// The best starts that differ, refined; the best first.
std::vector<PathStart> refined_starts(const PathTask& task, const std::vector<PathStart>& starts,
                                      PathEffort& effort) {
  // The work of a step grows with the cube of the unknowns.
  const std::size_t unknowns = 9 + (task.turns.empty() ? task.points.size() : 1);
  const std::size_t most = std::clamp<std::size_t>(2000000 / (unknowns * unknowns * unknowns), 24, 240);
  std::vector<PathStart> ends;
  for (const PathStart& start : different(starts, most, slack::path_starts_apart)) {
    ++effort.refined;
    if (auto end = refined_start(task, start, sqp(PathAim::mean_square, 150, effort)))
      ends.push_back(std::move(*end));
    else
      ++effort.rejected;
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [](const PathStart& a, const PathStart& b) { return a.cost < b.cost; });
  return ends;
}

/// The best ends that differ, refined for what is made small and judged. Where some meet their points, those that move best are led on;
/// where none does, the second solver has its try at the best.
std::vector<PathAnswer> finished_paths(const PathTask& task, const std::vector<PathStart>& ends,
                                       PathEffort& effort) {
  std::vector<PathAnswer> answers;
  using Valued = std::pair<double, PathStart>;
  std::vector<Valued> meeting, missing;  // with the transmission angle; with the error
  for (PathStart& end : different(ends, finished_linkages, slack::path_answers_apart)) {
    const std::size_t before = answers.size();
    for (int round = 0; round < 2; ++round) {
      auto further = refined_start(task, end, sqp(task.aim, 1500, effort));
      if (!further) break;
      end = std::move(*further);
      auto answer = judged_end(task, end);
      if (!answer) continue;
      if (round == 1 && meets_points(task, *answer))
        meeting.emplace_back(answer->transmission_min, end);
      else if (round == 1)
        missing.emplace_back(aimed_error(task, *answer), end);
      answers.push_back(std::move(*answer));
    }
    if (answers.size() == before) ++effort.rejected;
  }
  std::stable_sort(meeting.begin(), meeting.end(),
                   [](const Valued& a, const Valued& b) { return a.first > b.first; });
  std::vector<PathStart> best_moving;
  for (std::size_t k = 0; k < std::min(meeting.size(), raised_linkages); ++k)
    best_moving.push_back(meeting[k].second);
  for (PathAnswer& answer : raised_answers(task, best_moving, effort)) answers.push_back(std::move(answer));
  if (!meeting.empty()) return answers;
  std::stable_sort(missing.begin(), missing.end(),
                   [](const Valued& a, const Valued& b) { return a.first < b.first; });
  const PathStep second = [&](const PathProgram& program, const Eigen::VectorXd& x) {
    return polished_path(program, task.aim, x, effort.evaluations);
  };
  for (std::size_t k = 0; k < std::min(missing.size(), polished_linkages); ++k)
    if (const auto end = refined_start(task, missing[k].second, second))
      if (auto answer = judged_end(task, *end)) answers.push_back(std::move(*answer));
  return answers;
}

/// The best that differ. Where several meet their points, the one that moves best comes first.
std::vector<PathAnswer> best_that_differ(const PathTask& task, std::vector<PathAnswer> answers,
                                         std::size_t most) {
  const double met = slack::path_met * size_of(task.points);
  const auto rank = [&](const PathAnswer& answer) { return std::max(met, aimed_error(task, answer)); };
  std::vector<PathAnswer*> ranked;
  for (PathAnswer& answer : answers) ranked.push_back(&answer);
  std::stable_sort(ranked.begin(), ranked.end(), [&](const PathAnswer* a, const PathAnswer* b) {
    return rank(*a) != rank(*b) ? rank(*a) < rank(*b) : a->transmission_min > b->transmission_min;
  });
  std::vector<PathAnswer> best;
  for (PathAnswer* next : ranked) {
    if (best.size() == most) break;
    PathAnswer& answer = *next;
    const bool seen = std::any_of(best.begin(), best.end(), [&](const PathAnswer& other) {
      const double enough = slack::path_one_curve * other.error_max;
      return alike(answer, other) || (other.error_max > met && curves_apart(answer, other, enough) <= enough);
    });
    if (!seen) best.push_back(std::move(answer));
  }
  return best;
}

}  // namespace

bool meets_points(const PathTask& task, const PathAnswer& answer) {
  return answer.error_max <= slack::path_met * size_of(task.points);
}

std::optional<PathAnswer> judged_path(const PathTask& task, const CouplerFourBar& linkage,
                                      const std::vector<double>& crank_angles) {
  const bool finite = std::isfinite(linkage.longest()) && linkage.crank_pivot.allFinite();
  if (!finite || linkage.longest() > task.longest || !lies_within(task.pivots_within, linkage.crank_pivot) ||
      !lies_within(task.pivots_within, linkage.rocker_pivot) ||
      !as_given(task, linkage, crank_angles.front()))
    return std::nullopt;
  const CrankMotion moves = linkage.links().motion();
  if (!task.motions.empty() &&
      std::find(task.motions.begin(), task.motions.end(), moves) == task.motions.end())
    return std::nullopt;
  const auto transmission = linkage.least_transmission_angle(crank_angles.front(), crank_angles.back());
  if (!transmission || *transmission < std::max(task.transmission, slack::path_from_dead_points))
    return std::nullopt;
  const double way = crank_angles.back() > crank_angles.front() ? 1 : -1;
  for (std::size_t i = 1; i < crank_angles.size(); ++i)
    if (!(way * (crank_angles[i] - crank_angles[i - 1]) > 0)) return std::nullopt;
  const auto motion = certified_path(linkage, CognateDriver::crank, crank_angles, crank_angles.front());
  if (!motion) return std::nullopt;
  PathAnswer answer{linkage,
                    crank_angles,
                    motion->coupler_angle,
                    motion->reached,
                    0,
                    0,
                    *transmission,
                    cognates_of(linkage, crank_angles.front()),
                    {}};
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    const double distance = (answer.reached[i] - task.points[i]).norm();
    answer.error_rms += distance * distance / static_cast<double>(task.points.size());
    answer.error_max = std::max(answer.error_max, distance);
  }
  answer.error_rms = std::sqrt(answer.error_rms);
  answer.active = active_limits(task, answer);
  return answer;
}

tl::expected<PathSearch, std::string> generate_path(const PathTask& task, std::size_t most) {
  PathSearch search;
  const std::vector<PathStart> starts = scattered_starts(task, search.effort);
  std::vector<PathAnswer> answers =
      finished_paths(task, refined_starts(task, starts, search.effort), search.effort);
  search.answers = best_that_differ(task, std::move(answers), most);
  if (search.answers.empty())
    return tl::unexpected(
        fmt::format("no four-bar was found that keeps the limits. Searched: {} scattered four-bars, the best "
                    "{} refined; that "
                    "is not a proof that none exists",
                    search.effort.starts, search.effort.refined));
  return search;
}

}  // namespace kempe
