// The figures of the load by the frame of synthesis/verification/frame.hpp, opening by opening: an independent path to the closed forms.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/assembly_mode.hpp"
#include "reports/audit/give_limit.hpp"
#include "reports/audit/record.hpp"
#include "reports/audit/slack.hpp"
#include "specs/hardware.hpp"
#include "synthesis/loads/mass.hpp"
#include "synthesis/verification/frame.hpp"

namespace kempe {
namespace {

using namespace audit_slack;

constexpr int openings_looked_at = 400;

/// What links weigh and give by, as the file states them.
Spec as_built(const StoredDesign& design) {
  Spec spec;
  spec.links.style = design.style;
  spec.links.hardware = design.hardware;
  spec.cutting = design.cutting.value_or(CuttingSpec{});
  spec.material = design.material;
  return spec;
}

/// The largest of each over the openings, for one newton; of `least` the least.
FrameResponse response_over(const AuditTask& task, const OpeningInterval& openings) {
  const Spec spec = as_built(task.design);
  const double hole = widest_hole(spec.links.style, spec.links.hardware, spec.cutting);
  const bool straight = is_straight(task.linkage.shape());
  FrameResponse over;
  over.least = HUGE_VAL;
  for (int i = 0; i <= openings_looked_at; ++i) {
    const double opening = openings.lower + openings.width() * i / openings_looked_at;
    const FrameResponse here =
        frame_response(task.linkage.pose_at(opening, 0), roles_of(task.linkage.grounding()), straight,
                       spec.links.style, *spec.material, hole);
    over.worst = std::max(over.worst, here.worst);
    over.least = std::min(over.least, here.least);
    over.pin_force = std::max(over.pin_force, here.pin_force);
    over.hand_force = std::max(over.hand_force, here.hand_force);
    over.stress = std::max(over.stress, here.stress);
  }
  return over;
}

void check_load_figures(const LoadFigures& stated, double force, const FrameResponse& found,
                        AuditRecord& record) {
  const auto figure = [&](const char* key, double claimed, double per_newton, double scale) {
    record.figure(key, claimed, force * per_newton, share_of_load * force * scale);
  };
  figure("quality.load_error_max_mm", stated.error_max, found.worst, found.worst);
  figure("quality.load_error_min_mm", stated.error_min, found.least, found.worst);
  figure("quality.pin_force_max_N", stated.pin_force_max, found.pin_force, found.pin_force);
  figure("quality.hand_force_max_N", stated.hand_force_max, found.hand_force, found.hand_force);
  if (std::isfinite(found.stress) || std::isfinite(stated.stress_max))
    figure("quality.stress_max_MPa", stated.stress_max, found.stress, found.stress);
}

void check_mass(const AuditTask& task, AuditRecord& record) {
  const auto& stated = task.design.quality.mass;
  if (!stated) return;
  if (!task.design.material) return record.not_checked("quality.mass_kg", "the file states no material");
  const double found = mass_of_links(task.linkage, as_built(task.design));
  record.figure("quality.mass_kg", *stated, found, share_of_rounding * found);
}

}  // namespace

void audit_loads(const AuditTask& task, AuditRecord& record) {
  check_mass(task, record);
  const StoredDesign& design = task.design;
  const GiveLimit limit{.figure = "quality.load_error_max_mm",
                        .is_stated = design.quality.loads.has_value(),
                        .key = "limits.load_error_mm",
                        .limit = design.limits ? design.limits->load_error : std::nullopt,
                        .words = "under the load the pen gives way by"};
  if (limit.is_absent()) return;
  const char* why = !design.material || !design.load ? "the file states no load or no material"
                    : !task.needed                   ? "this assembly mode does not reach all of the region"
                                                     : nullptr;
  if (why != nullptr) return limit.cannot_tell(task, why, " under which it could be kept", record);
  const FrameResponse found = response_over(task, *task.needed);
  if (design.quality.loads) check_load_figures(*design.quality.loads, design.load->pen_force, found, record);
  limit.check(task, design.load->pen_force * found.worst, record);
}

}  // namespace kempe
