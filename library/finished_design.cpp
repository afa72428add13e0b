// The class FinishedDesign of kempe/design.hpp.

#include <cmath>
#include <nlohmann/json.hpp>

#include "library/workings.hpp"
#include "reports/data/design_json.hpp"
#include "reports/data/error_budget_json.hpp"
#include "reports/data/feel_json.hpp"

namespace kempe {

FinishedDesign::FinishedDesign(std::shared_ptr<const Design> inside, std::string spec_text)
    : inside_(std::move(inside)), spec_text_(std::move(spec_text)), map_(inside_) {}

Copy FinishedDesign::copy() const {
  return inside_->wanted ? Copy::of(inside_->linkage.k()) : Copy::of(inside_->scale, inside_->rotation);
}

Grounding FinishedDesign::grounding() const { return inside_->linkage.grounding(); }
int FinishedDesign::assembly_mode() const { return inside_->linkage.assembly_mode().number; }
Point FinishedDesign::pole() const { return inside_->linkage.pole(); }
LinkLengths FinishedDesign::lengths() const { return inside_->linkage.lengths(); }
std::array<int, 4> FinishedDesign::layers() const { return inside_->layers.of; }
OpeningInterval FinishedDesign::opening() const { return inside_->opening; }

double FinishedDesign::size() const { return inside_->quality.size; }
double FinishedDesign::transmission_min() const { return inside_->quality.transmission_min; }
double FinishedDesign::footprint() const { return inside_->quality.footprint; }
std::optional<double> FinishedDesign::copy_error() const { return inside_->quality.copy_error_worst; }

std::optional<double> FinishedDesign::load_error() const {
  const auto& loads = inside_->quality.loads;
  return loads ? std::optional(loads->error_max) : std::nullopt;
}

std::optional<double> FinishedDesign::load_error_layered() const {
  const auto& layered = inside_->quality.layered;
  return layered ? std::optional(layered->error_max) : std::nullopt;
}

std::optional<double> FinishedDesign::load_rise() const {
  const auto& layered = inside_->quality.layered;
  return layered ? std::optional(layered->rise_max) : std::nullopt;
}

std::optional<double> FinishedDesign::weight_error() const {
  const auto& loads = inside_->quality.loads;
  return loads ? loads->weight_error_max : std::nullopt;
}

std::optional<double> FinishedDesign::weight_error_layered() const {
  const auto& layered = inside_->quality.layered;
  return layered ? layered->weight_error_max : std::nullopt;
}

std::optional<double> FinishedDesign::weight_rise() const {
  const auto& layered = inside_->quality.layered;
  return layered ? layered->weight_rise_max : std::nullopt;
}

std::optional<double> FinishedDesign::stress() const {
  const auto& loads = inside_->quality.loads;
  return loads ? std::optional(loads->stress_max) : std::nullopt;
}

std::optional<double> FinishedDesign::stress_layered() const {
  const auto& layered = inside_->quality.layered;
  return layered ? layered->stress_max : std::nullopt;
}

std::optional<double> FinishedDesign::sag() const { return inside_->quality.sag; }

std::optional<double> FinishedDesign::mass() const { return inside_->quality.mass; }
LinkSection FinishedDesign::section() const { return {inside_->style.width, inside_->style.thickness}; }

std::optional<double> FinishedDesign::robust_clearance() const {
  const auto& robust = inside_->quality.robust;
  return robust && std::isfinite(robust->clearance) ? std::optional(robust->clearance) : std::nullopt;
}

std::optional<double> FinishedDesign::clearance_min() const {
  const double gap = inside_->quality.clearance_min;
  return std::isfinite(gap) ? std::optional(gap) : std::nullopt;
}

Objective FinishedDesign::objective() const {
  return inside_->search ? inside_->search->objective : Objective::size;
}

std::optional<double> FinishedDesign::value() const {
  return inside_->search ? std::optional(inside_->search->value) : std::nullopt;
}

std::optional<double> FinishedDesign::proven_bound() const {
  const auto bound = inside_->quality.proven_bound;
  return bound && std::isfinite(*bound) ? bound : std::nullopt;
}

bool FinishedDesign::complete() const { return !inside_->search || inside_->search->complete; }

std::variant<Pose, Unreachable> FinishedDesign::pose_with_tracer_at(const Point& tracer) const {
  const auto pose = inside_->linkage.pose_with_tracer_at(tracer);
  if (!pose) return pose.error();
  return *pose;
}

std::string FinishedDesign::json() const { return design_json(*inside_); }

std::string FinishedDesign::error_budget_json() const {
  const auto budget = error_budget(*inside_);
  return budget ? error_budget_values(*budget).dump() : "";
}

std::string FinishedDesign::feel_json() const {
  const auto feel = feel_values(*inside_);
  return feel ? feel->dump() : "";
}

}  // namespace kempe
