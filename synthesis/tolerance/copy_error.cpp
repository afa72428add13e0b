// Notation: frame with bar VA along x, e = exp(i d) the direction of bar VB, w . e the component of w along
// VB. The loops' deviation D of each source (docs/tolerance.md), all times the output factor 1, 1 or 1/(s-1):
//   VA  (1-s)(1 - i cot d)             VB  i(1-s)/sin d
//   AC  e (1 - s xi_AC) - i(1-s)/sin d BC  eta_BC - 1 + i(1-s) cot d
//   AX, CX  -s xi e                    BY, CY  eta
//   pin A  (1-s)(w - i l)  pins B, V  i(1-s) l  pin C  w - i(1-s) l   with l = (w . e)/sin d = Im w + Re w
//   cot d pole   (1-s)(w - i l) at V, else s w

#include "synthesis/tolerance/copy_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/complex_vectors.hpp"
#include "synthesis/solvers/golden_section.hpp"
#include "synthesis/tolerance/slack.hpp"

namespace kempe {
namespace {

Complex unit(Complex z) { return z / std::abs(z); }

/// Displacement of a plate's third hole, at `hole` in the frame whose x axis runs from the corner to C at
/// distance 1, by the lengths corner - C, corner - hole, C - hole; of a flat plate the last is the distance
/// out of line.
std::array<Complex, 3> hole_displacements(Complex hole, bool flat) {
  const Complex from_corner = unit(hole);
  if (flat) return {0, from_corner, i_unit * from_corner};
  const Complex from_C = unit(hole - 1.0);
  const double sine = cross(from_corner, from_C);
  const Complex by_corner = -i_unit * from_C / sine, by_C = i_unit * from_corner / sine;
  return {by_C * from_C.real(), by_corner, by_C};
}

/// Sum of absolute terms along a direction, and the deviation that reaches it.
struct Support {
  double value;
  Complex deviation;
};

Support support(const Sensitivities& g, const CopyTolerance& tolerance, Complex direction) {
  Support sum{0, 0};
  for (std::size_t j = 0; j < 8; ++j) {
    const double along = dot(direction, g.length[j]);
    sum.value += std::abs(along) * tolerance.length[j];
    sum.deviation += std::copysign(tolerance.length[j], along) * g.length[j];
  }
  for (std::size_t j = 0; j < 5; ++j) {
    const double radius = 0.5 * tolerance.play[j];
    if (radius == 0) continue;
    const double x = dot(direction, g.play[j][0]), y = dot(direction, g.play[j][1]);
    const double length = std::hypot(x, y);
    if (length == 0) continue;
    sum.value += radius * length;
    sum.deviation += radius / length * (x * g.play[j][0] + y * g.play[j][1]);
  }
  return sum;
}

/// Directions between which the deviations have not been bounded well enough yet.
struct Sector {
  double lower, upper;              // angles, rad
  double lower_value, upper_value;  // support there

