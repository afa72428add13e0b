// The figures of the load by the frames of synthesis/verification/frame.hpp and space_frame.hpp, opening by opening: independent paths to the
// closed forms.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "kinematics/assembly_mode.hpp"
#include "reports/audit/give_limit.hpp"
#include "reports/audit/record.hpp"
#include "reports/audit/slack.hpp"
#include "specs/hardware.hpp"
#include "synthesis/loads/gravity.hpp"
#include "synthesis/loads/mass.hpp"
#include "synthesis/solvers/golden_section.hpp"
#include "synthesis/verification/frame.hpp"
#include "synthesis/verification/space_frame.hpp"

namespace kempe {

Spec as_built(const StoredDesign& design) {
  Spec spec;
  spec.links.style = design.style;
  spec.links.hardware = design.hardware;
  spec.cutting = design.cutting.value_or(CuttingSpec{});
  spec.material = design.material;
  spec.load = design.load;
  spec.tolerance = design.tolerance;
  return spec;
}

namespace {

using namespace audit_slack;

constexpr char layered_key[] = "quality.load_error_layered_max_mm", rise_key[] = "quality.load_rise_max_mm",
               layered_stress_key[] = "quality.stress_layered_max_MPa",
               weight_key[] = "quality.weight_error_max_mm",
               layered_weight_key[] = "quality.weight_error_layered_max_mm",
               weight_rise_key[] = "quality.weight_rise_max_mm";

constexpr int openings_looked_at = 400;

/// Calls `look` with evenly spaced openings and both ends.
template <class Look>
void for_each_opening(const OpeningInterval& openings, int steps, const Look& look) {
  for (int i = 0; i <= steps; ++i) look(openings.lower + openings.width() * i / steps);
}

/// N for each mm^3 of the links, along the table.
double pull_along_table(const StoredDesign& design) {
  return gravity_along(design.load->tilt) * design.material->density * cubic_metres_per_mm3;
}

/// What the frames say over the openings.
struct PlaneResponse {
  FrameResponse by_newton;  ///< the largest of each, for one newton; of `least` the least
  /// By the load's force and the links' own weight along the table together, and the latter alone; the largest of each.
  double pin_force = 0, stress = 0, by_weight = 0;
};

/// `weighs`: with the links' own weight.
PlaneResponse response_over(const AuditTask& task, const OpeningInterval& openings, bool weighs) {
  const Spec spec = as_built(task.design);
  const double force = most_force_at_pen(*task.design.load), pull = pull_along_table(task.design);
  const double hole = widest_hole(spec.links.style, spec.links.hardware, spec.cutting);
  const bool straight = is_straight(task.linkage.shape());
  PlaneResponse all;
  FrameResponse& over = all.by_newton;
  over.least = HUGE_VAL;
  for_each_opening(openings, openings_looked_at, [&](double opening) {
    const Pose pose = task.linkage.pose_at(opening, 0);
    const JointRoles roles = roles_of(task.linkage.grounding());
    const FrameResponse here = frame_response(pose, roles, straight, spec.links.style, *spec.material, hole);
    FrameUnderWeight weight;
    if (weighs)
      weight = frame_under_weight(pose, roles, straight, spec.links.style, *spec.material, hole, pull);
    for (std::size_t i = 0; i < here.pins.size(); ++i) {
      all.pin_force = std::max(all.pin_force, force * here.pins[i] + weight.pins[i]);
      all.stress = std::max(all.stress, force * here.stresses[i] + weight.stresses[i]);
    }
    all.by_weight = std::max(all.by_weight, weight.most);
    over.worst = std::max(over.worst, here.worst);
    over.least = std::min(over.least, here.least);
    over.pin_force = std::max(over.pin_force, here.pin_force);
    over.hand_force = std::max(over.hand_force, here.hand_force);
    over.stress = std::max(over.stress, here.stress);
  });
  return all;
}

/// The most of a figure over the openings: sampled, and refined beside the best, since it may have kinks. NaN, which no figure agrees with, where
/// the frame says nothing.
template <class Figure>
double most_over(const OpeningInterval& openings, const std::vector<double>& sampled, const Figure& figure) {
  constexpr int steps = 20;
  if (!std::all_of(sampled.begin(), sampled.end(), [](double here) { return std::isfinite(here); }))
    return std::numeric_limits<double>::quiet_NaN();
  const auto best = std::max_element(sampled.begin(), sampled.end());
  const double spacing = openings.width() / static_cast<double>(sampled.size() - 1),
               at = openings.lower + spacing * static_cast<double>(best - sampled.begin());
  const double top = top_by_golden_section(figure, std::max(openings.lower, at - spacing),
                                           std::min(openings.upper, at + spacing), steps);
  return std::max(*best, figure(top));
}

/// The linkage with the links in their layers and pins that give way, under the load's force.
class LayeredLinkage {
 public:
  /// `weighs`: with the links' own weight along the table.
  LayeredLinkage(const AuditTask& task, bool weighs)
      : task_(task), weighs_(weighs), parts_(parts_of(task, weighs)),
        hole_(widest_hole(task.design.style, task.design.hardware, as_built(task.design).cutting)),
        has_stress_(task.design.quality.layered->stress_max.has_value() && hole_ < task.design.style.width) {}

