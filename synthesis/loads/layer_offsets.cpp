#include "synthesis/loads/layer_offsets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "specs/hardware.hpp"
#include "synthesis/loads/link_arms.hpp"
#include "synthesis/loads/pin_compliance.hpp"
#include "synthesis/loads/steel.hpp"
#include "synthesis/loads/top_over.hpp"

namespace kempe {
namespace {

/// Pins of SagProfile::plan in their order.
enum : std::size_t { at_pole, at_V, at_A, at_B, at_C, pin_count };

/// On the upper link of each pin from the lower one, for the force F_Y at Y; of the post on what stands on it.
std::array<Complex, pin_count> upward_forces(Complex s, const LayerAssignment& layers, bool pole_is_at_V,
                                             double opening, Complex F_Y) {
  const Complex q = std::polar(1.0, opening), F_X = -std::conj(s) * F_Y;
  const Complex on_ACX_at_A = -(std::conj(q * (1.0 / s - 1.0)) * F_X).imag() / q.imag();
  const Complex on_ACX_at_C = -on_ACX_at_A - F_X, on_BCY_at_B = on_ACX_at_C - F_Y;
  const auto upward = [&](Link one, Link other, Complex on_one) {
    return layers[one] > layers[other] ? on_one : -on_one;
  };
  const bool VA_is_upper = layers[Link::VA] > layers[Link::VB];
  // The post bears VA and VB at V, with what their bars pull there: the upper one through the lower one's height.
  const Complex post = pole_is_at_V ? on_ACX_at_A + on_BCY_at_B : F_X;
  const Complex between =
      pole_is_at_V ? (VA_is_upper ? on_ACX_at_A : on_BCY_at_B) : upward(Link::VB, Link::VA, on_BCY_at_B);
  return {post, between, upward(Link::ACX, Link::VA, on_ACX_at_A), upward(Link::BCY, Link::VB, on_BCY_at_B),
          upward(Link::ACX, Link::BCY, on_ACX_at_C)};
}

/// Heights of the same pins between the middles of what they join, in layers.
std::array<double, pin_count> heights(const LayerAssignment& layers, bool pole_is_at_V) {
  const auto between = [&](Link one, Link other) { return std::abs(layers[one] - layers[other]) * 1.0; };
  const int standing = pole_is_at_V ? std::min(layers[Link::VA], layers[Link::VB]) : layers[Link::ACX];
  return {standing - 0.5, between(Link::VA, Link::VB), between(Link::VA, Link::ACX),
          between(Link::VB, Link::BCY), between(Link::ACX, Link::BCY)};
}

/// What the pins give while their ends do not tilt.
PinCompliance upright_pins(Grounding grounding, const SagConditions& conditions) {
  const LayerAssignment& layers = conditions.layers;
  const Joint pole = roles_of(grounding).pole;
  PinCompliance pins = pin_compliance(grounding, layers, conditions.style, conditions.hardware);
  const double height = conditions.style.thickness * heights(layers, pole == Joint::V)[at_pole];
  pins.pole = upright_pin(pin_at(conditions.style, conditions.hardware, pole), height);
  // At the pole's post the upper of the two bars stands on what lies between it and the lower one.
  if (pole == Joint::V && layers[Link::VA] > layers[Link::VB]) pins.A += std::exchange(pins.V, 0.0);
  return pins;
}

/// The larger eigenvalue of a symmetric matrix.
double larger_eigenvalue(const Eigen::Matrix2d& matrix) {
  const double mean = 0.5 * matrix.trace();
  return mean + std::hypot(0.5 * (matrix(0, 0) - matrix(1, 1)), 0.5 * (matrix(0, 1) + matrix(1, 0)));
}

/// In how many parts of a turn a value is looked for: many where it has a kink wherever another set of points bears, and a top for the
/// tracer and one for the pen; a few where it is the largest of figures that each have two tops.
constexpr int parts_with_contacts = 16, parts_without = 4;

/// The most of what value(direction, rad) is over all directions; NaN if it is NaN in one that is looked at.
template <class Value>
double most_over_directions(const Value& value, int parts = parts_with_contacts) {
  constexpr int steps = 40;
  const auto known = [&](double direction) {
    const double here = value(direction);
    return std::isfinite(here) ? here : infinity;
  };
  double most = 0;
  for (int i = 0; i < parts; ++i)
    most = std::max(most, known(top_over({2 * pi * i / parts, 2 * pi * (i + 1) / parts}, known, steps)));
  return std::isfinite(most) ? most : std::numeric_limits<double>::quiet_NaN();
}

/// What a force F on the pen does in the plane to a beam of the plan, as vectors w of link_forces.hpp for F.
struct PieceLines {
  Link link;
  double own_weight;                 ///< of PieceForces
  Complex pull = 0;                  ///< N
  std::array<Complex, 2> bending{};  ///< N mm, at both ends
};

/// The force on a plate at one of its joints.
const ArmForce& force_at(const LinkForces& forces, Link link, Joint joint) {
  if (joint == Joint::C) return link == Link::ACX ? forces.C_of_ACX : forces.C_of_BCY;
  if (link == Link::ACX) return joint == Joint::A ? forces.A : forces.X;
  return joint == Joint::B ? forces.B : forces.Y;
}

/// Of all beams of a plan at an opening, in their order.
std::vector<PieceLines> piece_lines(const GrillagePlan& plan, Complex shape, Complex factor, double opening) {
  const LinkForces forces = link_forces(shape, opening);
  std::vector<PieceLines> lines;
  for (const Link link : all_links) {
    const std::vector<LinkArm> arms = arms_of(link, shape);
    const std::array<Joint, 2> far_ends = ends_of(arms);
    for (std::size_t arm = 0; arm < arms.size(); ++arm) {
      const GrillageBeam& beam = plan.beams[lines.size()];
      const double length = std::abs(plan.place(beam.to) - plan.place(beam.from));
      PieceLines piece{link, 0.5 * beam.weight * length * length};
      if (arms.size() == 1) {
        piece.pull = factor * (link == Link::VA ? forces.bar_VA : forces.bar_VB);
      } else {
        const ArmForce& force = force_at(forces, link, far_ends[arm]);
        piece.pull = factor * force.along;
        piece.bending[arms[arm].from == far_ends[arm] ? 1 : 0] = factor * length * force.across;
      }
      lines.push_back(piece);
    }
  }
  return lines;
}

}  // namespace

/// How the linkage answers while a given set of points bears on the table; rows of two: tracer, pen.
struct LayeredErrorProfile::Bent {
  Eigen::Matrix2d compliance, rises, reactions;                    ///< mm/N, mm/N and N/N, by the force
  Eigen::Vector2d weighed_give, weighed_rises, weighed_reactions;  ///< mm, mm and N, by the weights
  Eigen::MatrixX2d moments;                                        ///< N mm/N, of beam_moments, by the force
  Eigen::VectorXd weighed_moments;                                 ///< N mm, by the weights

