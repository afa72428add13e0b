#include "synthesis/problem/design_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthesis/problem/row_parts.hpp"
#include "synthesis/problem/slack.hpp"
#include "workspace/footprint.hpp"

namespace kempe {
namespace {

/// Stands for no contact at all, in shares of the task's size.
constexpr double far_apart = 1e3;
/// Openings looked at for contact where only a first impression is wanted.
constexpr int search_openings = 9;
/// Openings looked at for a load error that is limited where only a first impression is wanted: it is largest at an end, or it changes slowly.
constexpr int first_load_openings = 3;
/// Fine enough to tell a better footprint from a worse one.
constexpr FootprintGrid search_footprint{16, 48, 0};

/// What is missing to a wanted least value.
double missing(double wanted, double attained) { return std::max(0.0, wanted - attained); }

LogRange overlap(const LogRange& a, const LogRange& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

/// Within the range by share; the middle between its ends if it is empty.
double at_share(const LogRange& range, double share) {
  return range.empty() ? 0.5 * (range.lower + range.upper) : range.lower + share * range.width();
}

bool goal_is_variable(Goal goal) {
  return goal != Goal::size && goal != Goal::footprint && goal != Goal::mass;
}

/// What is too much of a load error or a mass, as a share between 0 and 1.
double excess_share(double value, double limit) {
  return std::isfinite(value) ? missing(value * (1 - slack::limit_rounding), limit) / std::max(value, limit)
                              : 1;
}

}  // namespace

DesignProblem::DesignProblem(const SearchSpace& space, const Choice& choice, const Requirements& limits,
                             Goal goal, const OpeningInterval& allowed, ContactTerms terms,
                             const StockLengths& locked)
    : space_(space), choice_(choice), limits_(limits), goal_(goal), allowed_(allowed),
      terms_(std::move(terms)), roles_(roles_of(choice.grounding)),
      reach_(space.k(), choice.grounding, choice.assembly_mode), box_(length_box(reach_, limits, locked)),
      layout_(space.layout()) {
  layout_.pole_is_free = space.pole_is_free(limits) || goal == Goal::pole_margin;
  layout_.has_goal = goal_is_variable(goal);
  if (!terms_.obstacles.empty()) places_ = space.tracer_places();
  if (goal == Goal::copy_error && space.spec().tolerance)
    copy_error_.emplace(space.k(), choice.grounding, CopyTolerance::uniform(*space.spec().tolerance));
  ask_for_loads();
}

OpeningInterval openings_with_transmission(const Reach& reach, double transmission) {
  return shrink(reach.interval(), std::max(transmission, least_usable_angle) + slack::inward_opening);
}

bool DesignProblem::possible() const { return !box_.u.empty() && !box_.v.empty() && !allowed_.empty(); }

double DesignProblem::cost_of(const Attained& attained) const {
  return is_maximized(goal_) ? -attained.of(goal_) : attained.of(goal_);
}

Box DesignProblem::pole_box() const {
  return space_.pole_box(goal_ == Goal::pole_margin ? 2 * layout_.unit : limits_.pole_margin);
}

Point DesignProblem::unit_pole(double x, double y) const {
  const Box box = pole_box();
  Point pole = box.lower + (box.upper - box.lower).cwiseProduct(Point(x, y));
  const double outside = space_.pole_distance(pole) - limits_.pole_margin;
  if (goal_ == Goal::pole_margin || outside <= 0) return pole;
  const Point home = space_.nearest_pole(pole);
  return home + (pole - home).normalized() * limits_.pole_margin;
}

LogLengths DesignProblem::unit_lengths(const Point& pole, double of_lambda, double of_m) const {
  if (lengths_are_locked()) return {box_.u.lower, box_.v.lower};
  const DistanceRange distances = space_.distances(pole);
  const double r_max = distances.farthest,
               r_min = std::max(distances.nearest, slack::least_distance_share * r_max);
  const double limit = reach_.lambda_limit(r_min, r_max, allowed_).value_or(0);
  const double lambda = at_share(overlap({-limit, limit}, reach_.lambda_range(box_)), of_lambda);
  const LogRange log_m =
      overlap(reach_.log_m_range(lambda, r_min, r_max, allowed_), reach_.log_m_range(lambda, box_));
  return reach_.lengths(lambda, at_share(log_m, of_m));
}

DesignPoint DesignProblem::unit_point(std::span<const double> z) const {
  const Point pole = layout_.pole_is_free ? unit_pole(z[z.size() - 2], z[z.size() - 1]) : layout_.origin;
  return {lengths_are_locked() ? unit_lengths(pole, 0, 0) : unit_lengths(pole, z[0], z[1]), pole};
}

double DesignProblem::smallest_gap(const LogLengths& lengths, double from, double to, int openings,
                                   double enough) const {
  double smallest = enough;
  for (int i = 0; i < openings && !terms_.gaps.empty(); ++i) {
    const double share = openings > 1 ? i / (openings - 1.0) : 0.5;
    const JointFrame frame(reach_.shape(), lengths, from + share * (to - from));
    for (const GapTerm& term : terms_.gaps) smallest = std::min(smallest, gap_value(term, frame, smallest));
  }
  return smallest;
}

double DesignProblem::smallest_obstacle_gap(const DesignPoint& point, double enough,
                                            SmallestGaps* shared) const {
  double smallest = enough;
  std::size_t known = 0;  // places
  if (shared != nullptr && shared->up_to() >= enough) {
    for (const ObstacleTerm& term : terms_.obstacles) smallest = std::min(smallest, shared->of(term));
    known = shared->places();
  }
  const SideLengths sides = reach_.sides(point.lengths);
  for (std::size_t i = known; i < places_.size(); ++i) {
    const PlacedJoints joints(reach_, roles_, point.lengths, sides, point.pole, places_[i]);
    for (const ObstacleTerm& term : terms_.obstacles)
      smallest = std::min(smallest, obstacle_gap(term, space_.obstacles()[term.obstacle], joints, smallest,
                                                 Beyond::anything));
  }
  return smallest;
}

SmallestGaps DesignProblem::gaps_at(const DesignPoint& point) const {
  return {reach_,           roles_, point.lengths, point.pole, space_.tracer_places(), space_.obstacles(),
          limits_.clearance};
}

bool DesignProblem::is_in_the_way_of_the_copy(SmallestGaps& shared) const {
  if (layout_.pole_is_free || goal_ == Goal::clearance) return false;
  const auto is_copied = [&](Joint joint) {
    return joint == roles_.pole || joint == roles_.tracer || joint == roles_.pen;
  };
  return std::any_of(terms_.obstacles.begin(), terms_.obstacles.end(), [&](const ObstacleTerm& term) {
    const JointHull& hull = term.piece.hull;
    if (term.beside || term.turns_with || (term.seen_from && !is_copied(*term.seen_from)) ||
        !std::all_of(hull.joints.begin(), hull.joints.begin() + hull.count, is_copied))
      return false;
    const ObstacleShape& obstacle = space_.obstacles()[term.obstacle];
    const double rounding =
        slack::copied_gap_rounding * (layout_.unit + std::abs(obstacle.centre) + obstacle.radius);
    return shared.of(term) < std::min(limits_.clearance, shared.up_to()) - rounding;
  });
}

double DesignProblem::footprint_at(const DesignPoint& point) const {
  const auto linkage = CopyingLinkage::make(space_.k(), choice_.grounding, std::exp(point.lengths.u),
                                            std::exp(point.lengths.v), choice_.assembly_mode, point.pole);
  return linkage
             ? footprint_estimate(*linkage, space_.spec().links.style, space_.spec().region, search_footprint)
             : 0;
}

bool DesignProblem::tighten(Goal limit, double shortfall) {
  const double more = slack::tightening_factor * shortfall;
  switch (limit) {
    case Goal::clearance: limits_.clearance += more + slack::least_tightening * layout_.unit; return true;
    case Goal::transmission:
      allowed_ = shrink(allowed_, more + slack::least_tightening);
      return !allowed_.empty();
    case Goal::copy_gap:
      limits_.copy_gap = *limits_.copy_gap + more + slack::least_tightening * layout_.unit;
      return true;
    case Goal::load_error:
      limits_.load_error = *limits_.load_error * (1 - slack::give_tightening) - more;
      return *limits_.load_error > 0;
    case Goal::sag:
      if (!std::isfinite(more)) return false;
      limits_.sag = *limits_.sag * (1 - slack::give_tightening) - more;
      return *limits_.sag > 0;
    default: return false;
  }
}

double DesignProblem::goal_scale() const {
  switch (goal_) {
    case Goal::transmission: return 1;
    case Goal::footprint: return layout_.unit * layout_.unit;
    case Goal::copy_error:
      return std::max(space_.spec().tolerance->length + space_.spec().tolerance->play,
                      slack::least_error_scale);
    case Goal::load_error:
    case Goal::mass: return goal_scale_;
    default: return layout_.unit;
  }
}

double DesignProblem::violation_of(const Attained& has) const {
  const double unit = layout_.unit;
  double sum = missing(limits_.transmission, has.transmission);
  sum += missing(limits_.clearance, has.clearance) / unit;
  sum += missing(limits_.shortest * (1 - slack::limit_rounding), has.shortest) / unit;
  sum += missing(has.longest * (1 - slack::limit_rounding), limits_.longest) / unit;
  sum += missing(has.pole_margin, limits_.pole_margin + slack::limit_rounding * unit) / unit;
  if (limits_.size) sum += missing(has.size, *limits_.size) / unit;
  if (limits_.load_error && load_error_) sum += excess_share(has.load_error, *limits_.load_error);
  if (limits_.mass) sum += excess_share(has.mass, *limits_.mass);
  if (limits_.sag && sag_) sum += excess_share(has.sag, *limits_.sag);
  if (limits_.footprint) sum += missing(has.footprint, *limits_.footprint) / (unit * unit);
  if (limits_.copy_gap) sum += missing(*limits_.copy_gap, has.copy_gap) / unit;
  return sum;
}

Assessment DesignProblem::assess(const DesignPoint& point, int openings, LoadLimit load,
                                 SmallestGaps* shared) const {
  Assessment result;
  Attained& has = result.attained;
  const LogLengths& lengths = point.lengths;
  const double unit = layout_.unit, VA = std::exp(lengths.u), VB = std::exp(lengths.v);
  const DistanceRange distances = space_.distances(point.pole);
  result.near_opening = reach_.opening_at(lengths, std::max(distances.nearest, 0.0));
  result.far_opening = reach_.opening_at(lengths, distances.farthest);
  const Reach::LengthFactors& f = reach_.factors();
  has.size = f.size_per_VA * VA + f.size_per_VB * VB;
  has.shortest = std::min(VA * f.least_of_VA, VB * f.least_of_VB);
  has.longest = std::max(VA * f.most_of_VA, VB * f.most_of_VB);
  has.transmission =
      std::min(reach_.from_near_end(result.near_opening), reach_.from_far_end(result.far_opening));
  has.pole_margin = space_.pole_distance(point.pole);
  const double far = far_apart * unit;
  const double enough =
      goal_ == Goal::clearance ? far : std::min(far, limits_.clearance);  // more counts for nothing
  has.clearance = smallest_gap(lengths, result.near_opening, result.far_opening, openings, enough);
  if (!terms_.obstacles.empty()) has.clearance = smallest_obstacle_gap(point, has.clearance, shared);
  if (goal_ == Goal::footprint || limits_.footprint) has.footprint = footprint_at(point);
  if (limits_.copy_gap || goal_ == Goal::copy_gap)
    has.copy_gap = space_.smallest_copy_gap(point.pole).distance;
  if (copy_error_)
    has.copy_error =
        std::max(copy_error_->at(result.near_opening).worst, copy_error_->at(result.far_opening).worst);
  if (load_error_ && !(has_load_limit() && load == LoadLimit::left_out)) {
    const bool is_first = has_load_limit() && openings <= search_openings;
    has.load_error = load_error_over(lengths, result.near_opening, result.far_opening,
                                     is_first ? first_load_openings : row_parts::load_openings);
  }
  if (mass_) has.mass = mass_at(lengths);
  if (sag_) has.sag = sag_over(lengths, result.near_opening, result.far_opening);
  // Where opening_at() had to clamp, the linkage does not reach: count what is missing.
  const double too_near = missing(
      reach_.radius_value(lengths, result.near_opening) - slack::reach_rounding * unit, distances.nearest);
  const double too_far = missing(
      distances.farthest, reach_.radius_value(lengths, result.far_opening) + slack::reach_rounding * unit);
  result.violation = (too_near + too_far) / unit + violation_of(has);
  result.feasible = result.violation == 0;
  result.cost = cost_of(has);
  return result;
}

Assessment DesignProblem::count_load_error(Assessment seen, const DesignPoint& point) const {
  seen.attained.load_error =
      load_error_over(point.lengths, seen.near_opening, seen.far_opening, first_load_openings);
  if (limits_.load_error) seen.violation += excess_share(seen.attained.load_error, *limits_.load_error);
  seen.feasible = seen.violation == 0;
  return seen;
}

DesignVector DesignProblem::vector_of(const DesignPoint& point) const {
  DesignVector x(layout_.size());
  const DistanceRange distances = space_.distances(point.pole);
  x[DesignLayout::log_VA] = point.lengths.u;
  x[DesignLayout::log_VB] = point.lengths.v;
  x[DesignLayout::near_opening] = reach_.opening_at(point.lengths, std::max(distances.nearest, 0.0));
  x[DesignLayout::far_opening] = reach_.opening_at(point.lengths, distances.farthest);
  layout_.set_pole(x, point.pole);
  if (goal_ == Goal::transmission)
    x[layout_.goal()] = std::min(reach_.from_near_end(x[DesignLayout::near_opening]),
                                 reach_.from_far_end(x[DesignLayout::far_opening]));
  else if (layout_.has_goal)
    x[layout_.goal()] = goal_in_vector(assess(point, search_openings).attained.of(goal_));
  return x.cwiseMax(lower_bounds()).cwiseMin(upper_bounds());
}

DesignPoint DesignProblem::point_of(const DesignVector& x) const {
  return {{x[DesignLayout::log_VA], x[DesignLayout::log_VB]}, layout_.pole(x)};
}

double DesignProblem::goal_in_vector(double value) const {
  switch (goal_) {
    case Goal::transmission: return value;
    case Goal::copy_error: return value / goal_scale();
    case Goal::load_error: return std::log(value / goal_scale());
    case Goal::shortest:
    case Goal::longest: return std::log(value);
    default: return value / layout_.unit;
  }
}

DesignVector DesignProblem::lower_bounds() const {
  DesignVector bound(layout_.size());
  bound.head<4>() << box_.u.lower, box_.v.lower, allowed_.lower, allowed_.lower;
  if (layout_.pole_is_free)
    bound.segment<2>(DesignLayout::pole_x) = (pole_box().lower - layout_.origin) / layout_.unit;
  if (layout_.has_goal) bound[layout_.goal()] = goal_ == Goal::transmission ? 0 : -far_apart;
  return bound;
}

DesignVector DesignProblem::upper_bounds() const {
  DesignVector bound(layout_.size());
  bound.head<4>() << box_.u.upper, box_.v.upper, allowed_.upper, allowed_.upper;
  if (layout_.pole_is_free)
    bound.segment<2>(DesignLayout::pole_x) = (pole_box().upper - layout_.origin) / layout_.unit;
  if (layout_.has_goal) bound[layout_.goal()] = goal_ == Goal::transmission ? pi / 2 : far_apart;
  return bound;
}

}  // namespace kempe
