#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/grounding.hpp"
#include "synthesis/bound/contact.hpp"
#include "synthesis/bound/joint_moves.hpp"
#include "synthesis/bound/reach_intervals.hpp"
#include "synthesis/bound/slack.hpp"

namespace kempe::bounding {
namespace {

/// Where a design of the box may have |psi|, from the tracer's distance.
struct Turn {
  double middle;  ///< of the middle design, about
  double away;    ///< no other is farther from it
};

std::optional<Turn> turn_at(const ModeFacts& mode, const DesignBox& box, const Interval& distance) {
  const Interval at_middle = chain_squared(mode, distance) / Interval(box.w()) - H_at(box.t());
  if (!(at_middle.inf() > -1 && at_middle.sup() < 1)) return std::nullopt;
  const double middle = arc_cosine(at_middle).inf();
  const Interval over_poles(std::max(0.0, (Interval(distance.inf()) - box.radius).inf()),
                            (Interval(distance.sup()) + box.radius).sup());
  const Interval w(box.lengths.w.lower, box.lengths.w.upper);
  const Interval all = arc_cosine(chain_squared(mode, over_poles) / w - H_over(box.lengths.t));
  return Turn{middle, std::max((Interval(all.sup()) - middle).sup(), (Interval(middle) - all.inf()).sup())};
}

/// No rho of the box is farther than this from the middle one.
double rho_away(const DesignBox& box, const Turn& turn) {
  const Range& t = box.lengths.t;
  const double longer = (Interval(t.upper) - box.t()).sup(), shorter = (Interval(box.t()) - t.lower).sup();
  return (Interval(std::max(longer, shorter)) + Interval(t.upper) * Interval(turn.away)).sup();
}

/// A joint as (P - P_pole) + (Q - Q_pole) rho.
struct FromPole {
  IntervalComplex P, Q;
};

IntervalComplex place_in(const std::array<Complex, 6>& joints, Joint joint, std::optional<Joint> seen_from) {
  const IntervalComplex at = exactly(joints[static_cast<std::size_t>(joint)]);
  return seen_from ? at - exactly(joints[static_cast<std::size_t>(*seen_from)]) : at;
}

}  // namespace

double DesignBox::t() const { return std::sqrt(lengths.t.lower * lengths.t.upper); }
double DesignBox::w() const { return std::sqrt(lengths.w.lower * lengths.w.upper); }

struct JointMoving::Known {
  /// A joint as seen from the pole or from a carrier, and by how much its map turns with rho's own.
  struct Seen {
    FromPole at;
    Interval turns;
    IntervalComplex turn;  ///< the map's determinant, `turns` long
  };
  using SeenJoints = std::array<Seen, 6>;
  FromPole tracer;
  Interval tracer_Q;
  std::array<SeenJoints, 1 + 6> seen;  ///< from the pole, and from each joint

  /// While an OutwardRounding lives.
  explicit Known(const ModeFacts& mode) {
    const JointRoles roles = roles_of(mode.grounding);
    const MaterialPoint ground = material_point(roles.pole, mode.s);
    const auto from_pole = [&](Joint joint) {
      const MaterialPoint at = material_point(joint, mode.s);
      return FromPole{widened(at.of_a) - widened(ground.of_a), widened(at.of_b) - widened(ground.of_b)};
    };
    tracer = from_pole(roles.tracer);
    tracer_Q = length(tracer.Q);
    const auto as_seen = [&](const FromPole& at) {
      const IntervalComplex turn = at.Q * tracer.P - at.P * tracer.Q;
      return Seen{at, length(turn), turn};
    };
    for (const Joint joint : all_joints) {
      const FromPole at = from_pole(joint);
      seen[0][number(joint)] = as_seen(at);
      for (const Joint other : all_joints) {
        const FromPole carrier = from_pole(other);
        seen[1 + number(other)][number(joint)] = as_seen({at.P - carrier.P, at.Q - carrier.Q});
      }
    }
  }

