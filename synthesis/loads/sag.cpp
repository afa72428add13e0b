#include "synthesis/loads/sag.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "specs/hardware.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/link_arms.hpp"
#include "synthesis/loads/steel.hpp"
#include "synthesis/loads/top_over.hpp"

namespace kempe {
namespace {

constexpr int number_of(Joint joint) { return static_cast<int>(joint); }

/// Which node of the plan is this link at this joint.
int node_of(Link link, Joint joint) {
  int first = 0;
  for (const Link other : all_links) {
    if (other == link) break;
    first += joints_of(other).count;
  }
  const LinkJoints of_link = joints_of(link);
  return first + static_cast<int>(std::find(of_link.joints.begin(), of_link.joints.end(), joint) -
                                  of_link.joints.begin());
}

/// Weights gathered at joints.
struct Lumps {
  GrillagePlan& plan;
  double weight_of_area;  ///< N/mm^2
  void add(Joint joint, double area) {
    plan.weights[static_cast<std::size_t>(joint)] += weight_of_area * area;
  }
};

/// A triangle grown by half a width: its area at its corners in equal parts, which has the same centre of mass, and the strips along
/// its sides at their ends.
void add_triangle(const LinkJoints& link, double width, Lumps& lumps) {
  std::array<Complex, 3> at{};
  for (std::size_t i = 0; i < 3; ++i) at[i] = lumps.plan.joints[static_cast<std::size_t>(link.joints[i])];
  const Complex a = at[1] - at[0], b = at[2] - at[0];
  const double inside = 0.5 * std::abs((std::conj(a) * b).imag());
  for (std::size_t i = 0; i < 3; ++i) {
    const double sides = std::abs(at[(i + 1) % 3] - at[i]) + std::abs(at[(i + 2) % 3] - at[i]);
    lumps.add(link.joints[i], inside / 3 + 0.25 * width * sides + pi * width * width / 12);
  }
}

}  // namespace

double torsion_constant(double width, double thickness) {
  const double wide = std::max(width, thickness), thin = std::min(width, thickness), ratio = thin / wide;
  return wide * std::pow(thin, 3) * (1.0 / 3 - 0.21 * ratio * (1 - std::pow(ratio, 4) / 12));
}

FlatBar flat_bar(const LinkStyle& style, double E, double G) {
  return {E * style.width * std::pow(style.thickness, 3) / 12,
          G * torsion_constant(style.width, style.thickness)};
}

double SagAt::most() const {
  const double of_tracer = tracer.total(), of_pen = pen.total();
  if (!std::isfinite(of_tracer) || !std::isfinite(of_pen)) return infinity;
  return std::max({0.0, of_tracer, of_pen});
}

SagProfile::SagProfile(Complex k, Grounding grounding, const SagConditions& conditions)
    : shape_(shape_of(k, grounding)), roles_(roles_of(grounding)), conditions_(conditions),
      bar_(flat_bar(conditions.style, conditions.E, conditions.G)),
      pins_(pin_diameters(conditions.style, conditions.hardware)), down_(gravity_across(conditions.tilt)) {
  for (double& pin : pins_) pin = steel::E * pi * std::pow(pin, 4) / 64;
}

void SagProfile::add_links(GrillagePlan& plan) const {
  const bool triangles = conditions_.style.plate == PlateStyle::triangle && !is_straight(shape_);
  const double each_mm = down_ * conditions_.density * cubic_metres_per_mm3 * conditions_.style.width *
                         conditions_.style.thickness;
  for (const Link link : all_links) {
    const LinkJoints of_link = joints_of(link);
    for (int i = 0; i < of_link.count; ++i)
      plan.nodes.push_back(number_of(of_link.joints[static_cast<std::size_t>(i)]));
    for (const LinkArm& arm : arms_of(link, shape_))
      plan.beams.push_back({node_of(link, arm.from), node_of(link, arm.to), bar_.bending, bar_.torsion,
                            triangles && of_link.count == 3 ? 0 : each_mm});
  }
}

void SagProfile::add_weights(GrillagePlan& plan) const {
  const double width = conditions_.style.width;
  const bool triangles = conditions_.style.plate == PlateStyle::triangle && !is_straight(shape_);
  Lumps lumps{plan, down_ * conditions_.density * cubic_metres_per_mm3 * conditions_.style.thickness};
  for (const Link link : all_links) {
    const LinkJoints of_link = joints_of(link);
    if (of_link.count == 3 && triangles) {
      add_triangle(of_link, width, lumps);
      continue;
    }
    for (const Joint end : ends_of(arms_of(link, shape_))) lumps.add(end, pi * width * width / 8);
  }
  plan.weights[static_cast<std::size_t>(roles_.pen)] += down_ * conditions_.pen_mass;
  plan.weights[static_cast<std::size_t>(roles_.tracer)] += down_ * conditions_.tracer_mass;
}

void SagProfile::add_pins(GrillagePlan& plan) const {
  const LayerAssignment& layers = conditions_.layers;
  const double thickness = conditions_.style.thickness;
  const auto bending = [&](Joint joint) { return pins_[static_cast<std::size_t>(joint)]; };
  const auto join = [&](Joint joint, Link one, Link other) {
    const double apart = thickness * std::abs(layers[one] - layers[other]);
    plan.pins.push_back({node_of(one, joint), node_of(other, joint), bending(joint) / apart});
  };
  const auto stand = [&](Joint joint, Link link) {
    const double height = thickness * (layers[link] - 0.5);
    plan.pins.push_back({node_of(link, joint), std::nullopt, bending(joint) / height});
  };
  if (roles_.pole == Joint::V) {
    const bool VA_is_lower = layers[Link::VA] < layers[Link::VB];
    const Link lower = VA_is_lower ? Link::VA : Link::VB, upper = VA_is_lower ? Link::VB : Link::VA;
    stand(Joint::V, lower);
    plan.pins.back().goes_on = static_cast<int>(plan.pins.size());
    join(Joint::V, upper, lower);
  } else {
    stand(Joint::X, Link::ACX);
    join(Joint::V, Link::VA, Link::VB);
  }
  join(Joint::A, Link::VA, Link::ACX);
  join(Joint::B, Link::VB, Link::BCY);
  join(Joint::C, Link::ACX, Link::BCY);
}

GrillagePlan SagProfile::plan(double VA, double VB, double opening) const {
  GrillagePlan plan;
  for (const Joint joint : all_joints) {
    const LinkagePoint point = linkage_point(joint, shape_);
    plan.joints.push_back(point.of_p * VA + point.of_q * std::polar(VB, opening));
  }
  plan.weights.assign(plan.joints.size(), 0);
  add_links(plan);
  add_weights(plan);
  add_pins(plan);
  return plan;
}

StandingGrillage SagProfile::stands(const GrillagePlan& plan) const {
  std::vector<int> props;
  if (conditions_.tracer_rests) props.push_back(number_of(roles_.tracer));
  if (conditions_.pen_rests) props.push_back(number_of(roles_.pen));
  return standing(plan, props);
}

SupportedStretch SagProfile::supported_at(double VA, double VB, double opening) const {
  if (!conditions_.tracer_rests && !conditions_.pen_rests) return {{opening, opening}};
  const std::vector<int> props = stands(plan(VA, VB, opening)).props;
  const auto bears = [&](Joint joint) {
    return std::find(props.begin(), props.end(), number_of(joint)) != props.end();
  };
  return {{opening, opening}, bears(roles_.tracer), bears(roles_.pen)};
}

std::vector<SupportedStretch> SagProfile::stretches(double VA, double VB,
                                                    const OpeningInterval& openings) const {
  constexpr int parts = 64, halvings = 40;
  if (!conditions_.tracer_rests && !conditions_.pen_rests) return {{openings}};
  const auto alike = [](const SupportedStretch& one, const SupportedStretch& other) {
    return one.tracer_bears == other.tracer_bears && one.pen_bears == other.pen_bears;
  };
  std::vector<SupportedStretch> all{supported_at(VA, VB, openings.lower)};
  for (int i = 1; i <= parts; ++i) {
    const SupportedStretch next =
        supported_at(VA, VB, i == parts ? openings.upper : openings.lower + openings.width() * i / parts);
    // Two points may change one after the other within one part.
    for (int change = 0; change < 4 && !alike(all.back(), next); ++change) {
      SupportedStretch after = next;
      double& before = all.back().openings.upper;
      for (int half = 0; half < halvings; ++half) {
        const SupportedStretch middle = supported_at(VA, VB, 0.5 * (before + after.openings.lower));
        if (alike(middle, all.back()))
          before = middle.openings.upper;
        else
          after = middle;
      }
      all.push_back(after);
    }
    all.back().openings.upper = next.openings.upper;
  }
  return all;
}

SagJet SagProfile::jet(double VA, double VB, double opening, Carrier point) const {
  const int joint = number_of(point == Carrier::tracer ? roles_.tracer : roles_.pen);
  const StandingGrillage stood = stands(plan(VA, VB, opening));
  SagJet jet;
  if (!stood.state.rises.allFinite()) return {.value = infinity};
  if (std::find(stood.props.begin(), stood.props.end(), joint) != stood.props.end()) return jet;
  const double tilt = conditions_.play / conditions_.grip;
  jet.value = -stood.state.rises[joint];
  if (tilt > 0)
    for (const double each : stood.grillage.drop_by_tilt(joint)) jet.value += tilt * each;
  const NearbyDrop nearby(stood.grillage, joint, tilt);
  for (int i = 0; i < 3; ++i) {
    const auto beside = [&](double step) {
      return nearby.estimate(plan(i == 0 ? VA * std::exp(step) : VA, i == 1 ? VB * std::exp(step) : VB,
                                  i == 2 ? opening + step : opening));
    };
    // Of an expression in closed form: the difference is off by step^2 and by rounding / step.
    constexpr double step = 1e-5;
    jet.gradient[i] = (beside(step) - beside(-step)) / (2 * step);
  }
  return jet;
}

SagAt SagProfile::at(double VA, double VB, double opening) const {
  const StandingGrillage stands = this->stands(plan(VA, VB, opening));
  const double tilt = conditions_.play / conditions_.grip;
  const auto drop = [&](Joint joint) {
    const int number = number_of(joint);
    Drop result{-stands.state.rises[number], 0};
    if (tilt > 0)
      for (const double each : stands.grillage.drop_by_tilt(number)) result.by_play += tilt * each;
    return result;
  };
  return {drop(roles_.tracer), drop(roles_.pen), stands.state.reactions[number_of(roles_.tracer)],
          stands.state.reactions[number_of(roles_.pen)]};
}

SagConditions sag_conditions(const Spec& spec, const LayerAssignment& layers) {
  const Load load = spec.load.value_or(Load{});
  const Material material = spec.material.value_or(Material{});
  return {.style = spec.links.style,
          .hardware = spec.links.hardware,
          .layers = layers,
          .E = material.E,
          .G = material.shear_modulus(),
          .density = material.density,
          .pen_mass = load.pen_mass,
          .tracer_mass = load.tracer_mass,
          .tilt = load.tilt,
          .play = spec.tolerance ? spec.tolerance->play : 0,
          .grip = load.grip.value_or(spec.links.style.thickness),
          .tracer_rests = load.rests_at(Carrier::tracer),
          .pen_rests = load.rests_at(Carrier::pen)};
}

namespace {

/// Where value(opening) is largest, over openings in which what play does may jump.
template <class Value>
double top_between_jumps(const SagProfile& profile, const CopyingLinkage& linkage,
                         const OpeningInterval& openings, const Value& value) {
  double best = openings.lower, best_value = -infinity;
  for (const SupportedStretch& stretch : profile.stretches(linkage.VA(), linkage.VB(), openings)) {
    const double top = top_over(stretch.openings, value);
    if (const double here = value(top); here > best_value) {
      best = top;
      best_value = here;
    }
  }
  return best;
}

}  // namespace

LargestSag largest_sag(const CopyingLinkage& linkage, const SagConditions& conditions,
                       const OpeningInterval& openings) {
  const SagProfile profile(linkage.k(), linkage.grounding(), conditions);
  const auto sag = [&](double opening) { return profile.at(linkage.VA(), linkage.VB(), opening); };
  const double opening =
      top_between_jumps(profile, linkage, openings, [&](double at) { return sag(at).most(); });
  return {sag(opening), opening};
}

LargestDrops largest_drops(const CopyingLinkage& linkage, const SagConditions& conditions,
                           const OpeningInterval& openings) {
  const SagProfile profile(linkage.k(), linkage.grounding(), conditions);
  const auto sag = [&](double opening) { return profile.at(linkage.VA(), linkage.VB(), opening); };
  const auto top = [&](Drop SagAt::*drop) {
    return sag(top_between_jumps(profile, linkage, openings, [&](double at) {
      const double here = (sag(at).*drop).total();
      return std::isfinite(here) ? here : infinity;
    }));
  };
  return {.tracer = top(&SagAt::tracer), .pen = top(&SagAt::pen)};
}

}  // namespace kempe