  bool weighs() const { return weighs_; }
  bool has_stress() const {
    return has_stress_;
  }  ///< false: it is not asked for, or holes leave nothing of a link

  /// The figures at one opening.
  struct Figures {
    MostOfFrame most;
    MostByPull by_weight{};
    std::array<double, 4> stress{};  ///< of each link; without its weight all stands with the first
  };
  Figures at(double opening) const {
    const Load& load = *task_.design.load;
    const SpaceFrameResponse response =
        space_frame_response(task_.linkage.pose_at(opening, 0), roles_of(task_.linkage.grounding()), parts_);
    const FrameTable table{load.rests_at(Carrier::tracer), load.rests_at(Carrier::pen), response.weighed};
    const double force = most_force_at_pen(load);
    Figures here{.most = most_movement(response, table, force)};
    if (weighs_)
      here.by_weight = most_by_pull(response, table, task_.design.style,
                                    has_stress_ ? std::optional(hole_) : std::nullopt);
    for (const Link link : all_links)
      here.stress[static_cast<std::size_t>(link)] = stress(response, table, force, link);
    return here;
  }

 private:
  static SpaceFrameParts parts_of(const AuditTask& task, bool weighs) {
    const StoredDesign& design = task.design;
    const double down = standard_gravity * std::cos(design.load->tilt);
    return {.straight = is_straight(task.linkage.shape()),
            .style = design.style,
            .hardware = design.hardware,
            .layers = design.layers,
            .E = design.material->E,
            .G = design.material->shear_modulus(),
            .link_weight = down * design.material->density * cubic_metres_per_mm3,
            .tracer_weight = down * design.load->tracer_mass,
            .pen_weight = down * design.load->pen_mass,
            .link_pull = weighs ? pull_along_table(design) : 0};
  }

  double stress(const SpaceFrameResponse& response, const FrameTable& table, double force, Link link) const {
    if (!has_stress_ || (!weighs_ && link != Link::VA)) return 0;
    return most_stress(response, table, force, task_.design.style, hole_,
                       weighs_ ? std::optional(link) : std::nullopt);
  }

  const AuditTask& task_;
  bool weighs_;
  SpaceFrameParts parts_;
  double hole_;
  bool has_stress_;
};

/// The most of the layered linkage's figures over the openings.
class LayeredSamples {
 public:
  LayeredSamples(const LayeredLinkage& linkage, const OpeningInterval& openings)
      : linkage_(linkage), openings_(openings) {
    for_each_opening(openings, openings_looked_at,
                     [&](double opening) { samples_.push_back(linkage.at(opening)); });
  }

  /// Of `figure(figures at an opening)`.
  template <class Figure>
  double most(const Figure& figure) const {
    std::vector<double> sampled;
    sampled.reserve(samples_.size());
    for (const LayeredLinkage::Figures& here : samples_) sampled.push_back(figure(here));
    return most_over(openings_, sampled, [&](double opening) { return figure(linkage_.at(opening)); });
  }

  /// Of all links. Each link's most by force and weights and its most by the pull along the table add up to no less than both together.
  double most_stress() const {
    double most_of_all = 0;
    for (std::size_t link = 0; link < all_links.size(); ++link) {
      double of_link = most([link](const auto& here) { return here.stress[link]; });
      if (linkage_.weighs())
        of_link += most([link](const auto& here) { return here.by_weight.stress[link]; });
      if (!(of_link <= most_of_all)) most_of_all = of_link;  // NaN too
      if (!linkage_.weighs()) break;
    }
    return most_of_all;
  }

