// Each loop is closed by dyads, the play e of a pin connection between two holes of it (docs/robust.md):
//   pole at V     V_VA = e_pole, V_VB = e_V, X = tracer;            tracer at V     X = e_pole, V_VA = tracer, V_VB = V_VA + e_V;
//   both: A_VA from V_VA and X - e_A, A_ACX = A_VA + e_A, C_ACX by the plate, C_BCY = C_ACX + e_C,
//         B_VB from V_VB and C_BCY - e_B, B_BCY = B_VB + e_B, Y by the plate
//   pen at V      X = e_pole, Y = tracer, C_BCY from X + e_C and Y, C_ACX = C_BCY - e_C, A_ACX and B_BCY by the plates,
//         A_VA = A_ACX - e_A, B_VB = B_BCY - e_B, V_VA from A_VA and B_VB - e_V, V_VB = V_VA + e_V
//
// Joint J of a dyad at distances a from P and b from Q, with w = Q - P, D = |w|^2:
//   J = P + w (f + i g),  f = (1 + (a^2 - b^2) / D) / 2,  g = side sqrt(((a + b)^2 - D) (D - (a - b)^2)) / (2 D)
//   with u = J - P, v = J - Q:   u . dJ = a da + u . dP,   v . dJ = b db + v . dQ,   u x v = D g
// Positive factors below the root prove that the dyad closes and keeps its side.

#include <algorithm>

#include "synthesis/tolerance/instrument_box.hpp"

