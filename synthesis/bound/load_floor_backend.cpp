#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/interval.hpp"
#include "kinematics/assembly_mode.hpp"
#include "synthesis/bound/load_floor.hpp"
#include "synthesis/bound/reach_intervals.hpp"
#include "synthesis/bound/slack.hpp"
#include "synthesis/loads/gravity.hpp"

namespace kempe::bounding {
namespace {

/// Pieces of the range of t, and of the range of psi where that is one.
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

/// A range of t in pieces of one ratio.
std::array<Range, pieces> parts_of(const Range& t) {
  const double step = std::pow(t.upper / t.lower, 1.0 / pieces);
  std::array<Range, pieces> parts;
  double from = t.lower;
  for (Range& part : parts) {
    part = {from, std::clamp(from * step, from, t.upper)};
    from = part.upper;
  }
  parts.back().upper = t.upper;
  return parts;
}

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

/// The compliance over a range of psi, in the parts that grow with VA^3, VA, VB^3 and VB.
class LoadFloor::Compliance {
 public:
  Compliance(const LoadFloor& floor, const Interval& psi) {
    const ModeFacts& mode = floor.mode_;
    const bool straight = is_straight(mode.s);
    const IntervalComplex s = widened(mode.s), one = exactly(1.0), left = exactly(quarter_turn);
    plate_ = length(s);
    const IntervalComplex s_direction{s.re / plate_, s.im / plate_};
    const IntervalComplex e = s_direction * direction_at(Interval(mode.bend) * psi);  // e^{i d}
    is_bounded_ = e.im.inf() > 0 || e.im.sup() < 0;
    if (!is_bounded_) return;
    const IntervalComplex side = left * (one - s);
    const Interval cosecant = 1.0 / e.im;
    const IntervalComplex bar_VA = cosecant * (side * e), bar_VB = Interval(-cosecant) * side;
    const PlateForces ACX{{e.re * bar_VA, Interval(-1.0) * (side * e)},
                          {s * e - e.re * bar_VA, left * e},
                          {plate_ * e, plate_ * (left * e)}};
    const PlateForces BCY{{e.re * bar_VB, Interval(-1.0) * side},
                          {bar_VA - s, Interval(-1.0) * (left * s)},
                          {s_direction, left * s_direction}};
    const Interval area = Interval(floor.width_) * floor.thickness_, E(floor.E_);
    const Interval across = 4.0 / (E * area * CGAL::square(Interval(floor.width_))), along = 1.0 / (E * area);
    add_plate(plate_arms(1.0 / mode.s, straight), ACX, across, along, sums_.VB_bent, sums_.VB_pulled);
    add_plate(plate_arms(mode.s, straight), BCY, across, along, sums_.VA_bent, sums_.VA_pulled);
    sums_.VA_pulled.add(along, bar_VA);
    sums_.VB_pulled.add(along, bar_VB);
    const Interval factor = pen_is_at_V(mode.grounding) ? 1.0 / squared_length(s - one) : Interval(1);
    half_ = Interval(floor.force_) * factor / 2.0;
  }

  /// False where a change point lies in the range: the forces have no bound there.
  bool is_bounded() const { return is_bounded_; }

  /// No linkage with these t and at least this w gives way by less, mm.
  double at_least(const Range& t, double w_least) const {
    const Interval w(w_least);
    const Interval VA = CGAL::sqrt(w / (2.0 * Interval(t.upper)));
    const Interval VB = CGAL::sqrt(w * Interval(t.lower) / 2.0) * plate_;
    const Interval VA3 = VA * VA * VA, VB3 = VB * VB * VB;
    const Interval trace = VA3 * sums_.VA_bent.trace + VA * sums_.VA_pulled.trace +
                           VB3 * sums_.VB_bent.trace + VB * sums_.VB_pulled.trace;
    const IntervalComplex difference = VA3 * sums_.VA_bent.difference + VA * sums_.VA_pulled.difference +
                                       VB3 * sums_.VB_bent.difference + VB * sums_.VB_pulled.difference;
    return (half_ * (trace + length(difference))).inf();
  }