  /// No deviation in a direction of the sector is longer: the corner where the two supporting lines meet.
  double bound() const {
    const double turn = upper - lower, cosine = std::cos(turn);
    if (lower_value <= upper_value * cosine || upper_value <= lower_value * cosine)
      return std::max(lower_value, upper_value);
    return std::sqrt(lower_value * lower_value + upper_value * upper_value -
                     2 * lower_value * upper_value * cosine) /
           std::sin(turn);
  }
  /// Direction of that corner, kept off the ends.
  double corner() const {
    const double turn = upper - lower;
    const double angle = std::atan2(upper_value - lower_value * std::cos(turn), lower_value * std::sin(turn));
    return lower + std::clamp(angle, 0.1 * turn, 0.9 * turn);
  }
};

double sum_of_squares(const Sensitivities& g, const CopyTolerance& tolerance) {
  double sum = 0;
  for (std::size_t j = 0; j < 8; ++j)
    sum += tolerance.length[j] * tolerance.length[j] * std::norm(g.length[j]);
  for (std::size_t j = 0; j < 5; ++j)  // a random direction has half its square along each axis
    sum +=
        0.125 * tolerance.play[j] * tolerance.play[j] * (std::norm(g.play[j][0]) + std::norm(g.play[j][1]));
  return sum;
}

double sum_of_squares_slope(const Sensitivities& g, const Sensitivities& slope,
                            const CopyTolerance& tolerance) {
  double sum = 0;
  for (std::size_t j = 0; j < 8; ++j)
    sum += 2 * tolerance.length[j] * tolerance.length[j] * dot(g.length[j], slope.length[j]);
  for (std::size_t j = 0; j < 5; ++j)
    sum += 0.25 * tolerance.play[j] * tolerance.play[j] *
           (dot(g.play[j][0], slope.play[j][0]) + dot(g.play[j][1], slope.play[j][1]));
  return sum;
}

/// d support / d opening at a fixed direction (Danskin: also the slope of the largest support over
/// directions).
double support_slope(const Sensitivities& g, const Sensitivities& slope, const CopyTolerance& tolerance,
                     Complex direction) {
  double sum = 0;
  for (std::size_t j = 0; j < 8; ++j)
    sum += std::copysign(tolerance.length[j], dot(direction, g.length[j])) * dot(direction, slope.length[j]);
  for (std::size_t j = 0; j < 5; ++j) {
    const double x = dot(direction, g.play[j][0]), y = dot(direction, g.play[j][1]);
    const double length = std::hypot(x, y);
    if (length == 0) continue;
    sum += 0.5 * tolerance.play[j] *
           (x * dot(direction, slope.play[j][0]) + y * dot(direction, slope.play[j][1])) / length;
  }
  return sum;
}

/// Largest value of a function over an interval: a grid, then the golden section about the grid's best if it
/// is inside.
template <class Function>
double place_of_largest(const OpeningInterval& openings, Function value) {
  constexpr int steps = 16;
  const auto at = [&](int j) {
    return j == steps ? openings.upper : openings.lower + openings.width() * j / steps;
  };
  int best = 0;
  double best_value = value(at(0));
  for (int j = 1; j <= steps; ++j) {
    const double here = value(at(j));
    if (here > best_value) {
      best = j;
      best_value = here;
    }
  }
  if (best == 0 || best == steps) return at(best);
  const double refined = top_by_golden_section(value, at(best - 1), at(best + 1), 40);
  return value(refined) > best_value ? refined : at(best);
}

}  // namespace

std::string_view error_source_name(std::size_t source, bool flat) {
  if (flat && source == 5) return "X out of line A-C";
  if (flat && source == 7) return "Y out of line B-C";
  if (source < 8) return LinkLengths::names[source];
  constexpr std::array<std::string_view, 5> pins{"play of the pole", "play at V", "play at A", "play at B",
                                                 "play at C"};
  return pins[source - 8];
}

CopyTolerance CopyTolerance::uniform(const Tolerance& tolerance) {
  CopyTolerance all;
  all.length.fill(tolerance.length);
  all.play.fill(tolerance.play);
  return all;
}

bool is_flat(Complex shape) {
  constexpr double flattest = 0.05;  // height over the longest side, as a share of the shortest
  std::array<double, 3> side{1, std::abs(shape), std::abs(1.0 - shape)};
  std::sort(side.begin(), side.end());
  const double height = std::abs(shape.imag()) / side[2];
  return height < flattest * side[0];
}

Sensitivities Sensitivities::turned(Complex turn) const {
  Sensitivities result;
  for (std::size_t j = 0; j < 8; ++j) result.length[j] = turn * length[j];
  for (std::size_t j = 0; j < 5; ++j)
    result.play[j] = {turn * (turn.real() * play[j][0] - turn.imag() * play[j][1]),
                      turn * (turn.imag() * play[j][0] + turn.real() * play[j][1])};
  return result;
}

CopyErrorProfile::CopyErrorProfile(Complex k, Grounding grounding, const CopyTolerance& tolerance)
    : pole_is_at_V_(pole_is_at_V(grounding)), pen_is_at_V_(pen_is_at_V(grounding)), tolerance_(tolerance),
      k_(k), s_(shape_of(k, grounding)), output_(pen_is_at_V(grounding) ? -k : 1.0), flat_(is_flat(s_)),
      xi_(hole_displacements(1.0 / s_, flat_)), eta_(hole_displacements(s_, flat_)) {}

Sensitivities CopyErrorProfile::sensitivities(double opening) const {
  const Complex e = std::polar(1.0, opening), one{1, 0};
  const double sine = std::copysign(std::max(std::abs(e.imag()), slack::smallest_sine), e.imag());
  const double cot = e.real() / sine;
  const Complex side = i_unit * (1.0 - s_);  // i(1-s)
  const std::array<Complex, 2> stretch_VA{(1.0 - s_) - side * cot, 0}, stretch_VB{side * cot, side};
  Sensitivities g;
  g.length = {stretch_VA[0],
              side / sine,
              e * (1.0 - s_ * xi_[0]) - side / sine,
              eta_[0] - 1.0 + side * cot,
              -s_ * xi_[1] * e,
              -s_ * xi_[2] * e,
              eta_[1],
              eta_[2]};
  const std::array<Complex, 2> pole = pole_is_at_V_ ? stretch_VA : std::array{s_, i_unit * s_};
  g.play = {pole, stretch_VB, stretch_VA, stretch_VB, {one - side * cot, i_unit - side}};
  for (Complex& each : g.length) each *= output_;
  for (auto& pair : g.play)
    for (Complex& each : pair) each *= output_;
  return g;
}

Sensitivities CopyErrorProfile::sensitivity_slopes(double opening) const {
  const Complex e = std::polar(1.0, opening);
  const double sine = std::copysign(std::max(std::abs(e.imag()), slack::smallest_sine), e.imag());
  const double cosecant_slope = -e.real() / sine / sine, cot_slope = -1 / sine / sine;
  const Complex side = i_unit * (1.0 - s_), turning = i_unit * e;
  const std::array<Complex, 2> stretch_VA{-side * cot_slope, 0}, stretch_VB{side * cot_slope, 0};
  Sensitivities g;
  g.length = {stretch_VA[0],
              side * cosecant_slope,
              turning * (1.0 - s_ * xi_[0]) - side * cosecant_slope,
              side * cot_slope,
              -s_ * xi_[1] * turning,
              -s_ * xi_[2] * turning,
              0,
              0};
  const std::array<Complex, 2> pole = pole_is_at_V_ ? stretch_VA : std::array<Complex, 2>{};
  g.play = {pole, stretch_VB, stretch_VA, stretch_VB, {-side * cot_slope, 0}};
  for (Complex& each : g.length) each *= output_;
  for (auto& pair : g.play)
    for (Complex& each : pair) each *= output_;
  return g;
}

namespace {

/// The longest deviation; or, where one is longer than `enough`, one that is.
LongestDeviation longest_or_enough(const Sensitivities& sensitivities, const CopyTolerance& tolerance,
                                   double enough) {
  constexpr int first_sectors = 8, evaluations_allowed = 400;
  LongestDeviation best;
  int evaluations = 0;
  const auto evaluate = [&](double angle) {
    const Support here = support(sensitivities, tolerance, std::polar(1.0, angle));
    const double length = std::abs(here.deviation);
    if (length > best.length) best = {length, here.deviation / length};
    ++evaluations;
    return here.value;
  };
  // The set of deviations is symmetric about 0: half a turn of directions is enough.
  std::vector<Sector> open;
  open.reserve(32);
  const double first_value = evaluate(0);
  double value = first_value;
  for (int j = 0; j < first_sectors; ++j) {
    const double next = j + 1 == first_sectors ? first_value : evaluate(pi * (j + 1) / first_sectors);
    open.push_back({pi * j / first_sectors, pi * (j + 1) / first_sectors, value, next});
    value = next;
  }
  const double of_interest = std::isfinite(enough) ? enough : 0;
  while (!open.empty() && evaluations < evaluations_allowed && best.length <= enough) {
    const Sector sector = open.back();
    open.pop_back();
    if (sector.bound() <= std::max(slack::close_enough * best.length, of_interest)) continue;
    const double middle = sector.corner();
    const double here = evaluate(middle);
    open.push_back({sector.lower, middle, sector.lower_value, here});
    open.push_back({middle, sector.upper, here, sector.upper_value});
  }
  // To rounding, for the slopes' sake: of all deviations the one farthest along the best one is no shorter.
  for (double before = 0;
       best.length > before && best.length <= enough && evaluations < evaluations_allowed;) {
    before = best.length;
    evaluate(std::arg(best.direction));
  }
  return best;
}

}  // namespace

LongestDeviation longest_deviation(const Sensitivities& sensitivities, const CopyTolerance& tolerance) {
  return longest_or_enough(sensitivities, tolerance, std::numeric_limits<double>::infinity());
}

CopyErrorAt CopyErrorProfile::at(double opening) const {
  const Sensitivities g = sensitivities(opening), slope = sensitivity_slopes(opening);
  const LongestDeviation longest = longest_deviation(g, tolerance_);
  const double rss = std::sqrt(sum_of_squares(g, tolerance_));
  return {.worst = longest.length,
          .rss = rss,
          .worst_slope = support_slope(g, slope, tolerance_, longest.direction),
          .rss_slope = rss > 0 ? 0.5 * sum_of_squares_slope(g, slope, tolerance_) / rss : 0,
          .direction = longest.direction};
}

CopyErrorProfile::Largest CopyErrorProfile::largest(const OpeningInterval& openings) const {
  Largest result;
  result.worst_opening = place_of_largest(
      openings, [&](double d) { return longest_deviation(sensitivities(d), tolerance_).length; });
  result.rss_opening =
      place_of_largest(openings, [&](double d) { return sum_of_squares(sensitivities(d), tolerance_); });
  result.worst = at(result.worst_opening);
  result.rss = at(result.rss_opening);
  return result;
}

std::vector<OpeningInterval> CopyErrorProfile::openings_within(double limit,
                                                               const OpeningInterval& within) const {
  std::vector<OpeningInterval> result;
  if (within.empty()) return result;
  const int steps = std::max(8, static_cast<int>(std::ceil(within.width() / radians(0.5))));
  const auto kept = [&](double d) {
    return longest_or_enough(sensitivities(d), tolerance_, limit).length <= limit;
  };
  const auto edge = [&](double inside, double outside) {
    for (int j = 0; j < 50; ++j) {
      const double middle = 0.5 * (inside + outside);
      (kept(middle) ? inside : outside) = middle;
    }
    return inside;
  };
  double before = within.lower;
  bool was_kept = kept(before);
  if (was_kept) result.push_back({before, before});
  for (int j = 1; j <= steps; ++j) {
    const double here = j == steps ? within.upper : within.lower + within.width() * j / steps;
    const bool is_kept = kept(here);
    if (is_kept && !was_kept) result.push_back({edge(here, before), here});
    if (!is_kept && was_kept) result.back().upper = edge(before, here);
    if (is_kept) result.back().upper = here;
    before = here;
    was_kept = is_kept;
  }
  return result;
}

double CopyErrorProfile::slope_at_most(double sine) const {
  const auto& t = tolerance_.length;
  const auto& play = tolerance_.play;
  const double loop = std::abs(1.0 - s_) / (sine * sine);
  const double pole = pole_is_at_V_ ? 0.5 * play[0] * loop : 0;
  const double bars =
      loop * (t[0] + t[1] + t[2] + t[3] + 0.5 * (play[1] + play[2] + play[3] + play[4])) + pole;
  const double turning =
      std::abs(1.0 - s_ * xi_[0]) * t[2] + std::abs(s_ * xi_[1]) * t[4] + std::abs(s_ * xi_[2]) * t[5];
  return std::abs(output_) * (bars + turning);
}

OpeningInterval CopyErrorProfile::openings_not_ruled_out(double limit, const OpeningInterval& within) const {
  constexpr int most_steps = 4000;
  if (within.empty()) return {};
  // From an end inwards: as far as the error is proven to be above the limit. How far is guessed by its largest slope.
  const auto advance = [&](double end, double direction, double other) {
    double here = end, step = 0;
    for (int steps = 0; (other - here) * direction > 0; ++steps) {
      const double sine = std::max(std::abs(std::sin(here)), slack::at_change_point);
      const double excess = longest_deviation(sensitivities(here), tolerance_).length - limit;
      step = std::max(2 * step, std::min(0.5 * sine, excess / slope_at_most(0.5 * sine)));
      const auto ruled_out = [&] {
        const double last = (other - here) * direction < step ? other : here + direction * step;
        return surely_exceeds(
            limit, {std::min(here, last) - slack::beyond_end, std::max(here, last) + slack::beyond_end});
      };
      while (step >= slack::finest * sine && !ruled_out()) step *= 0.5;
      if (!(step >= slack::finest * sine) || steps > most_steps) return here;
      here += direction * step;
    }
    return other;
  };
  const double lower = advance(within.lower, 1, within.upper);
  if (lower >= within.upper) return {};
  const OpeningInterval left{lower, advance(within.upper, -1, lower)};
  return left.empty() ? OpeningInterval{} : left;
}

CopyErrorProfile copy_error_profile(const CopyingLinkage& linkage, const CopyTolerance& tolerance) {
  return CopyErrorProfile(linkage.k(), linkage.grounding(), tolerance);
}

}  // namespace kempe
