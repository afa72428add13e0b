#include "synthesis/loads/layer_offsets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "specs/hardware.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/link_arms.hpp"
#include "synthesis/loads/over_directions.hpp"
#include "synthesis/loads/pin_compliance.hpp"
#include "synthesis/loads/steel.hpp"
#include "synthesis/loads/top_over.hpp"

namespace kempe {
namespace {

/// Pins of SagProfile::plan in their order.
enum : std::size_t { at_pole, at_V, at_A, at_B, at_C, pin_count };

/// Of VA and VB.
Link upper_bar(const LayerAssignment& layers) {
  return layers[Link::VA] > layers[Link::VB] ? Link::VA : Link::VB;
}

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

/// The same under the links' own weight along the table.
std::array<Complex, pin_count> upward_forces(const UnderWeight& weight, const LayerAssignment& layers,
                                             bool pole_is_at_V) {
  const auto on = [&](Link link, Joint joint) {
    return weight.by_pins[static_cast<std::size_t>(link)][static_cast<std::size_t>(joint)];
  };
  const auto upper = [&](Link one, Link other, Joint joint) {
    return layers[one] > layers[other] ? on(one, joint) : -on(one, joint);
  };
  const Complex between =
      pole_is_at_V ? on(upper_bar(layers), Joint::V) : upper(Link::VB, Link::VA, Joint::V);
  return {weight.post, between, upper(Link::ACX, Link::VA, Joint::A), upper(Link::BCY, Link::VB, Joint::B),
          upper(Link::ACX, Link::BCY, Joint::C)};
}

/// Heights of the same pins between the middles of what they join, in layers.
std::array<double, pin_count> heights(const LayerAssignment& layers, bool pole_is_at_V) {
  const auto between = [&](Link one, Link other) { return std::abs(layers[one] - layers[other]) * 1.0; };
  const int standing = pole_is_at_V ? std::min(layers[Link::VA], layers[Link::VB]) : layers[Link::ACX];
  return {standing - 0.5, between(Link::VA, Link::VB), between(Link::VA, Link::ACX),
          between(Link::VB, Link::BCY), between(Link::ACX, Link::BCY)};
}

/// What the pins give while their ends do not tilt; at the pole's post the upper of the two bars stands on what lies between it and the lower
/// one, which is the pin at V.
PinCompliance pins_by_place(Grounding grounding, const SagConditions& conditions) {
  const LayerAssignment& layers = conditions.layers;
  const Joint pole = roles_of(grounding).pole;
  PinCompliance pins = pin_compliance(grounding, layers, conditions.style, conditions.hardware);
  const double height = conditions.style.thickness * heights(layers, pole == Joint::V)[at_pole];
  pins.pole = upright_pin(pin_at(conditions.style, conditions.hardware, pole), height);
  return pins;
}
/// The bar whose end pulls at the pin at V.
Link bar_on_pin_V(Grounding grounding, const SagConditions& conditions) {
  return pole_is_at_V(grounding) ? upper_bar(conditions.layers) : Link::VB;
}
/// The same as the force on the pen counts them: each bar pulls as hard at V as at its other end.
PinCompliance upright_pins(Grounding grounding, const SagConditions& conditions) {
  PinCompliance pins = pins_by_place(grounding, conditions);
  if (bar_on_pin_V(grounding, conditions) == Link::VA) pins.A += std::exchange(pins.V, 0.0);
  return pins;
}

/// A link's part of stresses.
double& of_link(LinkStresses& stresses, Link link) {
  return link == Link::VA    ? stresses.VA
         : link == Link::VB  ? stresses.VB
         : link == Link::ACX ? stresses.ACX
                             : stresses.BCY;
}

/// The larger eigenvalue of a symmetric matrix.
double larger_eigenvalue(const Eigen::Matrix2d& matrix) {
  const double mean = 0.5 * matrix.trace();
  return mean + std::hypot(0.5 * (matrix(0, 0) - matrix(1, 1)), 0.5 * (matrix(0, 1) + matrix(1, 0)));
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
  Eigen::Matrix2d compliance, rises, reactions;  ///< mm/N, mm/N and N/N, by the force
  Eigen::Vector2d weighed_give = Eigen::Vector2d::Zero(), weighed_rises = weighed_give,
                  weighed_reactions = weighed_give;  ///< mm, mm and N, by the weights

  Eigen::Vector2d give_at(const Point& force) const { return weighed_give + compliance * force; }
  Eigen::Vector2d rises_at(const Point& force) const { return weighed_rises + rises * force; }
  Eigen::Vector2d reactions_at(const Point& force) const { return weighed_reactions + reactions * force; }
  bool is_finite() const { return compliance.allFinite() && weighed_rises.allFinite(); }
};

/// What beams bear out of the plane while a given set of points bears, of beam_moments.
struct LayeredErrorProfile::Moments {
  Eigen::MatrixX2d by_force;   ///< N mm/N
  Eigen::VectorXd by_weights;  ///< N mm
};

/// What the links' own weight along the table does while a given set of points bears: a column for gravity along x and along y.
struct LayeredErrorProfile::OwnWeight {
  Eigen::Matrix2d give, rises;                       ///< mm, of the pen in the plane; of tracer and pen
  std::vector<std::array<PieceForces, 2>> pieces{};  ///< of the plan's beams
};

/// Which points bear under the weights and a force, at one opening, and what the force does. Refers to the profile.
class LayeredErrorProfile::Contacts {
 public:
  Contacts(const LayeredErrorProfile& of, const BarLengths& lengths, double opening,
           const SupportedStretch& under_weights)
      : of_(of), plan_(of.sag_.plan(lengths.VA, lengths.VB, opening)), couples_(couples_at(opening)),
        resting_(set_of(of.conditions_.tracer_rests, of.conditions_.pen_rests)),
        under_weights_(set_of(under_weights.tracer_bears, under_weights.pen_bears)), lengths_(lengths),
        opening_(opening) {}

