#include "synthesis/tolerance/corner_error.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/complex_vectors.hpp"
#include "synthesis/solvers/golden_section.hpp"
#include "synthesis/tolerance/slack.hpp"

namespace kempe {
namespace {

Complex unit_along(Complex z) { return z / std::abs(z); }

/// The third hole of a plate whose corner is at 0 and whose joint C is at `to_C` on the x axis, on the side of `drawn`.
std::optional<Complex> hole_by_lengths(Complex drawn, double to_C, double to_hole, double from_C) {
  const double along = 0.5 * to_C + (to_hole - from_C) * (to_hole + from_C) / (2 * to_C);
  const double height_squared = (to_hole - along) * (to_hole + along);
  if (!(height_squared > 0)) return std::nullopt;
  return Complex(along, std::copysign(std::sqrt(height_squared), drawn.imag()));
}

/// A plate as made, in the frame of its corner (A or B): C at `C` on the x axis, X or Y at `hole`.
struct MadePlate {
  double C = 0;
  Complex hole{};
};

/// From the corner to C, from the corner to the hole, from C to the hole; of a flat plate the last is the distance out of line.
std::optional<MadePlate> made_plate(Complex drawn, bool flat, double to_C, double to_hole, double last) {
  if (flat) return MadePlate{to_C, unit_along(drawn) * Complex(to_hole, last)};
  const auto hole = hole_by_lengths(drawn, to_C, to_hole, last);
  return hole ? std::optional(MadePlate{to_C, *hole}) : std::nullopt;
}

/// The joint at two lengths from two places, on the given side of the line between them.
std::optional<Complex> joint_between(Complex from, Complex to, double a, double b, Side side) {
  const double apart = std::abs(to - from);
  const double along = 0.5 * apart + (a - b) * (a + b) / (2 * apart);
  const double height_squared = (a - along) * (a + along);
  if (!(height_squared > 0)) return std::nullopt;
  return from + (to - from) / apart * Complex(along, sign(side) * std::sqrt(height_squared));
}

/// A tolerance's corner that lies farthest in one direction, to the first order.
InstrumentErrors corner_towards(const Sensitivities& g, const CopyTolerance& tolerance, Complex direction) {
  InstrumentErrors errors;
  for (std::size_t j = 0; j < 8; ++j)
    errors.length[j] = std::copysign(tolerance.length[j], dot(direction, g.length[j]));
  for (std::size_t j = 0; j < 5; ++j) {
    const Complex towards{dot(direction, g.play[j][0]), dot(direction, g.play[j][1])};
    const double length = std::abs(towards);
    if (length > 0) errors.pin[j] = 0.5 * tolerance.play[j] / length * towards;
  }
  return errors;
}

/// Looks for the worst instrument of one drawing.
class CornerSearch {
 public:
  CornerSearch(const CopyingLinkage& linkage, const CopyTolerance& tolerance)
      : linkage_(linkage), tolerance_(tolerance), made_(linkage),
        profile_(copy_error_profile(linkage, tolerance)) {}

  struct Found {
    double error = -1;  // mm; below 0: none closes
    double opening = 0;
    InstrumentErrors errors{};
  };

  /// The worst of the corners of twelve directions, the first order's worst and its mirror among them.
  Found first_at(double opening) {
    constexpr int directions = 12;
    const Pose pose = linkage_.pose_at(opening, 0);
    const Complex VA_direction = unit_along(as_complex(pose.A - pose.V));
    const Sensitivities g = profile_.sensitivities(opening).turned(VA_direction);
    const Complex worst = profile_.at(opening).direction * VA_direction;
    Found best{.opening = opening};
    for (int n = 0; n < directions; ++n) {
      const InstrumentErrors errors =
          corner_towards(g, tolerance_, worst * std::polar(1.0, 2 * pi * n / directions));
      take_if_worse(errors, best);
    }
    return best;
  }

  /// Moves one error after the other to where the deviation is longer.
  void climb(Found& found) {
    constexpr int most_rounds = 20;
    if (found.error < 0) return;
    bool longer = true;
    for (int round = 0; longer && round < most_rounds; ++round) {
      longer = false;
      for (std::size_t j = 0; j < 8; ++j) longer |= tolerance_.length[j] > 0 && turn_length(j, found);
      for (std::size_t j = 0; j < 5; ++j) longer |= tolerance_.play[j] > 0 && turn_pin(j, found);
    }
  }