  Eigen::Vector2d give_at(const Point& force) const { return weighed_give + compliance * force; }
  Eigen::Vector2d rises_at(const Point& force) const { return weighed_rises + rises * force; }
  Eigen::Vector2d reactions_at(const Point& force) const { return weighed_reactions + reactions * force; }
  bool is_finite() const { return compliance.allFinite() && weighed_rises.allFinite(); }
};

/// Which points bear under the weights and a force, at one opening, and what the force does. Refers to the profile.
class LayeredErrorProfile::Contacts {
 public:
  Contacts(const LayeredErrorProfile& of, const BarLengths& lengths, double opening,
           const SupportedStretch& under_weights)
      : of_(of), plan_(of.sag_.plan(lengths.VA, lengths.VB, opening)), couples_(couples_at(opening)),
        lines_(piece_lines(plan_, of.shape_, of.factor_, opening)),
        resting_(set_of(of.conditions_.tracer_rests, of.conditions_.pen_rests)),
        under_weights_(set_of(under_weights.tracer_bears, under_weights.pen_bears)) {}

  const Bent& under_weights() { return on(under_weights_); }
  const Bent& under(const Point& force) { return on(bearing_under(force)); }
  /// MPa: the largest stress in a link under a force and the weights, as they bend it.
  double stress(const Bent& bent, Link link, const Point& force, const SectionModuli& at_joints,
                const SectionModuli& between) const {
    double largest = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const PieceLines& piece = lines_[i];
      if (piece.link != link) continue;
      const auto along = [&](Complex line) { return as_point(line).dot(force); };
      const auto moment = [&](Eigen::Index row) {
        row += 3 * static_cast<Eigen::Index>(i);
        return bent.weighed_moments[row] + bent.moments.row(row).dot(force);
      };
      const PieceForces forces{.pull = along(piece.pull),
                               .in_plane = {along(piece.bending[0]), along(piece.bending[1])},
                               .out_of_plane = {moment(0), moment(1)},
                               .own_weight = piece.own_weight,
                               .twist = moment(2)};
      const double here = largest_stress(forces, at_joints, between);
      if (!(here <= largest)) largest = here;
      if (std::isnan(largest)) break;
    }
    return largest;
  }
  /// No force of that size, N, whatever its direction, lifts a point off the table or lets one down.
  bool are_those_of_the_weights(double force) {
    const Bent& bent = under_weights();
    for (const unsigned point : {0U, 1U}) {
      const bool bears = has(under_weights_, point);
      const double left = bears ? bent.weighed_reactions[point] : bent.weighed_rises[point];
      if (has(resting_, point) && force * (bears ? bent.reactions : bent.rises).row(point).norm() > left)
        return false;
    }
    return true;
  }
  /// What a force on the pen does by the layers; mm.
  struct Moved {
    Eigen::Vector2d give, rises;
  };
  Moved moved_by(const Point& force) {
    const Bent &before = under_weights(), &then = under(force);
    return {then.give_at(force) - before.weighed_give, then.rises_at(force) - before.weighed_rises};
  }

