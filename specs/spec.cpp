#include "specs/spec.hpp"

#include <algorithm>

#include "specs/hardware.hpp"

namespace kempe {
namespace {

/// Of the pin's diameter: what keeps two holes of a link apart where the spec does not say it.
constexpr double wall_per_pin = 0.1;

/// What the widest hole is wider than the thickest pin, mm: by a bearing or bush, or by the fit; a press fit's pin is as wide as
/// ever.
double widening(const Spec& spec) {
  const LinkStyle& style = spec.links.style;
  return std::max(0.0, widest_hole(style, spec.links.hardware, spec.cutting) - style.pin_diameter);
}

}  // namespace

Copy Copy::of(double scale, double rotation) { return {scale, rotation, copy_ratio(scale, rotation)}; }

Copy Copy::of(Complex k) { return {std::abs(k), std::arg(k), k}; }

Copy Copy::fitted(Complex k, const PairFit& fit) {
  Copy copy = of(k);
  copy.fit_ = fit;
  return copy;
}

std::string_view name(Objective objective) {
  switch (objective) {
    case Objective::size: return "size";
    case Objective::transmission: return "transmission";
    case Objective::copy_error: return "copy_error";
    case Objective::footprint: return "footprint";
    case Objective::load_error: return "load_error";
    case Objective::mass: return "mass";
  }
  return "";
}

std::optional<Objective> objective_named(std::string_view word) {
  for (const Objective one : {Objective::size, Objective::transmission, Objective::copy_error,
                              Objective::footprint, Objective::load_error, Objective::mass})
    if (name(one) == word) return one;
  return std::nullopt;
}

bool is_maximized(Objective objective) { return objective == Objective::transmission; }

std::string_view name(Process process) {
  switch (process) {
    case Process::laser: return "laser";
    case Process::mill: return "mill";
    case Process::print: return "print";
    case Process::drill: break;
  }
  return "drill";
}

double usual_fit(Process process) {
  switch (process) {
    case Process::laser: return 0.1;
    case Process::mill: return 0.05;
    case Process::print: return 0.3;
    case Process::drill: break;
  }
  return 0.1;
}

bool StockLengths::any() const {
  return grid.has_value() || !stock.empty() ||
         std::any_of(locked.begin(), locked.end(), [](const auto& length) { return length.has_value(); });
}

double least_wall(const Spec& spec) {
  return spec.links.wall.value_or(wall_per_pin * spec.links.style.pin_diameter);
}

double joint_width(const Spec& spec) { return spec.links.style.pin_diameter + widening(spec); }

double hole_distance(const Spec& spec) { return joint_width(spec) + least_wall(spec); }

double least_joint_distance(const Spec& spec) { return std::max(spec.links.shortest, hole_distance(spec)); }

double largest_joint_distance(const Spec& spec) {
  if (!spec.limits.longest_strip) return spec.links.longest;
  return std::min(spec.links.longest, *spec.limits.longest_strip - spec.links.style.width);
}

bool strip_is_shorter(const Spec& spec) { return largest_joint_distance(spec) < spec.links.longest; }

double pin_for_hole_distance(const Spec& spec, double distance) {
  const double pin_and_wall = distance - widening(spec);
  return spec.links.wall ? pin_and_wall - *spec.links.wall : pin_and_wall / (1 + wall_per_pin);
}

}  // namespace kempe