namespace kempe {

namespace {

template <class Function>
BoxLength by_each(Interval value, Function slope) {
  BoxLength result;
  result.value = value;
  for (std::size_t i = 0; i < change_count; ++i) result.by[i] = slope(i);
  return result;
}

template <class Function>
BoxPlace place_by_each(IntervalComplex at, Function slope) {
  BoxPlace result;
  result.at = at;
  for (std::size_t i = 0; i < change_count; ++i) result.by[i] = slope(i);
  return result;
}

BoxLength operator+(const BoxLength& a, const BoxLength& b) {
  return by_each(a.value + b.value, [&](std::size_t i) { return a.by[i] + b.by[i]; });
}
BoxLength operator-(const BoxLength& a, const BoxLength& b) {
  return by_each(a.value - b.value, [&](std::size_t i) { return a.by[i] - b.by[i]; });
}
BoxLength operator*(const BoxLength& a, const BoxLength& b) {
  return by_each(a.value * b.value, [&](std::size_t i) { return a.by[i] * b.value + a.value * b.by[i]; });
}
BoxLength operator/(const BoxLength& a, const BoxLength& b) {
  const Interval quotient = a.value / b.value;
  return by_each(quotient, [&](std::size_t i) { return (a.by[i] - quotient * b.by[i]) / b.value; });
}
/// Of what is certainly positive.
BoxLength root(const BoxLength& a) {
  const Interval value = CGAL::sqrt(a.value), twice = Interval(2) * value;
  return by_each(value, [&](std::size_t i) { return a.by[i] / twice; });
}

BoxPlace operator+(const BoxPlace& u, const BoxPlace& v) {
  return place_by_each(u.at + v.at, [&](std::size_t i) { return u.by[i] + v.by[i]; });
}
BoxPlace operator/(const BoxPlace& u, const BoxPlace& v) {
  const IntervalComplex quotient = u.at / v.at;
  return place_by_each(quotient, [&](std::size_t i) { return (u.by[i] - quotient * v.by[i]) / v.at; });
}
BoxPlace complex_of(const BoxLength& re, const BoxLength& im) {
  return place_by_each({re.value, im.value}, [&](std::size_t i) {
    return IntervalComplex{re.by[i], im.by[i]};
  });
}
BoxPlace along_axis(const BoxLength& length) { return complex_of(length, BoxLength()); }
BoxPlace constant(const IntervalComplex& at) {
  BoxPlace result;
  result.at = at;
  return result;
}
BoxLength distance_of(const BoxPlace& z) {
  const Interval value = length(z.at);
  return by_each(value, [&](std::size_t i) { return (z.at.re * z.by[i].re + z.at.im * z.by[i].im) / value; });
}
BoxLength times(double factor, const BoxLength& a) {
  return by_each(Interval(factor) * a.value, [&](std::size_t i) { return Interval(factor) * a.by[i]; });
}

bool is_positive(const Interval& value) { return value.inf() > 0; }

Interval dot(const IntervalComplex& u, const IntervalComplex& v) { return u.re * v.re + u.im * v.im; }

/// The joint at distances a from P and b from Q, on the given side of the line from P to Q.
std::optional<BoxPlace> dyad(const BoxPlace& P, const BoxLength& a, const BoxPlace& Q, const BoxLength& b,
                             Side side) {
  const IntervalComplex w = Q.at - P.at;
  const Interval D = squared_length(w);
  const Interval not_too_far = CGAL::square(a.value + b.value) - D,
                 not_too_near = D - CGAL::square(a.value - b.value);
  if (!is_positive(D) || !is_positive(not_too_far) || !is_positive(not_too_near)) return std::nullopt;
  const Interval twice_area = Interval(0.5 * sign(side)) * CGAL::sqrt(not_too_far * not_too_near);
  const Interval f = (Interval(1) + (a.value - b.value) * (a.value + b.value) / D) / Interval(2),
                 g = twice_area / D;
  const IntervalComplex u = w * IntervalComplex{f, g}, v = w * IntervalComplex{f - Interval(1), g};
  return place_by_each(P.at + u, [&](std::size_t i) {
    const Interval at_P = a.value * a.by[i] + dot(u, P.by[i]), at_Q = b.value * b.by[i] + dot(v, Q.by[i]);
    return IntervalComplex{(v.im * at_P - u.im * at_Q) / twice_area,
                           (u.re * at_Q - v.re * at_P) / twice_area};
  });
}

/// A triangle of three lengths; `turn`: the side of its third hole, seen from its corner to C.
std::optional<BoxPlate> triangle(const BoxLength& a, const BoxLength& b, const BoxLength& c, Side turn) {
  const BoxLength factors[] = {a + b + c, b + c - a, a + c - b, a + b - c};
  for (const BoxLength& factor : factors)
    if (!is_positive(factor.value)) return std::nullopt;
  const BoxLength height =
      times(0.5 * sign(turn), root((factors[0] * factors[1]) * (factors[2] * factors[3])) / a);
  const BoxLength foot = times(0.5, a + (b - c) * (b + c) / a);
  return BoxPlate{a, b, c, complex_of(foot, height)};
}

/// A bar with its third hole along `direction` from the corner, out of line by `out`.
std::optional<BoxPlate> flat_plate(const BoxLength& a, const BoxLength& b, const BoxLength& out,
                                   const IntervalComplex& direction) {
  const BoxPlace third = complex_of(b, out) * constant(direction);
  const BoxPlace from_C = third - along_axis(a);
  if (!is_positive(a.value) || !is_positive(squared_length(third.at)) ||
      !is_positive(squared_length(from_C.at)))
    return std::nullopt;
  return BoxPlate{a, distance_of(third), distance_of(from_C), third};
}

IntervalComplex direction_of(Complex z, bool real) {
  if (real) return exactly(z.real() < 0 ? -1.0 : 1.0);
  const IntervalComplex nearly = widened(z);
  const Interval size = length(nearly);
  return {nearly.re / size, nearly.im / size};
}

}  // namespace

BoxPlace operator-(const BoxPlace& u, const BoxPlace& v) {
  return place_by_each(u.at - v.at, [&](std::size_t i) { return u.by[i] - v.by[i]; });
}
BoxPlace operator*(const BoxPlace& u, const BoxPlace& v) {
  return place_by_each(u.at * v.at, [&](std::size_t i) { return u.by[i] * v.at + u.at * v.by[i]; });
}
BoxPlace conjugate(BoxPlace z) {
  z.at.im = -z.at.im;
  for (IntervalComplex& slope : z.by) slope.im = -slope.im;
  return z;
}

InstrumentBox::InstrumentBox(const CopyingLinkage& linkage, const CopyTolerance& tolerance)
    : grounding_(linkage.grounding()), tolerance_(tolerance), shape_(linkage.shape()),
      flat_(is_flat(linkage.shape())), straight_(is_straight(linkage.shape())),
      lengths_(linkage.lengths().values()), loop_sides_(linkage.assembly_mode().sides) {
  dyad_sides_ = instrument_of(linkage).sides;
  const OutwardRounding rounding;
  drawn_ = links(false);
  every_ = links(true);
}

InstrumentBox::Links InstrumentBox::links(bool every) const {
  const auto range = [&](double limit) { return every ? Interval(-limit, limit) : Interval(0); };
  Links links;
  for (std::size_t i = 0; i < length_count; ++i) {
    const bool out_of_line = flat_ && (i == 5 || i == 7);
    links.lengths[i].value = Interval(out_of_line ? 0 : lengths_[i]) + range(tolerance_.length[i]);
    links.lengths[i].by[i] = Interval(1);
  }
  for (std::size_t i = 0; i < pin_count; ++i) {
    const Interval shift = range(0.5 * tolerance_.play[i]);
    links.pins[i].at = {shift, shift};
    links.pins[i].by[length_count + 2 * i] = exactly(1.0);
    links.pins[i].by[length_count + 2 * i + 1] = exactly(Complex(0, 1));
  }
  const auto& [VA, VB, AC, BC, AX, CX, BY, CY] = links.lengths;
  if (flat_) {
    const IntervalComplex to_Y = direction_of(shape_, straight_);
    links.ACX = flat_plate(AC, AX, CX, {to_Y.re, -to_Y.im});
    links.BCY = flat_plate(BC, BY, CY, to_Y);
  } else {
    links.ACX = triangle(AC, AX, CX, loop_sides_.plate_ACX);
    links.BCY = triangle(BC, BY, CY, loop_sides_.plate_BCY);
  }
  return links;
}

std::optional<BoxPose> InstrumentBox::posed(const Links& links, const Interval& distance) const {
  if (!links.ACX || !links.BCY) return std::nullopt;
  const auto pin = [&](PinConnection which) -> const BoxPlace& {
    return links.pins[static_cast<std::size_t>(which)];
  };
  const auto& [VA, VB, AC, BC, AX, CX, BY, CY] = links.lengths;
  const BoxPlate &one = *links.ACX, &two = *links.BCY;
  BoxPose pose;
  pose[Hole::tracer].at = {distance, Interval(0)};
  pose[Hole::tracer].by[distance_index] = exactly(1.0);
  const auto put = [&](Hole hole, const std::optional<BoxPlace>& place) {
    if (place) pose[hole] = *place;
    return place.has_value();
  };
  if (pen_is_at_V(grounding_)) {
    pose[Hole::X_ACX] = pin(PinConnection::pole);
    pose[Hole::Y_BCY] = pose[Hole::tracer];
    if (!put(Hole::C_BCY, dyad(pose[Hole::X_ACX] + pin(PinConnection::C), one.C_to_third, pose[Hole::Y_BCY],
                               two.C_to_third, dyad_sides_.C_of_XY)))
      return std::nullopt;
    pose[Hole::C_ACX] = pose[Hole::C_BCY] - pin(PinConnection::C);
    const auto corner = [](const BoxPlate& plate, const BoxPlace& C, const BoxPlace& third) {
      const BoxPlace to_C = along_axis(plate.corner_to_C);
      return C + (third - C) * (to_C / (to_C - plate.third));
    };
    pose[Hole::A_ACX] = corner(one, pose[Hole::C_ACX], pose[Hole::X_ACX]);
    pose[Hole::B_BCY] = corner(two, pose[Hole::C_BCY], pose[Hole::Y_BCY]);
    pose[Hole::A_VA] = pose[Hole::A_ACX] - pin(PinConnection::A);
    pose[Hole::B_VB] = pose[Hole::B_BCY] - pin(PinConnection::B);
    if (!put(Hole::V_VA,
             dyad(pose[Hole::A_VA], VA, pose[Hole::B_VB] - pin(PinConnection::V), VB, dyad_sides_.V_of_AB)))
      return std::nullopt;
    pose[Hole::V_VB] = pose[Hole::V_VA] + pin(PinConnection::V);
  } else {
    const bool pole_at_V = pole_is_at_V(grounding_);
    pose[Hole::V_VA] = pole_at_V ? pin(PinConnection::pole) : pose[Hole::tracer];
    pose[Hole::V_VB] = pole_at_V ? pin(PinConnection::V) : pose[Hole::V_VA] + pin(PinConnection::V);
    pose[Hole::X_ACX] = pole_at_V ? pose[Hole::tracer] : pin(PinConnection::pole);
    if (!put(Hole::A_VA, dyad(pose[Hole::V_VA], VA, pose[Hole::X_ACX] - pin(PinConnection::A),
                              one.corner_to_third, dyad_sides_.A_of_VX)))
      return std::nullopt;
    pose[Hole::A_ACX] = pose[Hole::A_VA] + pin(PinConnection::A);
    pose[Hole::C_ACX] = pose[Hole::A_ACX] +
                        (pose[Hole::X_ACX] - pose[Hole::A_ACX]) * (along_axis(one.corner_to_C) / one.third);
    pose[Hole::C_BCY] = pose[Hole::C_ACX] + pin(PinConnection::C);
    if (!put(Hole::B_VB, dyad(pose[Hole::V_VB], VB, pose[Hole::C_BCY] - pin(PinConnection::B),
                              two.corner_to_C, dyad_sides_.B_of_VC)))
      return std::nullopt;
    pose[Hole::B_BCY] = pose[Hole::B_VB] + pin(PinConnection::B);
    pose[Hole::Y_BCY] = pose[Hole::B_BCY] +
                        (pose[Hole::C_BCY] - pose[Hole::B_BCY]) * (two.third / along_axis(two.corner_to_C));
  }
  const auto seen_along = [&](Hole from, Hole to, const BoxLength& length) {
    return conjugate((pose[to] - pose[from]) / along_axis(length));
  };
  pose.seen_from = {seen_along(Hole::V_VA, Hole::A_VA, VA), seen_along(Hole::V_VB, Hole::B_VB, VB),
                    seen_along(Hole::A_ACX, Hole::C_ACX, AC), seen_along(Hole::B_BCY, Hole::C_BCY, BC)};
  return pose;
}

}  // namespace kempe