 private:
  static unsigned set_of(bool tracer, bool pen) { return (tracer ? 1U : 0U) | (pen ? 2U : 0U); }
  static bool has(unsigned set, unsigned point) { return (set >> point & 1U) != 0; }

  /// The points that bear: all of them are pushed, and no other one lies below the table. Only one set can do that; where rounding leaves none,
  /// the one that is least wrong. A set that comes first and has no figures is taken, so that none are stated.
  unsigned bearing_under(const Point& force) {
    unsigned best = under_weights_;
    double least = infinity;
    for (const unsigned change : {0U, 1U, 2U, 3U}) {
      const unsigned bearing = under_weights_ ^ change;
      if ((change & ~resting_) != 0) continue;
      const Bent& bent = on(bearing);
      if (!bent.is_finite()) return bearing;
      const Eigen::Vector2d rises = bent.rises_at(force), reactions = bent.reactions_at(force);
      double wrong = 0;
      for (const unsigned point : {0U, 1U})
        if (has(resting_, point))
          wrong = std::max(wrong, has(bearing, point) ? -reactions[point] : -rises[point]);
      if (wrong >= least) continue;
      best = bearing;
      least = wrong;
      if (wrong == 0) break;
    }
    return best;
  }

  const Bent& on(unsigned bearing) {
    std::optional<Bent>& bent = bent_[bearing];
    if (!bent) bent = bent_on(bearing);
    return *bent;
  }

  Bent bent_on(unsigned bearing) const {
    const std::array<int, 2> points{static_cast<int>(of_.roles_.tracer), static_cast<int>(of_.roles_.pen)};
    std::vector<int> props;
    for (const unsigned point : {0U, 1U})
      if (has(bearing, point)) props.push_back(points[point]);
    const Grillage grillage(plan_, props);
    const Grillage::Tilted tilted = grillage.tilted_by(couples_);
    const GrillageState weighed = grillage.loaded();
    return {couples_.transpose() * tilted.slopes,
            tilted.rises(points, Eigen::all),
            tilted.reactions(points, Eigen::all),
            couples_.transpose() * weighed.slopes,
            weighed.rises(points),
            weighed.reactions(points),
            beam_moments(plan_, tilted.rises, tilted.slopes, false),
            beam_moments(plan_, weighed.rises, weighed.slopes, true)};
  }