 private:
  TermsOfLinks sums_;
  Interval plate_{0}, half_{0};
  bool is_bounded_ = false;
};

double LoadFloor::at_least(double psi, const LengthBox& lengths) const {
  const auto parts = parts_of(lengths.t);
  const OutwardRounding rounding;
  const Compliance compliance(*this, Interval(psi));
  if (!compliance.is_bounded()) return 0;
  double least = infinity;
  for (const Range& t : parts) least = std::min(least, compliance.at_least(t, lengths.w.lower));
  return least;
}

double LoadFloor::at_least_reaching(double distance, Reaching reaching, double transmission,
                                    const LengthBox& lengths) const {
  const auto parts = parts_of(lengths.t);
  const Range usable = mode_.usable(transmission);
  const OutwardRounding rounding;
  const Interval reach = chain_squared(mode_, Interval(distance));
  const Interval arc = arc_cosine(reach / Interval(lengths.w.lower, lengths.w.upper) - H_over(lengths.t));
  const bool is_one_distance = reaching == Reaching::exactly;
  const Range psi{is_one_distance ? std::max(arc.inf(), usable.lower) : usable.lower,
                  std::min(arc.sup(), usable.upper)};
  if (psi.empty()) return infinity;
  double least = infinity;
  double from = psi.lower;
  for (int i = 1; i <= pieces; ++i) {
    const double to = i == pieces
                          ? psi.upper
                          : std::clamp(psi.lower + i * (psi.upper - psi.lower) / pieces, from, psi.upper);
    const Interval turned(from, to), of_psi = cosine(turned);
    from = to;
    const Compliance compliance(*this, turned);
    for (const Range& t : parts) {
      const Interval unfolded = H_over(t) + of_psi;
      if (!(unfolded.sup() > 0)) continue;
      const double w_least = std::max(lengths.w.lower, (reach / Interval(unfolded.sup())).inf());
      if (w_least > lengths.w.upper) continue;
      if (is_one_distance && unfolded.inf() > 0 && (reach / Interval(unfolded.inf())).sup() < lengths.w.lower)
        continue;
      if (!compliance.is_bounded()) return 0;
      least = std::min(least, compliance.at_least(t, w_least));
      if (least <= limit_) return least;
    }
  }
  return least;
}

bool LoadFloor::may_exceed_reaching(double distance, const Range& usable, const LengthBox& lengths) const {
  const double reach = mode_.chain * mode_.chain * distance * distance;
  for (const double t : {std::sqrt(lengths.t.lower * lengths.t.upper), lengths.t.lower, lengths.t.upper}) {
    const double H = 0.5 * (t + 1 / t);
    const auto psi_of = [&](double w) { return std::acos(std::clamp(reach / w - H, -1.0, 1.0)); };
    const double lower = std::max(usable.lower, psi_of(lengths.w.lower));
    const double upper = std::min(usable.upper, psi_of(lengths.w.upper));
    if (!(lower <= upper)) continue;
    for (const double psi : {lower, 0.5 * (lower + upper), upper})
      if (about(psi, t, reach / (H + std::cos(psi))) <= limit_) return false;
  }
  return true;
}

bool LoadFloor::is_exceeded_at_a_common_opening(const PoleDistances& distances,
                                                const LengthBox& lengths) const {
  const Range passed = passed_by_all(mode_, distances, lengths);
  if (passed.empty()) return false;
  const double t = std::sqrt(lengths.t.lower * lengths.t.upper);
  double psi = passed.lower, most = 0;
  for (const double one : {passed.lower, 0.5 * (passed.lower + passed.upper), passed.upper})
    if (const double here = about(one, t, lengths.w.lower); here > most) psi = one, most = here;
  return most > limit_ && at_least(psi, lengths) > limit_;
}

bool LoadFloor::exceeded_by_all(const PoleDistances& distances, double transmission,
                                const LengthBox& lengths) const {
  if (is_exceeded_at_a_common_opening(distances, lengths)) return true;
  const Range usable = mode_.usable(transmission);
  const auto is_exceeded_at = [&](double distance, Reaching reaching) {
    return may_exceed_reaching(distance, usable, lengths) &&
           at_least_reaching(distance, reaching, transmission, lengths) > limit_;
  };
  const double near = distances.nearest_at_most, far = distances.farthest_at_least;
  if (!(near <= far)) return is_exceeded_at(far, Reaching::at_least);
  return is_exceeded_at(far, Reaching::exactly) || is_exceeded_at(near, Reaching::exactly);
}

bool LoadFloor::keeps(const BarLengths& lengths, const OpeningInterval& openings) const {
  return keeps_at_ends(lengths, openings) && profile_.worst_over(lengths, openings) <= limit_;
}

bool LoadFloor::keeps_at_ends(const BarLengths& lengths, const OpeningInterval& openings) const {
  return profile_.at(lengths, openings.lower).worst <= limit_ &&
         profile_.at(lengths, openings.upper).worst <= limit_;
}

}  // namespace kempe::bounding