  unsigned set_under_weights() const { return under_weights_; }
  const Bent& under_weights() { return on(under_weights_); }
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
  /// MPa: the largest stress in a link under a force and the weights while these points bear.
  double stress(unsigned bearing, Link link, const Point& force, const SectionModuli& at_joints,
                const SectionModuli& between) {
    const Moments& moments = moments_on(bearing);
    if (lines_.empty()) lines_ = piece_lines(plan_, of_.shape_, of_.factor_, opening_);
    double largest = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const PieceLines& piece = lines_[i];
      if (piece.link != link) continue;
      const auto along = [&](Complex line) { return as_point(line).dot(force); };
      const auto moment = [&](Eigen::Index row) {
        row += 3 * static_cast<Eigen::Index>(i);
        return moments.by_weights[row] + moments.by_force.row(row).dot(force);
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
  /// What the links' own weight along the table does, by the layers in the plane too, while these points bear.
  OwnWeight own_weight(unsigned bearing) const;
  /// The sets of points that may bear.
  std::vector<unsigned> sets() const {
    std::vector<unsigned> all;
    for (const unsigned bearing : {0U, 1U, 2U, 3U})
      if ((bearing & ~resting_) == 0) all.push_back(bearing);
    return all;
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
    const Bent &before = under_weights(), &then = on(bearing_under(force));
    return {then.give_at(force) - before.weighed_give, then.rises_at(force) - before.weighed_rises};
  }

 private:
  static unsigned set_of(bool tracer, bool pen) { return (tracer ? 1U : 0U) | (pen ? 2U : 0U); }
  static bool has(unsigned set, unsigned point) { return (set >> point & 1U) != 0; }

  const Bent& on(unsigned bearing) {
    std::optional<Bent>& bent = bent_[bearing];
    if (!bent) bent = bent_on(bearing);
    return *bent;
  }

  /// Tracer and pen.
  std::array<int, 2> points() const {
    return {static_cast<int>(of_.roles_.tracer), static_cast<int>(of_.roles_.pen)};
  }
  Grillage grillage_on(unsigned bearing) const {
    std::vector<int> props;
    for (const unsigned point : {0U, 1U})
      if (has(bearing, point)) props.push_back(points()[point]);
    return Grillage(plan_, props);
  }

  /// The links on a set of points, and how the force bends them.
  struct Loaded {
    Grillage grillage;
    Grillage::Tilted tilted;
  };
  const Loaded& loaded_on(unsigned bearing) {
    std::optional<Loaded>& loaded = loaded_[bearing];
    if (!loaded) {
      Grillage grillage = grillage_on(bearing);
      Grillage::Tilted tilted = grillage.tilted_by(couples_);
      loaded.emplace(Loaded{std::move(grillage), std::move(tilted)});
    }
    return *loaded;
  }

  Bent bent_on(unsigned bearing) {
    const std::array<int, 2> points = this->points();
    const auto& [grillage, tilted] = loaded_on(bearing);
    Bent bent{couples_.transpose() * tilted.slopes, tilted.rises(points, Eigen::all),
              tilted.reactions(points, Eigen::all)};
    if (resting_ == 0) return bent;  // nothing for the weights to press down
    const GrillageState weighed = grillage.loaded();
    bent.weighed_give = couples_.transpose() * weighed.slopes;
    bent.weighed_rises = weighed.rises(points);
    bent.weighed_reactions = weighed.reactions(points);
    return bent;
  }

  const Moments& moments_on(unsigned bearing) {
    std::optional<Moments>& moments = moments_[bearing];
    if (!moments) {
      const auto& [grillage, tilted] = loaded_on(bearing);
      const GrillageState weighed = grillage.loaded();
      moments.emplace(Moments{beam_moments(plan_, tilted.rises, tilted.slopes, false),
                              beam_moments(plan_, weighed.rises, weighed.slopes, true)});
    }
    return *moments;
  }

  /// Of a newton at the pen, along x and along y, for Grillage::tilted_by.
  Eigen::MatrixX2d couples_at(double opening) const {
    return couples_of([&](Complex force) {
      return upward_forces(of_.shape_, of_.conditions_.layers, of_.roles_.pole == Joint::V, opening,
                           std::conj(of_.factor_) * force);
    });
  }
  /// Of the links' own weight, where gravity pulls along x and along y.
  Eigen::MatrixX2d couples_of_weight() const {
    return couples_of([&](Complex direction) {
      return upward_forces(of_.weight_.under(lengths_, opening_, direction), of_.conditions_.layers,
                           of_.roles_.pole == Joint::V);
    });
  }
  /// A column for each axis, of the pins' forces that forces_along(axis) are.
  template <class Forces>
  Eigen::MatrixX2d couples_of(const Forces& forces_along) const {
    const auto high = heights(of_.conditions_.layers, of_.roles_.pole == Joint::V);
    Eigen::MatrixX2d couples = Eigen::MatrixX2d::Zero(2 * static_cast<Eigen::Index>(plan_.nodes.size()), 2);
    for (int axis = 0; axis < 2; ++axis) {
      const std::array<Complex, pin_count> forces = forces_along(axis == 0 ? Complex(1) : Complex(0, 1));
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
  std::vector<PieceLines> lines_;  ///< empty until a stress is asked for
  unsigned resting_, under_weights_;
  BarLengths lengths_;
  double opening_;
  std::array<std::optional<Loaded>, 4> loaded_{};
  std::array<std::optional<Bent>, 4> bent_{};
  std::array<std::optional<Moments>, 4> moments_{};
};

LayeredErrorProfile::OwnWeight LayeredErrorProfile::Contacts::own_weight(unsigned bearing) const {
  const Grillage::Tilted tilted = grillage_on(bearing).tilted_by(couples_of_weight());
  OwnWeight own{of_.weight_.give(lengths_, opening_) + couples_.transpose() * tilted.slopes,
                tilted.rises(points(), Eigen::all)};
  const Eigen::MatrixX2d moments = beam_moments(plan_, tilted.rises, tilted.slopes, false);
  const std::vector<PieceForces> by_x = of_.weight_.pieces(lengths_, opening_, 1),
                                 by_y = of_.weight_.pieces(lengths_, opening_, Complex(0, 1));
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    std::array<PieceForces, 2> by_axis{by_x[i], by_y[i]};
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
    for (const std::size_t axis : {0U, 1U}) {
      const auto moment = [&](Eigen::Index k) { return moments(row + k, static_cast<Eigen::Index>(axis)); };
      by_axis[axis].out_of_plane = {moment(0), moment(1)};
      by_axis[axis].twist = moment(2);
    }
    own.pieces.push_back(by_axis);
  }
  return own;
}

LayeredErrorProfile::LayeredErrorProfile(Complex k, Grounding grounding, const SagConditions& conditions,
                                         double pen_force)
    : shape_(shape_of(k, grounding)), factor_(pen_factor(k, grounding)), roles_(roles_of(grounding)),
      conditions_(conditions), sag_(k, grounding, conditions),
      upright_(k, grounding, conditions.style, Material{"", conditions.E, conditions.density, 0}, 1,
               upright_pins(grounding, conditions)),
      weight_(k, grounding, conditions.style, Material{"", conditions.E, conditions.density, 0},
              conditions.tilt, pins_by_place(grounding, conditions), bar_on_pin_V(grounding, conditions)),
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
        const unsigned bearing = is_linear ? contacts.set_under_weights() : contacts.bearing_under(force);
        return contacts.stress(bearing, link, force, at_joints, between);
      },
      is_linear ? parts_without : parts_with_contacts);
}

LinkStresses LayeredErrorProfile::stresses(const BarLengths& lengths, double opening, double hole) const {
  Contacts contacts(*this, lengths, opening, sag_.supported_at(lengths.VA, lengths.VB, opening));
  const auto of = [&](Link link) { return most_stress(contacts, link, hole); };
  return {of(Link::VA), of(Link::VB), of(Link::ACX), of(Link::BCY)};
}

LayeredErrorAt LayeredErrorProfile::by_weight(const BarLengths& lengths, double opening) const {
  if (!weight_.weighs()) return {};
  LayeredErrorAt most;
  const Contacts contacts(*this, lengths, opening, {{opening, opening}});
  for (const unsigned bearing : contacts.sets()) {
    const OwnWeight own = contacts.own_weight(bearing);
    if (!own.give.allFinite() || !own.rises.allFinite()) return {infinity, infinity};
    most.in_plane = std::max(most.in_plane, larger_singular_value(own.give));
    most.rise = std::max({most.rise, own.rises.row(0).norm(), own.rises.row(1).norm()});
  }
  return most;
}

LinkStresses LayeredErrorProfile::stresses_by_weight(const BarLengths& lengths, double opening,
                                                     double hole) const {
  LinkStresses most;
  if (!weight_.weighs()) return most;
  const SectionModuli at_joints = section_moduli(conditions_.style, hole),
                      between = section_moduli(conditions_.style, 0);
  const Contacts contacts(*this, lengths, opening, {{opening, opening}});
  for (const unsigned bearing : contacts.sets()) {
    const OwnWeight own = contacts.own_weight(bearing);
    std::size_t piece = 0;
    for (const Link link : all_links)
      for (std::size_t arm = 0; arm < arms_of(link, shape_).size(); ++arm, ++piece) {
        const double here = most_over_directions(
            [&](double direction) {
              return largest_stress(turned(own.pieces[piece], direction), at_joints, between);
            },
            parts_without);
        double& of = of_link(most, link);
        of = std::max(of, std::isfinite(here) ? here : infinity);
      }
  }
  return most;
}

Eigen::Vector2d LayeredErrorProfile::give_by_weight(const BarLengths& lengths, double opening,
                                                    const Point& direction) const {
  if (!weight_.weighs()) return Eigen::Vector2d::Zero();
  const SupportedStretch under_weights = sag_.supported_at(lengths.VA, lengths.VB, opening);
  const Contacts contacts(*this, lengths, opening, under_weights);
  return contacts.own_weight(contacts.set_under_weights()).give * direction;
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

/// The most of one of the figures over a part; `seen`: what has been looked at there.
double LayeredErrorProfile::most_of(const BarLengths& lengths, const OpeningInterval& part,
                                    const SupportedStretch& stretch, double LayeredErrorAt::*figure,
                                    std::map<double, LayeredErrorAt>& seen) const {
  const auto value = [&](double opening) {
    auto here = seen.find(opening);
    if (here == seen.end()) here = seen.emplace(opening, at(lengths, opening, stretch)).first;
    return std::isfinite(here->second.*figure) ? here->second.*figure : infinity;
  };
  return value(top_over(part, value));
}

std::optional<LayeredFigures> LayeredErrorProfile::over(const BarLengths& lengths,
                                                        const OpeningInterval& openings) const {
  LayeredFigures figures;
  for_each_part(lengths, openings, [&](const OpeningInterval& part, const SupportedStretch& stretch) {
    std::map<double, LayeredErrorAt> seen;
    const auto most = [&](double LayeredErrorAt::*figure) {
      return most_of(lengths, part, stretch, figure, seen);
    };
    figures.error_max = std::max(figures.error_max, most(&LayeredErrorAt::in_plane));
    figures.rise_max = std::max(figures.rise_max, most(&LayeredErrorAt::rise));
  });
  if (!std::isfinite(figures.error_max) || !std::isfinite(figures.rise_max)) return std::nullopt;
  if (!weight_.weighs()) return figures;
  const LayeredErrorAt by_weight = by_weight_over(lengths, openings);
  if (!std::isfinite(by_weight.in_plane) || !std::isfinite(by_weight.rise)) return std::nullopt;
  figures.weight_error_max = by_weight.in_plane;
  figures.weight_rise_max = by_weight.rise;
  return figures;
}

double LayeredErrorProfile::give_over(const BarLengths& lengths, const OpeningInterval& openings) const {
  double most = 0;
  for_each_part(lengths, openings, [&](const OpeningInterval& part, const SupportedStretch& stretch) {
    std::map<double, LayeredErrorAt> seen;
    most = std::max(most, most_of(lengths, part, stretch, &LayeredErrorAt::in_plane, seen));
  });
  return most;
}

LayeredErrorAt LayeredErrorProfile::by_weight_over(const BarLengths& lengths,
                                                   const OpeningInterval& openings) const {
  if (!weight_.weighs()) return {};
  const auto most = [&](double LayeredErrorAt::*figure) {
    const auto value = [&](double opening) { return by_weight(lengths, opening).*figure; };
    return value(top_over(openings, value));
  };
  return {most(&LayeredErrorAt::in_plane), most(&LayeredErrorAt::rise)};
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
  if (weight_.weighs())
    for (const Link link : all_links) {
      const auto value = [&](double opening) {
        LinkStresses here = stresses_by_weight(lengths, opening, hole);
        return of_link(here, link);
      };
      of_link(most, link) += value(top_over(openings, value));
    }
  return std::isfinite(most.largest()) ? std::optional(most) : std::nullopt;
}

double give_in_all(const Spec& spec, const CopyingLinkage& linkage, const LayerAssignment& layers,
                   const OpeningInterval& openings) {
  const BarLengths lengths{linkage.VA(), linkage.VB()};
  const LayeredErrorProfile profile(linkage.k(), linkage.grounding(), sag_conditions(spec, layers),
                                    most_force_at_pen(*spec.load));
  const double links =
      load_error_profile(spec, linkage.k(), linkage.grounding()).worst_over(lengths, openings);
  return std::max(links, profile.give_over(lengths, openings)) +
         profile.by_weight_over(lengths, openings).in_plane;
}

}  // namespace kempe