 private:
  const LayeredLinkage& linkage_;
  const OpeningInterval& openings_;
  std::vector<LayeredLinkage::Figures> samples_;
};

LayeredFigures layered_response_over(const AuditTask& task, const OpeningInterval& openings, bool weighs) {
  const LayeredLinkage linkage(task, weighs);
  const LayeredSamples samples(linkage, openings);
  LayeredFigures figures{samples.most([](const auto& here) { return here.most.give; }),
                         samples.most([](const auto& here) { return here.most.rise; }), HUGE_VAL};
  if (weighs) {
    figures.weight_error_max = samples.most([](const auto& here) { return here.by_weight.give; });
    figures.weight_rise_max = samples.most([](const auto& here) { return here.by_weight.rise; });
  }
  if (linkage.has_stress()) figures.stress_max = samples.most_stress();
  return figures;
}

void check_load_figures(const LoadFigures& stated, const Load& load, const PlaneResponse& all,
                        AuditRecord& record) {
  const FrameResponse& found = all.by_newton;
  const auto under = [&](double force, const char* key, double claimed, double per_newton, double scale) {
    record.figure(key, claimed, force * per_newton, share_of_load * force * scale);
  };
  const auto figure = [&](const char* key, double claimed, double per_newton, double scale) {
    under(most_force_at_pen(load), key, claimed, per_newton, scale);
  };
  figure("quality.load_error_max_mm", stated.error_max, found.worst, found.worst);
  figure("quality.load_error_min_mm", stated.error_min, found.least, found.worst);
  record.figure("quality.pin_force_max_N", stated.pin_force_max, all.pin_force,
                share_of_load * all.pin_force);
  under(load.pen_force, "quality.hand_force_max_N", stated.hand_force_max, found.hand_force,
        found.hand_force);
  if (std::isfinite(found.stress) || std::isfinite(stated.stress_max))
    record.figure("quality.stress_max_MPa", stated.stress_max, all.stress, share_of_load * all.stress);
  if (stated.weight_error_max)
    record.figure(weight_key, *stated.weight_error_max, all.by_weight, share_of_load * all.by_weight);
}

void check_layered_figures(const AuditTask& task, const LayeredFigures& stated, AuditRecord& record) {
  const LayeredFigures found = layered_response_over(task, *task.needed, stated.weight_error_max.has_value());
  const double give = found.error_max, rise = found.rise_max, stress = *found.stress_max;
  record.figure(layered_key, stated.error_max, give, share_of_load * give);
  record.figure(rise_key, stated.rise_max, rise, share_of_load * rise + share_of_rounding * give);
  record.figure(layered_stress_key, stated.stress_max, stress, share_of_load * stress);
  if (!stated.weight_error_max || !stated.weight_rise_max) return;
  record.figure(layered_weight_key, *stated.weight_error_max, *found.weight_error_max,
                share_of_load * *found.weight_error_max);
  record.figure(weight_rise_key, *stated.weight_rise_max, *found.weight_rise_max,
                share_of_load * *found.weight_rise_max + share_of_rounding * *found.weight_error_max);
}

void check_mass(const AuditTask& task, AuditRecord& record) {
  const auto& stated = task.design.quality.mass;
  if (!stated) return;
  if (!task.design.material) return record.not_checked("quality.mass_kg", "the file states no material");
  const double found = mass_of_links(task.linkage, as_built(task.design));
  record.figure("quality.mass_kg", *stated, found, share_of_rounding * found);
}

/// mm, what limits.load_error_in_all counts.
double give_in_all_of(const AuditTask& task, double links) {
  const bool weighs = gravity_along(task.design.load->tilt) > 0;
  const LayeredFigures found = layered_response_over(task, *task.needed, weighs);
  return std::max(links, found.error_max) + found.weight_error_max.value_or(0);
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
  const auto& layered = design.quality.layered;
  constexpr char in_all_key[] = "limits.load_error_in_all";
  const bool in_all = design.limits && design.limits->load_error_in_all;
  if (in_all && !limit.limit) record.not_checked(in_all_key, "the file has no limits.load_error_mm");
  if (limit.is_absent() && !layered) return;
  const char* why = !design.material || !design.load ? "the file states no load or no material"
                    : !task.needed                   ? "this assembly mode does not reach all of the region"
                                                     : nullptr;
  if (why != nullptr) {
    for (const char* key : {layered_key, rise_key, layered_stress_key})
      if (layered && (key != layered_stress_key || layered->stress_max)) record.not_checked(key, why);
    if (layered && layered->weight_error_max)
      for (const char* key : {layered_weight_key, weight_rise_key}) record.not_checked(key, why);
    if (design.quality.loads && design.quality.loads->weight_error_max) record.not_checked(weight_key, why);
    if (in_all && limit.limit) record.not_checked(in_all_key, why);
    return limit.cannot_tell(task, why, " under which it could be kept", record);
  }
  if (layered) check_layered_figures(task, *layered, record);
  if (limit.is_absent()) return;
  const bool weighs = design.quality.loads && design.quality.loads->weight_error_max;
  const PlaneResponse found = response_over(task, *task.needed, weighs);
  if (design.quality.loads) check_load_figures(*design.quality.loads, *design.load, found, record);
  const double links = most_force_at_pen(*design.load) * found.by_newton.worst;
  limit.check(task, in_all ? give_in_all_of(task, links) : links, record);
  if (in_all && limit.limit) record.checked(in_all_key);
}

}  // namespace kempe