  double error_of(const InstrumentErrors& errors, double opening) {
    const auto deviation = made_.deviation(errors, linkage_.radius_at(opening));
    closes_ = closes_ && deviation;
    return deviation ? std::abs(*deviation) : -1;
  }
  bool closes() const { return closes_; }

 private:
  bool take_if_worse(const InstrumentErrors& errors, Found& found) {
    const double error = error_of(errors, found.opening);
    if (!(error > found.error * slack::close_enough) || error < 0) return false;
    found.error = error;
    found.errors = errors;
    return true;
  }

  bool turn_length(std::size_t j, Found& found) {
    InstrumentErrors other = found.errors;
    other.length[j] = -other.length[j];
    return take_if_worse(other, found);
  }

  /// To the wall of its hole, along the slope of the deviation's length.
  bool turn_pin(std::size_t j, Found& found) {
    const double radius = 0.5 * tolerance_.play[j], step = slack::pin_step * radius;
    const auto slope = [&](Complex along) {
      InstrumentErrors ahead = found.errors, behind = found.errors;
      ahead.pin[j] += step * along;
      behind.pin[j] -= step * along;
      const double upper = error_of(ahead, found.opening), lower = error_of(behind, found.opening);
      return upper < 0 || lower < 0 ? 0 : upper - lower;
    };
    const Complex towards{slope(1), slope(i_unit)};
    if (towards == Complex{}) return false;
    InstrumentErrors other = found.errors;
    other.pin[j] = radius * unit_along(towards);
    return take_if_worse(other, found);
  }