  /// Of a newton at the pen, along x and along y, for Grillage::tilted_by.
  Eigen::MatrixX2d couples_at(double opening) const {
    const bool pole_is_at_V = of_.roles_.pole == Joint::V;
    const LayerAssignment& layers = of_.conditions_.layers;
    const auto high = heights(layers, pole_is_at_V);
    Eigen::MatrixX2d couples = Eigen::MatrixX2d::Zero(2 * static_cast<Eigen::Index>(plan_.nodes.size()), 2);
    for (int axis = 0; axis < 2; ++axis) {
      const Complex force = axis == 0 ? Complex(1) : Complex(0, 1);
      const auto forces =
          upward_forces(of_.shape_, layers, pole_is_at_V, opening, std::conj(of_.factor_) * force);
      for (std::size_t i = 0; i < pin_count; ++i) {
        const Point couple = as_point(0.5 * of_.conditions_.style.thickness * high[i] * forces[i]);
        couples.col(axis).segment<2>(2 * plan_.pins[i].node) += couple;
        if (plan_.pins[i].other) couples.col(axis).segment<2>(2 * *plan_.pins[i].other) += couple;
      }
    }
    return couples;
  }

  const LayeredErrorProfile& of_;
  GrillagePlan plan_;
  Eigen::MatrixX2d couples_;
  std::vector<PieceLines> lines_;
  unsigned resting_, under_weights_;
  std::array<std::optional<Bent>, 4> bent_{};
};

LayeredErrorProfile::LayeredErrorProfile(Complex k, Grounding grounding, const SagConditions& conditions,
                                         double pen_force)
    : shape_(shape_of(k, grounding)), factor_(pen_factor(k, grounding)), roles_(roles_of(grounding)),
      conditions_(conditions), sag_(k, grounding, conditions),
      upright_(k, grounding, conditions.style, Material{"", conditions.E, conditions.density, 0}, 1,
               upright_pins(grounding, conditions)),
      force_(pen_force) {}

Eigen::Matrix2d LayeredErrorProfile::upright(const BarLengths& lengths, double opening) const {
  Eigen::Matrix2d columns;
  columns.col(0) = as_point(upright_.displacement(lengths, opening, 1));
  columns.col(1) = as_point(upright_.displacement(lengths, opening, Complex(0, 1)));
  return columns;
}

Point LayeredErrorProfile::give(const BarLengths& lengths, double opening, const Point& force) const {
  Contacts contacts(*this, lengths, opening, sag_.supported_at(lengths.VA, lengths.VB, opening));
  return upright(lengths, opening) * force + contacts.moved_by(force).give;
}

LayeredErrorAt LayeredErrorProfile::at(const BarLengths& lengths, double opening) const {
  return at(lengths, opening, sag_.supported_at(lengths.VA, lengths.VB, opening));
}

LayeredErrorAt LayeredErrorProfile::at(const BarLengths& lengths, double opening,
                                       const SupportedStretch& under_weights) const {
  Contacts contacts(*this, lengths, opening, under_weights);
  const Eigen::Matrix2d upright = this->upright(lengths, opening);
  if (contacts.are_those_of_the_weights(force_)) {
    const Bent& bent = contacts.under_weights();
    return {force_ * larger_eigenvalue(upright + bent.compliance),
            force_ * std::max(bent.rises.row(0).norm(), bent.rises.row(1).norm())};
  }
  const auto force = [&](double direction) { return as_point(std::polar(force_, direction)); };
  return {most_over_directions([&](double direction) {
            return (upright * force(direction) + contacts.moved_by(force(direction)).give).norm();
          }),
          most_over_directions([&](double direction) {
            return contacts.moved_by(force(direction)).rises.cwiseAbs().maxCoeff();
          })};
}

