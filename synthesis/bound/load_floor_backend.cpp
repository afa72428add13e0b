#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/interval.hpp"
#include "kinematics/assembly_mode.hpp"
#include "synthesis/bound/load_floor.hpp"
#include "synthesis/bound/slack.hpp"
#include "synthesis/loads/gravity.hpp"

namespace kempe::bounding {
namespace {

/// Pieces of the range of t.
constexpr int pieces = 8;

constexpr Complex quarter_turn{0, 1};

/// Terms c dot(w, F)^2: sums of c |w|^2 and of c w^2.
struct TermSums {
  Interval trace{0};
  IntervalComplex difference{0, 0};

  void add(const Interval& coefficient, const IntervalComplex& w) {
    trace += coefficient * squared_length(w);
    difference = difference +
                 coefficient * IntervalComplex{CGAL::square(w.re) - CGAL::square(w.im), 2.0 * w.re * w.im};
  }
};

/// Those that grow with VA^3 and VB^3 (bent), and with VA and VB (pulled).
struct TermsOfLinks {
  TermSums VA_bent, VA_pulled, VB_bent, VB_pulled;
};

struct ArmForces {
  IntervalComplex along, across;
};

/// What synthesis/loads/link_forces.hpp derives, in intervals: the components of the forces on a plate at its joints, for 1 N at Y.
struct PlateForces {
  ArmForces corner, C, tip;
  const ArmForces& at(PlateArm::End end) const { return force_at(end, corner, C, tip); }
};

void add_plate(const std::array<PlateArm, 2>& arms, const PlateForces& forces, const Interval& across,
               const Interval& along, TermSums& bent, TermSums& pulled) {
  for (const PlateArm& arm : arms) {
    const Interval length = widened(arm.length);
    bent.add(across * length * length * length, forces.at(arm.end).across);
    pulled.add(along * length, forces.at(arm.end).along);
  }
}

}  // namespace

LoadFloor::LoadFloor(const Spec& spec, const ModeFacts& mode)
    : mode_(mode), limit_(*spec.limits.load_error * (1 + slack::load_limit)),
      force_(most_force_at_pen(*spec.load)), E_(spec.material->E), width_(spec.links.style.width),
      thickness_(spec.links.style.thickness),
      profile_(load_error_profile(spec, spec.copy.k(), mode.grounding)) {}

double LoadFloor::about(double psi, double t, double w) const {
  const double opening = std::arg(mode_.s) + mode_.bend * psi;
  return profile_.at({std::sqrt(w / t / 2), std::sqrt(w * t / 2) * std::abs(mode_.s)}, opening).worst;
}

double LoadFloor::at_least(double psi, const LengthBox& lengths) const {
  const bool straight = is_straight(mode_.s);
  const auto arms_ACX = plate_arms(1.0 / mode_.s, straight), arms_BCY = plate_arms(mode_.s, straight);
  const double step = std::pow(lengths.t.upper / lengths.t.lower, 1.0 / pieces);
  const OutwardRounding rounding;
  const IntervalComplex s = widened(mode_.s), one = exactly(1.0), left = exactly(quarter_turn);
  const Interval plate = length(s);
  const IntervalComplex s_direction{s.re / plate, s.im / plate};
  const IntervalComplex e = s_direction * direction_at(Interval(mode_.bend * psi));  // e^{i d}
  if (e.im.inf() <= 0 && e.im.sup() >= 0) return 0;  // a change point: the forces have no bound here
  const IntervalComplex side = left * (one - s);
  const Interval cosecant = 1.0 / e.im;
  const IntervalComplex bar_VA = cosecant * (side * e), bar_VB = Interval(-cosecant) * side;
  const PlateForces ACX{{e.re * bar_VA, Interval(-1.0) * (side * e)},
                        {s * e - e.re * bar_VA, left * e},
                        {plate * e, plate * (left * e)}};
  const PlateForces BCY{{e.re * bar_VB, Interval(-1.0) * side},
                        {bar_VA - s, Interval(-1.0) * (left * s)},
                        {s_direction, left * s_direction}};
  const Interval area = Interval(width_) * thickness_, E(E_);
  const Interval across = 4.0 / (E * area * CGAL::square(Interval(width_))), along = 1.0 / (E * area);
  TermsOfLinks sums;
  add_plate(arms_ACX, ACX, across, along, sums.VB_bent, sums.VB_pulled);
  add_plate(arms_BCY, BCY, across, along, sums.VA_bent, sums.VA_pulled);
  sums.VA_pulled.add(along, bar_VA);
  sums.VB_pulled.add(along, bar_VB);
  const Interval factor = pen_is_at_V(mode_.grounding) ? 1.0 / squared_length(s - one) : Interval(1);
  const Interval half = Interval(force_) * factor / 2.0;
  double least = infinity;
  double from = lengths.t.lower;
  for (int i = 1; i <= pieces; ++i) {
    const double to = i == pieces ? lengths.t.upper : std::clamp(from * step, from, lengths.t.upper);
    const Interval w(lengths.w.lower);
    const Interval VA = CGAL::sqrt(w / (2.0 * Interval(to)));
    const Interval VB = CGAL::sqrt(w * Interval(from) / 2.0) * plate;
    const Interval VA3 = VA * VA * VA, VB3 = VB * VB * VB;
    const Interval trace = VA3 * sums.VA_bent.trace + VA * sums.VA_pulled.trace + VB3 * sums.VB_bent.trace +
                           VB * sums.VB_pulled.trace;
    const IntervalComplex difference = VA3 * sums.VA_bent.difference + VA * sums.VA_pulled.difference +
                                       VB3 * sums.VB_bent.difference + VB * sums.VB_pulled.difference;
    least = std::min(least, (half * (trace + length(difference))).inf());
    from = to;
  }
  return least;
}

bool LoadFloor::exceeded_by_all(const PoleDistances& distances, const LengthBox& lengths) const {
  const Range passed = passed_by_all(mode_, distances, lengths);
  if (passed.empty()) return false;
  const double t = std::sqrt(lengths.t.lower * lengths.t.upper);
  double psi = passed.lower, most = 0;
  for (const double one : {passed.lower, 0.5 * (passed.lower + passed.upper), passed.upper})
    if (const double here = about(one, t, lengths.w.lower); here > most) psi = one, most = here;
  return most > limit_ && at_least(psi, lengths) > limit_;
}

bool LoadFloor::keeps(const BarLengths& lengths, const OpeningInterval& openings) const {
  for (const double opening : {openings.lower, openings.upper})
    if (!(profile_.at(lengths, opening).worst <= limit_)) return false;
  return profile_.worst_over(lengths, openings) <= limit_;
}

}  // namespace kempe::bounding
