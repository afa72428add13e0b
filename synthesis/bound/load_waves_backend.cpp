#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/assembly_mode.hpp"
#include "synthesis/bound/load_waves.hpp"
#include "synthesis/bound/reach_intervals.hpp"
#include "synthesis/bound/slack.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/load_error.hpp"

namespace kempe::bounding {

namespace {

TurningForce operator+(const TurningForce& u, const TurningForce& v) {
  TurningForce sum;
  for (std::size_t n = 0; n < sum.by.size(); ++n) sum.by[n] = u.by[n] + v.by[n];
  return sum;
}
TurningForce operator*(const IntervalComplex& factor, const TurningForce& v) {
  TurningForce product;
  for (std::size_t n = 0; n < product.by.size(); ++n) product.by[n] = factor * v.by[n];
  return product;
}

TurningForce fixed(const IntervalComplex& v) { return {{exactly(0.0), v, exactly(0.0), exactly(0.0)}}; }

/// Times e^{id} and e^{-id}; what would leave the sum is 0 in all that is turned.
TurningForce turned_on(const TurningForce& v) { return {{exactly(0.0), v.by[0], v.by[1], v.by[2]}}; }
TurningForce turned_back(const TurningForce& v) { return {{v.by[1], v.by[2], v.by[3], exactly(0.0)}}; }

TurningForce cosine_times(const TurningForce& v) { return exactly(0.5) * (turned_on(v) + turned_back(v)); }
TurningForce sine_times(const TurningForce& v) {
  return exactly({0, -0.5}) * (turned_on(v) + exactly(-1.0) * turned_back(v));
}

/// Of a plate at its corner, C and tip.
struct TurningArm {
  TurningForce along, across;
};
using TurningPlate = std::array<TurningArm, 3>;

}  // namespace

Phase phase_at(const ModeFacts& mode, const Interval& psi) {
  const IntervalComplex s = widened(mode.s);
  const Interval plate = length(s);
  const IntervalComplex start{s.re / plate, s.im / plate};
  const IntervalComplex e = start * direction_at(Interval(mode.bend) * psi);
  const IntervalComplex e_2 = start * start * direction_at(Interval(2 * mode.bend) * psi);
  return {e.re, e.im, e_2.re, e_2.im};
}

Wave operator*(const Interval& factor, const Wave& wave) {
  return {factor * wave.a, factor * wave.b, factor * wave.c, factor * wave.e, factor * wave.f};
}
Wave operator+(const Wave& one, const Wave& other) {
  return {one.a + other.a, one.b + other.b, one.c + other.c, one.e + other.e, one.f + other.f};
}

LoadWaves::LoadWaves(const Spec& spec, const ModeFacts& mode) {
  const OutwardRounding rounding;
  const double opening = std::arg(mode.s) + mode.bend * 0.5 * (mode.far_end + mode.near_end);
  sign_ = std::sin(opening) < 0 ? -1 : 1;
  const IntervalComplex s = widened(mode.s), one = exactly(1.0), left = exactly({0, 1}),
                        minus = exactly(-1.0);
  const IntervalComplex plate{length(s), Interval(0)}, direction{s.re / plate.re, s.im / plate.re};
  const IntervalComplex side = left * (one - s);
  const Interval width(spec.links.style.width), area = width * spec.links.style.thickness,
                                                E(spec.material->E);
  const Interval factor = pen_is_at_V(mode.grounding) ? 1.0 / squared_length(s - one) : Interval(1);
  const Interval limit(*spec.limits.load_error * (1 + slack::load_limit));
  const Interval per_limit = Interval(most_force_at_pen(*spec.load)) * factor / limit;
  const Interval bent = 4.0 * per_limit / (E * area * CGAL::square(width)), pulled = per_limit / (E * area);

  const TurningForce e = turned_on(fixed(one)), sine_e = sine_times(e);
  const TurningForce bar_VA = side * e, bar_VB = fixed(minus * side);
  const auto sine = [](const IntervalComplex& v) { return sine_times(fixed(v)); };
  const TurningPlate ACX{{{cosine_times(bar_VA), minus * sine_times(bar_VA)},
                          {s * sine_e + minus * cosine_times(bar_VA), left * sine_e},
                          {plate * sine_e, plate * (left * sine_e)}}};
  const TurningPlate BCY{{{cosine_times(bar_VB), sine_times(bar_VB)},
                          {bar_VA + sine(minus * s), sine(minus * (left * s))},
                          {sine(direction), sine(left * direction)}}};
  const auto add_plate = [&](const std::array<PlateArm, 2>& arms, const TurningPlate& forces, bool is_of_VA) {
    for (const PlateArm& arm : arms) {
      const Interval length = widened(arm.length);
      const TurningArm& at_end = forces[static_cast<std::size_t>(arm.end)];
      terms_.push_back({bent * length * length * length, at_end.across, is_of_VA, 3});
      terms_.push_back({pulled * length, at_end.along, is_of_VA, 1});
    }
  };
  const bool straight = is_straight(mode.s);
  add_plate(plate_arms(1.0 / mode.s, straight), ACX, false);
  add_plate(plate_arms(mode.s, straight), BCY, true);
  terms_.push_back({pulled, bar_VA, true, 1});
  terms_.push_back({pulled, bar_VB, false, 1});
}

std::vector<LoadWave> LoadWaves::of(const Interval& VA, const Interval& VB, const Phase& d) const {
  const Complex e(middle_of(d.cosine), middle_of(d.sine));
  const Interval VA3 = VA * VA * VA, VB3 = VB * VB * VB;
  const auto scale_of = [&](const Term& term) {
    const Interval& power = term.is_of_VA ? term.power == 3 ? VA3 : VA : term.power == 3 ? VB3 : VB;
    return term.coefficient * power;
  };
  Complex sum = 0;
  for (const Term& term : terms_) {
    const auto& by = term.force.by;
    const Complex force =
        middle_of(by[0]) * std::conj(e) + middle_of(by[1]) + middle_of(by[2]) * e + middle_of(by[3]) * e * e;
    sum += middle_of(scale_of(term)) * force * force;
  }
  const IntervalComplex against = exactly(std::polar(1.0, -0.5 * std::arg(sum)));
  const Interval unit = 1.0 / squared_length(against);
  std::vector<LoadWave> waves;
  waves.reserve(terms_.size());
  for (const Term& term : terms_) {
    const auto by = (against * term.force).by;
    const Wave component{by[1].re, by[0].re + by[2].re, by[0].im - by[2].im, by[3].re, -by[3].im};
    waves.push_back({CGAL::sqrt(unit * scale_of(term)) * component, term.is_of_VA, term.power});
  }
  return waves;
}

Wave touching_from_below(const std::vector<LoadWave>& waves, const Phase& d) {
  Wave sum;
  Interval squares(0);
  for (const LoadWave& one : waves) {
    const Interval weight(middle_of(one.wave.at(d)));
    squares += CGAL::square(weight);
    sum = sum + weight * one.wave;
  }
  return 1.0 / CGAL::sqrt(squares) * sum;
}

SlopesOfRoot slopes_of_root(const std::vector<LoadWave>& waves, const Phase& d, const Phase& all,
                            const Interval& about) {
  Interval sum(0), by_log_t(0), by_log_w(0);
  for (const LoadWave& one : waves) {
    const Interval square = CGAL::square(one.wave.at(d) + about * one.wave.derivative().at(all));
    const Interval part = 0.25 * one.power * square;
    sum += square;
    by_log_t += one.is_of_VA ? -part : part;
    by_log_w += part;
  }
  // Whatever the shares of the squares are, their powers are 1 to 3.
  const auto within = [&](const Interval& slope, double lower, double upper) {
    if (sum.inf() <= 0) return Interval(lower, upper);
    const Interval share = slope / sum;
    return Interval(std::clamp(share.inf(), lower, upper), std::clamp(share.sup(), lower, upper));
  };
  const Interval root = CGAL::sqrt(sum);
  return {root * within(by_log_t, -0.75, 0.75), root * within(by_log_w, 0.25, 0.75)};
}

}  // namespace kempe::bounding