/// The most that a link bears there, MPa; NaN where its moments have lost their digits.
double LayeredErrorProfile::most_stress(Contacts& contacts, Link link, double hole) const {
  const SectionModuli at_joints = section_moduli(conditions_.style, hole),
                      between = section_moduli(conditions_.style, 0);
  const bool is_linear = contacts.are_those_of_the_weights(force_);
  return most_over_directions(
      [&](double direction) {
        const Point force = as_point(std::polar(force_, direction));
        const Bent& bent = is_linear ? contacts.under_weights() : contacts.under(force);
        return contacts.stress(bent, link, force, at_joints, between);
      },
      is_linear ? parts_without : parts_with_contacts);
}

LinkStresses LayeredErrorProfile::stresses(const BarLengths& lengths, double opening, double hole) const {
  Contacts contacts(*this, lengths, opening, sag_.supported_at(lengths.VA, lengths.VB, opening));
  const auto of = [&](Link link) { return most_stress(contacts, link, hole); };
  return {of(Link::VA), of(Link::VB), of(Link::ACX), of(Link::BCY)};
}

/// Calls `look` with each interval of openings over which the figures are smooth, or nearly so, and the stretch that it is part of.
template <class Look>
void LayeredErrorProfile::for_each_part(const BarLengths& lengths, const OpeningInterval& openings,
                                        const Look& look) const {
  // Where a point comes to rest on the table or is lifted off it, by the weights or by the force, the figures have kinks.
  constexpr int parts_with_kinks = 4;
  const int parts = conditions_.tracer_rests || conditions_.pen_rests ? parts_with_kinks : 1;
  for (const SupportedStretch& stretch : sag_.stretches(lengths.VA, lengths.VB, openings))
    for (int i = 0; i < parts; ++i) {
      const double step = stretch.openings.width() / parts;
      look(OpeningInterval{stretch.openings.lower + i * step,
                           i + 1 == parts ? stretch.openings.upper : stretch.openings.lower + (i + 1) * step},
           stretch);
    }
}

std::optional<LayeredFigures> LayeredErrorProfile::over(const BarLengths& lengths,
                                                        const OpeningInterval& openings) const {
  LayeredFigures figures;
  for_each_part(lengths, openings, [&](const OpeningInterval& part, const SupportedStretch& stretch) {
    std::map<double, LayeredErrorAt> seen;
    const auto most = [&](double LayeredErrorAt::*figure) {
      const auto value = [&](double opening) {
        auto here = seen.find(opening);
        if (here == seen.end()) here = seen.emplace(opening, at(lengths, opening, stretch)).first;
        return std::isfinite(here->second.*figure) ? here->second.*figure : infinity;
      };
      return value(top_over(part, value));
    };
    figures.error_max = std::max(figures.error_max, most(&LayeredErrorAt::in_plane));
    figures.rise_max = std::max(figures.rise_max, most(&LayeredErrorAt::rise));
  });
  return std::isfinite(figures.error_max) && std::isfinite(figures.rise_max) ? std::optional(figures)
                                                                             : std::nullopt;
}

std::optional<LinkStresses> LayeredErrorProfile::stresses_over(const BarLengths& lengths,
                                                               const OpeningInterval& openings,
                                                               double hole) const {
  if (!(hole < conditions_.style.width)) return LinkStresses{infinity, infinity, infinity, infinity};
  LinkStresses most;
  for_each_part(lengths, openings, [&](const OpeningInterval& part, const SupportedStretch& stretch) {
    std::map<double, Contacts> seen;
    const auto look = [&](Link link, double LinkStresses::*figure) {
      const auto value = [&](double opening) {
        auto here = seen.find(opening);
        if (here == seen.end())
          here = seen.emplace(opening, Contacts(*this, lengths, opening, stretch)).first;
        const double stress = most_stress(here->second, link, hole);
        return std::isfinite(stress) ? stress : infinity;
      };
      most.*figure = std::max(most.*figure, value(top_over(part, value)));
    };
    look(Link::VA, &LinkStresses::VA);
    look(Link::VB, &LinkStresses::VB);
    look(Link::ACX, &LinkStresses::ACX);
    look(Link::BCY, &LinkStresses::BCY);
  });
  return std::isfinite(most.largest()) ? std::optional(most) : std::nullopt;
}

}  // namespace kempe