  static std::size_t number(Joint joint) { return static_cast<std::size_t>(joint); }
};

JointMoving::JointMoving(const ModeFacts& mode) : mode_(mode) {
  const OutwardRounding rounding;
  known_ = std::make_shared<const Known>(mode);
}

std::optional<JointMoves> JointMoving::at_most(const DesignBox& box, const Point& place,
                                               const std::array<Complex, 6>& joints,
                                               std::optional<Joint> seen_from) const {
  const OutwardRounding rounding;
  const IntervalComplex pole = exactly(as_complex(box.pole)), arm = exactly(as_complex(place)) - pole;
  const Interval distance = length(arm);
  const auto turn = turn_at(mode_, box, distance);
  if (!turn) return std::nullopt;
  const Interval delta(rho_away(box, *turn));
  const IntervalComplex rho = Interval(box.t()) * direction_at(Interval(mode_.bend * turn->middle));

  const FromPole& tracer = known_->tracer;
  const IntervalComplex D = tracer.P + tracer.Q * rho;
  const Interval D_length = length(D), least = D_length - known_->tracer_Q * delta;
  if (!(least.inf() > 0.05 * D_length.sup())) return std::nullopt;
  const IntervalComplex per_D = exactly(1.0) / D;
  const Interval spread = delta / (D_length * least);
  // What the pole adds to a joint's place: all of its own, or nothing where both places have it.
  const IntervalComplex of_pole = exactly(seen_from ? 0.0 : 1.0), origin = seen_from ? exactly(0.0) : pole;
  const Known::SeenJoints& seen = known_->seen[seen_from ? 1 + Known::number(*seen_from) : 0];
  JointMoves moves;
  for (const Joint joint : all_joints) {
    const FromPole& at = seen[Known::number(joint)].at;
    const Interval& turns = seen[Known::number(joint)].turns;
    const IntervalComplex M = (at.P + at.Q * rho) * per_D;
    const Interval map_moves = turns * spread;
    const Interval beside = length(of_pole - M) + map_moves;
    const Interval off = length(origin + arm * M - place_in(joints, joint, seen_from));
    moves[Known::number(joint)] = (Interval(box.radius) * beside + distance * map_moves + off).sup();
  }
  return moves;
}

JointMoves JointMoving::beside(double VA, const std::array<Complex, 6>& joints, double radius,
                               Joint seen_from) const {
  JointMoves moves;
  moves.fill(infinity);
  const auto between = [&](Joint from, Joint to) {
    return joints[Known::number(to)] - joints[Known::number(from)];
  };
  const JointRoles roles = roles_of(mode_.grounding);
  const double a = std::abs(between(Joint::V, Joint::A)), b = std::abs(between(Joint::V, Joint::B) / mode_.s);
  const double distance = std::abs(between(roles.pole, roles.tracer)), t = b / a;
  const auto cosine_at = [&](double along) {
    return mode_.chain * mode_.chain * along * along / (2 * a * b) - 0.5 * (t + 1 / t);
  };
  const double nearer = cosine_at(std::max(0.0, distance - radius)), farther = cosine_at(distance + radius);
  // Where the middle is out of reach, the joints are those of a larger or smaller linkage.
  if (std::abs(a - VA) > slack::same_design * VA) return moves;
  if (!(nearer > -slack::surely_within && farther < slack::surely_within)) return moves;
  const double psi = std::acos(cosine_at(distance));
  const double delta = slack::surely_more * t * std::max(std::acos(nearer) - psi, psi - std::acos(farther));
  const double D = distance / a, least = D - known_->tracer_Q.sup() * delta;
  if (!(least > 0.05 * D)) return moves;
  const Known::SeenJoints& seen = known_->seen[1 + Known::number(seen_from)];
  for (const Joint joint : all_joints)
    moves[Known::number(joint)] =
        radius * std::abs(between(seen_from, joint)) / distance +
        (distance + radius) * seen[Known::number(joint)].turns.sup() * delta / (D * least);
  return moves;
}

// About the middle t_0, psi_0, O_0 with rho = t e^{i psi}, m = M(rho_0) and the map's slope M' = det / D_0^2
//     Z - Z_0 = (O - O_0)(1 - m) + (T - O_0)(M - m) - (O - O_0)(M - m),
//     M - m = M' d / (1 + Q_tracer d / D_0),   d = rho - rho_0 = e^{i psi_0} ((t - t_0) + i t_0 (psi - psi_0)) + e,
//     |e| <= |t - t_0| |psi - psi_0| + t (psi - psi_0)^2 / 2.
std::optional<JointSpreads> JointMoving::spread(const DesignBox& box, const Point& place, const Range& usable,
                                                std::optional<Joint> seen_from) const {
  const OutwardRounding rounding;
  const IntervalComplex pole = exactly(as_complex(box.pole)), arm = exactly(as_complex(place)) - pole;
  const Interval distance = length(arm);
  const Interval over_poles(std::max(0.0, (Interval(distance.inf()) - box.radius).inf()),
                            (Interval(distance.sup()) + box.radius).sup());
  const Interval turned =
      arc_cosine(chain_squared(mode_, over_poles) / Interval(box.lengths.w.lower, box.lengths.w.upper) -
                 H_over(box.lengths.t));
  const Range psi{std::max(turned.inf(), usable.lower), std::min(turned.sup(), usable.upper)};
  if (psi.empty()) return std::nullopt;
  const auto half_about = [](const Range& range, double middle) {
    return Interval(
        std::max({0.0, (Interval(range.upper) - middle).sup(), (Interval(middle) - range.lower).sup()}));
  };
  const double t_0 = 0.5 * (box.lengths.t.lower + box.lengths.t.upper), psi_0 = 0.5 * (psi.lower + psi.upper);
  const Interval t_half = half_about(box.lengths.t, t_0), psi_half = half_about(psi, psi_0);
  const IntervalComplex along = direction_at(Interval(mode_.bend * psi_0)), rho = Interval(t_0) * along;
  const Interval bent = t_half * psi_half + Interval(box.lengths.t.upper) * CGAL::square(psi_half) / 2.0;
  const Interval delta((t_half + Interval(box.lengths.t.upper) * psi_half).sup());

  const FromPole& tracer = known_->tracer;
  const IntervalComplex D = tracer.P + tracer.Q * rho;
  const Interval D_length = length(D), least = D_length - known_->tracer_Q * delta;
  if (!(least.inf() > 0.05 * D_length.sup())) return std::nullopt;
  const IntervalComplex per_D = exactly(1.0) / D, per_D_squared = per_D * per_D;
  const IntervalComplex of_pole = exactly(seen_from ? 0.0 : 1.0), origin = seen_from ? exactly(0.0) : pole;
  const IntervalComplex by_t = t_half * along,
                        by_psi = (psi_half * Interval(t_0)) * (exactly(Complex(0, mode_.bend)) * along);
  const Interval radius(box.radius);
  const Interval x_half(std::min(box.radius, box.half.x())), y_half(std::min(box.radius, box.half.y()));
  const Known::SeenJoints& seen = known_->seen[seen_from ? 1 + Known::number(*seen_from) : 0];
  JointSpreads spreads;
  for (const Joint joint : all_joints) {
    const Known::Seen& known = seen[Known::number(joint)];
    const IntervalComplex M = (known.at.P + known.at.Q * rho) * per_D, slope = known.turn * per_D_squared;
    const IntervalComplex swept = arm * slope, beside = of_pole - M;
    JointSpread& spread = spreads[Known::number(joint)];
    Interval rest(0.0);
    // The nearest doubles, and what they are off.
    const auto kept = [&](const IntervalComplex& z) {
      const Complex middle(0.5 * (z.re.inf() + z.re.sup()), 0.5 * (z.im.inf() + z.im.sup()));
      rest = rest + length(z - exactly(middle));
      return middle;
    };
    spread.middle = kept(origin + arm * M);
    spread.by = {kept(swept * by_t), kept(swept * by_psi), kept(x_half * beside),
                 kept(y_half * (exactly(i_unit) * beside))};
    const Interval slope_length = known.turns / CGAL::square(D_length);
    const Interval beyond = slope_length * (bent + known_->tracer_Q * CGAL::square(delta) / least);
    rest = rest + distance * beyond + radius * (slope_length * delta * D_length / least);
    spread.rest = rest.sup();
  }
  return spreads;
}

std::optional<JointMoves> joints_move_at_most(const ModeFacts& mode, const DesignBox& box, const Point& place,
                                              const std::array<Complex, 6>& joints,
                                              std::optional<Joint> seen_from) {
  return JointMoving(mode).at_most(box, place, joints, seen_from);
}

JointMoves copying_joints_move_at_most(const ModeFacts& mode, Complex k, const DesignBox& box,
                                       const Point& place, const std::array<Complex, 6>& joints,
                                       std::optional<Joint> seen_from) {
  const OutwardRounding rounding;
  const IntervalComplex pole = exactly(as_complex(box.pole)), arm = exactly(as_complex(place)) - pole;
  const IntervalComplex of_pole = exactly(seen_from ? 0.0 : 1.0);
  const JointRoles roles = roles_of(mode.grounding);
  const auto map_of = [&](Joint joint) {
    return joint == roles.tracer ? exactly(1.0) : IntervalComplex{widened(k)};
  };
  JointMoves moves;
  moves.fill(std::numeric_limits<double>::infinity());
  for (const Joint joint : {roles.tracer, roles.pen}) {
    if (seen_from && *seen_from != roles.tracer && *seen_from != roles.pen) continue;
    const IntervalComplex M = seen_from ? map_of(joint) - map_of(*seen_from) : map_of(joint);
    const Interval off = length(of_pole * pole + arm * M - place_in(joints, joint, seen_from));
    moves[static_cast<std::size_t>(joint)] = (Interval(box.radius) * length(of_pole - M) + off).sup();
  }
  return moves;
}

}  // namespace kempe::bounding