  const CopyingLinkage& linkage_;
  const CopyTolerance& tolerance_;
  MadeInstruments made_;
  CopyErrorProfile profile_;
  bool closes_ = true;
};

/// The least height of a plate over the line from its corner to C, as a share of that drawn, with each length at either of its limits; 0:
/// there may be no triangle.
double least_height(std::array<double, 3> drawn, std::array<double, 3> off) {
  const auto height_of = [](double to_C, double to_hole, double from_C) {
    const auto hole = hole_by_lengths(i_unit, to_C, to_hole, from_C);
    return hole ? hole->imag() : 0.0;
  };
  double least = height_of(drawn[0], drawn[1], drawn[2]);
  const double as_drawn = least;
  for (unsigned corner = 0; corner < 8; ++corner) {
    std::array<double, 3> made = drawn;
    for (std::size_t i = 0; i < 3; ++i) made[i] += (corner >> i & 1U) != 0 ? off[i] : -off[i];
    least = std::min(least, height_of(made[0], made[1], made[2]));
  }
  return as_drawn > 0 ? least / as_drawn : 0;
}

PlateAtRisk risk_of(std::string_view plate, std::array<double, 3> drawn, std::array<double, 3> off) {
  const double longest = *std::max_element(drawn.begin(), drawn.end());
  return {plate, (drawn[0] + drawn[1] + drawn[2] - 2 * longest) / 3, 1 - least_height(drawn, off)};
}

}  // namespace

MadeInstruments::MadeInstruments(const CopyingLinkage& linkage)
    : grounding_(linkage.grounding()), k_(linkage.k()), shape_(linkage.shape()),
      flat_(is_flat(linkage.shape())), lengths_(linkage.lengths().values()),
      sides_(instrument_of(linkage).sides) {}

std::optional<Complex> MadeInstruments::deviation(const InstrumentErrors& errors, double distance) const {
  enum Length : std::size_t { VA, VB, AC, BC, AX, CX, BY, CY };
  const auto length = [&](Length which) { return lengths_[which] + errors.length[which]; };
  const auto last = [&](Length which) { return flat_ ? errors.length[which] : length(which); };
  const auto pin = [&](PinConnection which) { return errors.pin[static_cast<std::size_t>(which)]; };
  const auto ACX = made_plate(1.0 / shape_, flat_, length(AC), length(AX), last(CX));
  const auto BCY = made_plate(shape_, flat_, length(BC), length(BY), last(CY));
  if (!ACX || !BCY) return std::nullopt;
  const Complex tracer = distance, image = k_ * tracer;
  const Complex at_A = pin(PinConnection::A), at_B = pin(PinConnection::B), at_C = pin(PinConnection::C),
                at_V = pin(PinConnection::V), pole = pin(PinConnection::pole);
  if (pen_is_at_V(grounding_)) {
    const auto C = joint_between(pole + at_C, tracer, std::abs(ACX->hole - ACX->C),
                                 std::abs(BCY->hole - BCY->C), sides_.C_of_XY);
    if (!C) return std::nullopt;
    const Complex C_of_ACX = *C - at_C;
    const Complex A = pole + (C_of_ACX - pole) * ACX->hole / (ACX->hole - ACX->C);
    const Complex B = tracer + (*C - tracer) * BCY->hole / (BCY->hole - BCY->C);
    const auto V = joint_between(A - at_A, B - at_B - at_V, length(VA), length(VB), sides_.V_of_AB);
    return V ? std::optional(*V - image) : std::nullopt;
  }
  const bool pole_at_V = pole_is_at_V(grounding_);
  const Complex X = pole_at_V ? tracer : pole;
  const Complex V_of_VA = pole_at_V ? pole : tracer, V_of_VB = pole_at_V ? at_V : tracer + at_V;
  const auto A = joint_between(V_of_VA, X - at_A, length(VA), std::abs(ACX->hole), sides_.A_of_VX);
  if (!A) return std::nullopt;
  const Complex A_of_ACX = *A + at_A;
  const Complex C = A_of_ACX + (X - A_of_ACX) * ACX->C / ACX->hole + at_C;  // BCY's hole
  const auto B = joint_between(V_of_VB, C - at_B, length(VB), BCY->C, sides_.B_of_VC);
  if (!B) return std::nullopt;
  const Complex B_of_BCY = *B + at_B;
  return B_of_BCY + (C - B_of_BCY) * BCY->hole / BCY->C - image;
}

CornerError corner_error(const CopyingLinkage& linkage, const CopyTolerance& tolerance,
                         const OpeningInterval& openings) {
  constexpr int steps = 16, refinements = 30;
  CornerSearch search(linkage, tolerance);
  const auto opening_at = [&](int j) {
    return j == steps ? openings.upper : openings.lower + openings.width() * j / steps;
  };
  CornerSearch::Found worst;
  int worst_at = 0;
  for (int j = 0; j <= steps; ++j) {
    CornerSearch::Found found = search.first_at(opening_at(j));
    search.climb(found);
    if (!(found.error > worst.error * slack::close_enough)) continue;
    worst = found;
    worst_at = j;
  }
  if (worst.error > 0 && openings.width() > 0) {
    // One instrument between the neighbouring openings; then its errors once more.
    CornerSearch::Found between = worst;
    between.opening = top_by_golden_section(
        [&](double opening) { return search.error_of(worst.errors, opening); },
        opening_at(std::max(0, worst_at - 1)), opening_at(std::min(steps, worst_at + 1)), refinements);
    between.error = search.error_of(worst.errors, between.opening);
    search.climb(between);
    if (between.error > worst.error) worst = between;
  }
  return {std::max(0.0, worst.error), worst.opening, search.closes()};
}

tl::expected<CornerError, Unreachable> corner_error_over(const CopyingLinkage& linkage,
                                                         const CopyTolerance& tolerance,
                                                         const RegionReach& region) {
  const DistanceRange range = region.range(linkage.pole());
  const auto near = linkage.opening_at(range.nearest), far = linkage.opening_at(range.farthest);
  if (!near) return tl::unexpected(near.error());
  if (!far) return tl::unexpected(far.error());
  return corner_error(linkage, tolerance, {std::min(*near, *far), std::max(*near, *far)});
}

bool first_order_understates(double worst, double at_corner) {
  return at_corner > worst * (1 + slack::second_order);
}

std::vector<PlateAtRisk> plates_at_risk(const CopyingLinkage& linkage, const CopyTolerance& tolerance) {
  std::vector<PlateAtRisk> plates;
  if (is_flat(linkage.shape())) return plates;
  const LinkLengths l = linkage.lengths();
  const auto& off = tolerance.length;
  for (const PlateAtRisk& plate : {risk_of("ACX", {l.AC, l.AX, l.CX}, {off[2], off[4], off[5]}),
                                   risk_of("BCY", {l.BC, l.BY, l.CY}, {off[3], off[6], off[7]})})
    if (plate.height_may_lose >= slack::height_at_risk) plates.push_back(plate);
  return plates;
}

}  // namespace kempe
