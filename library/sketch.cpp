// The class Sketch of kempe/sketch.hpp.

#include "kempe/sketch.hpp"

#include <cmath>

#include "kinematics/deadline.hpp"
#include "library/workings.hpp"
#include "specs/spec_check.hpp"
#include "synthesis/search/search_faults.hpp"
#include "synthesis/search/sketch.hpp"

namespace kempe {
namespace {

FoundDesign found_design(const Design& design) {
  FoundDesign found{.linkage = design.linkage, .layers = design.layers};
  if (design.search) {
    found.goal = goal_of(design.search->objective);
    found.value = design.search->value;
  }
  found.opening = design.opening;
  found.attained.size = design.quality.size;
  found.attained.transmission = design.quality.transmission_min;
  found.attained.clearance = design.quality.clearance_min;
  found.proven_bound = design.quality.proven_bound;
  return found;
}

}  // namespace

Sketch::Sketch(const FinishedDesign& design)
    : inside_(std::make_shared<const SketchedDesign>(sketch_of(found_design(Workings::inside(design))))) {}

Sketch::operator bool() const { return inside_->design.has_value(); }
Grounding Sketch::grounding() const { return inside_->design->linkage.grounding(); }
int Sketch::assembly_mode() const { return inside_->design->linkage.assembly_mode().number; }
Point Sketch::pole() const { return inside_->design->linkage.pole(); }
LinkLengths Sketch::lengths() const { return inside_->design->linkage.lengths(); }
std::array<int, 4> Sketch::layers() const { return inside_->design->layers.of; }
OpeningInterval Sketch::opening() const { return inside_->design->opening; }
double Sketch::size() const { return inside_->design->linkage.size(); }
double Sketch::transmission_min() const { return inside_->design->attained.transmission; }
double Sketch::value() const { return inside_->design->value; }
bool Sketch::proven_none() const { return inside_->proven_none; }

std::optional<double> Sketch::proven_bound() const {
  const auto bound = inside_->bound;
  return bound && std::isfinite(*bound) ? bound : std::nullopt;
}

std::variant<Pose, Unreachable> Sketch::pose_with_tracer_at(const Point& tracer) const {
  const auto pose = inside_->design->linkage.pose_with_tracer_at(tracer);
  if (!pose) return pose.error();
  return *pose;
}

Sketch sketch(const Spec& spec, const Sketch& previous, const Options& options) {
  auto checked = check_spec(spec);
  if (checked)
    if (auto fault = search_fault(*checked)) checked = tl::unexpected(*std::move(fault));
  if (!checked) {
    SketchedDesign none{.last = previous.inside_->last, .count = previous.inside_->count};
    Sketch faulty(std::make_shared<const SketchedDesign>(std::move(none)));
    faulty.fault_ = checked.error();
    return faulty;
  }
  const Deadline deadline(options.time_limit.value_or(Deadline::unlimited));
  const StopFlag stop = deadline.flag(options.stop ? StopFlag(options.stop) : StopFlag());
  return Sketch(std::make_shared<const SketchedDesign>(sketched(*checked, *previous.inside_, {}, stop)));
}

}  // namespace kempe
