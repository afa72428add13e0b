#include "synthesis/loads/layer_offsets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "specs/hardware.hpp"
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

}  // namespace

struct LayeredErrorProfile::Bent {
  Eigen::Matrix2d compliance;                ///< mm/N, by the layers alone
  Eigen::RowVector2d tracer_rise, pen_rise;  ///< mm/N
};

LayeredErrorProfile::LayeredErrorProfile(Complex k, Grounding grounding, const SagConditions& conditions,
                                         double pen_force)
    : shape_(shape_of(k, grounding)), factor_(pen_factor(k, grounding)), roles_(roles_of(grounding)),
      conditions_(conditions), sag_(k, grounding, conditions),
      upright_(k, grounding, conditions.style, Material{"", conditions.E, conditions.density, 0}, 1,
               upright_pins(grounding, conditions)),
      force_(pen_force) {}

LayeredErrorProfile::Bent LayeredErrorProfile::bent(const BarLengths& lengths, double opening,
                                                    const SupportedStretch& on) const {
  const bool pole_is_at_V = roles_.pole == Joint::V;
  const LayerAssignment& layers = conditions_.layers;
  const GrillagePlan plan = sag_.plan(lengths.VA, lengths.VB, opening);
  std::vector<int> props;
  if (on.tracer_bears) props.push_back(static_cast<int>(roles_.tracer));
  if (on.pen_bears) props.push_back(static_cast<int>(roles_.pen));
  const auto high = heights(layers, pole_is_at_V);
  Eigen::Matrix<double, Eigen::Dynamic, 2> couples =
      Eigen::Matrix<double, Eigen::Dynamic, 2>::Zero(2 * static_cast<Eigen::Index>(plan.nodes.size()), 2);
  for (int axis = 0; axis < 2; ++axis) {
    const Complex force = axis == 0 ? Complex(1) : Complex(0, 1);
    const auto forces = upward_forces(shape_, layers, pole_is_at_V, opening, std::conj(factor_) * force);
    for (std::size_t i = 0; i < pin_count; ++i) {
      const Point couple = as_point(0.5 * conditions_.style.thickness * high[i] * forces[i]);
      couples.col(axis).segment<2>(2 * plan.pins[i].node) += couple;
      if (plan.pins[i].other) couples.col(axis).segment<2>(2 * *plan.pins[i].other) += couple;
    }
  }
  const Grillage::Tilted tilted = Grillage(plan, props).tilted_by(couples);
  return {couples.transpose() * tilted.slopes, tilted.rises.row(static_cast<int>(roles_.tracer)),
          tilted.rises.row(static_cast<int>(roles_.pen))};
}

Eigen::Matrix2d LayeredErrorProfile::upright(const BarLengths& lengths, double opening) const {
  Eigen::Matrix2d columns;
  columns.col(0) = as_point(upright_.displacement(lengths, opening, 1));
  columns.col(1) = as_point(upright_.displacement(lengths, opening, Complex(0, 1)));
  return columns;
}

Eigen::Matrix2d LayeredErrorProfile::compliance(const BarLengths& lengths, double opening) const {
  return upright(lengths, opening) +
         bent(lengths, opening, sag_.supported_at(lengths.VA, lengths.VB, opening)).compliance;
}

LayeredErrorAt LayeredErrorProfile::at(const BarLengths& lengths, double opening) const {
  return at(lengths, opening, sag_.supported_at(lengths.VA, lengths.VB, opening));
}

LayeredErrorAt LayeredErrorProfile::at(const BarLengths& lengths, double opening,
                                       const SupportedStretch& on) const {
  const Bent bent = this->bent(lengths, opening, on);
  return {force_ * larger_eigenvalue(upright(lengths, opening) + bent.compliance),
          force_ * std::max(bent.tracer_rise.norm(), bent.pen_rise.norm())};
}

std::optional<LayeredFigures> LayeredErrorProfile::over(const BarLengths& lengths,
                                                        const OpeningInterval& openings) const {
  // Where a point comes to rest on the table or is lifted off it the figures jump.
  const std::vector<SupportedStretch> stretches = sag_.stretches(lengths.VA, lengths.VB, openings);
  const auto most = [&](double LayeredErrorAt::*part) {
    double largest = 0;
    for (const SupportedStretch& stretch : stretches) {
      const auto value = [&](double opening) {
        const double here = at(lengths, opening, stretch).*part;
        return std::isfinite(here) ? here : infinity;
      };
      largest = std::max(largest, value(top_over(stretch.openings, value)));
    }
    return largest;
  };
  const LayeredFigures figures{most(&LayeredErrorAt::in_plane), most(&LayeredErrorAt::rise)};
  return std::isfinite(figures.error_max) && std::isfinite(figures.rise_max) ? std::optional(figures)
                                                                             : std::nullopt;
}

}  // namespace kempe
