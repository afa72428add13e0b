#include <cmath>

#include "reports/data/stored/parts.hpp"
#include "reports/data/stored/values.hpp"
#include "specs/text/printable.hpp"

namespace kempe::stored {
namespace {

constexpr std::size_t most_solvers = 100, longest_solver_name = 200;

/// An error, an area or a force, which is never below 0.
double amount(const JsonField& field) { return field.number(0, 1e300); }
std::optional<double> amount_or_null(const JsonField& field) {
  return field.number_or_null() ? std::optional(amount(field)) : std::nullopt;
}

Robustness robustness(const JsonField& field) {
  return {.holds = field["holds"].boolean(),
          .clearance = field["clearance_min_mm"].number_or_null().value_or(-HUGE_VAL),
          .clearance_loss = amount_or_null(field["clearance_loss_mm"]).value_or(HUGE_VAL),
          .nominal_value = field["nominal_value"].number_or_null()};
}

/// All of them or none.
std::optional<LoadFigures> load_figures(const JsonField& field) {
  if (!field.find("load_error_max_mm")) return std::nullopt;
  LoadFigures figures{.error_max = amount(field["load_error_max_mm"]),
                      .error_min = amount(field["load_error_min_mm"]),
                      .pin_force_max = amount_or_null(field["pin_force_max_N"]).value_or(HUGE_VAL),
                      .hand_force_max = amount(field["hand_force_max_N"]),
                      .stress_max = amount_or_null(field["stress_max_MPa"]).value_or(HUGE_VAL)};
  if (const auto weight = field.find("weight_error_max_mm")) figures.weight_error_max = amount(*weight);
  return figures;
}

/// Error and rise or none; with them the stress, or not, and error and rise by the links' own weight, or neither.
std::optional<LayeredFigures> layered_figures(const JsonField& field) {
  constexpr std::string_view error = "load_error_layered_max_mm", rise = "load_rise_max_mm",
                             stress = "stress_layered_max_MPa", weight = "weight_error_layered_max_mm",
                             weight_rise = "weight_rise_max_mm";
  const bool has_weight = field.find(weight) || field.find(weight_rise);
  if (!field.find(error) && !field.find(rise) && !field.find(stress) && !has_weight) return std::nullopt;
  LayeredFigures figures{.error_max = amount(field[error]), .rise_max = amount(field[rise])};
  if (const auto one = field.find(stress)) figures.stress_max = amount(*one);
  if (has_weight) {
    figures.weight_error_max = amount(field[weight]);
    figures.weight_rise_max = amount(field[weight_rise]);
  }
  return figures;
}

Quality quality(const JsonField& field) {
  Quality result;
  result.size = amount(field["size_mm"]);
  result.transmission_min = radians(field["transmission_min_deg"].number(0, 90));
  result.clearance_min = field["clearance_min_mm"].number_or_null().value_or(HUGE_VAL);
  result.copy_error_worst = amount_or_null(field["copy_error_worst_mm"]);
  result.copy_error_rss = amount_or_null(field["copy_error_rss_mm"]);
  result.distortion_worst = amount_or_null(field["distortion_worst_mm"]);
  result.footprint = amount_or_null(field["footprint_mm2"]).value_or(0);
  result.proven_bound = field["lower_bound"].number_or_null();
  if (const auto corner = field.find("copy_error_at_corner_mm"))
    result.copy_error_at_corner = amount_or_null(*corner);
  result.loads = load_figures(field);
  result.layered = layered_figures(field);
  if (const auto sag = field.find("sag_max_mm")) result.sag = amount(*sag);
  if (const auto mass = field.find("mass_kg")) result.mass = amount(*mass);
  if (const auto one = field.find("robust")) result.robust = robustness(*one);
  return result;
}

Verification verification(const JsonField& field) {
  constexpr std::int64_t most = 1'000'000'000;
  Verification result;
  result.samples = static_cast<std::size_t>(field["samples"].integer(0, most));
  result.copy_error_max = amount_or_null(field["copy_error_max_mm"]).value_or(HUGE_VAL);
  result.loop_residual_max = amount_or_null(field["loop_residual_max_mm"]).value_or(HUGE_VAL);
  result.scale = field["scale"].number();
  result.rotation = radians(field["rotation_deg"].number(-360, 360));
  result.flips = static_cast<int>(field["flips"].integer(0, most));
  result.holds = field["certified"].boolean();
  if (const auto over = field.find("driven_over")) result.over_workspace = over->text() == "workspace";
  if (const auto failure = field.find("failure")) result.failure = failure->text();
  return result;
}

FittingSheet sheet(const JsonField& field) {
  return {.name = field["name"].text(),
          .width = length(field["width_mm"]),
          .height = length(field["height_mm"]),
          .centre = point(field["centre_mm"]),
          .turn = radians(field["turn_deg"].number(-360, 360))};
}

StoredMap stored_map(const JsonField& field) {
  const auto area = [&](std::string_view key) {
    const auto one = field.find(key);
    return one ? std::optional(amount(*one)) : std::nullopt;
  };
  StoredMap result{.reachable = area("reachable_mm2"),
                   .usable = area("usable_mm2"),
                   .collision_free = area("collision_free_mm2"),
                   .uncertain = area("uncertain_mm2"),
                   .map_tolerance = {},
                   .sheets = {}};
  if (const auto tolerance = field.find("map_tolerance")) result.map_tolerance = tolerance->number(1e-5, 0.5);
  if (const auto sheets = field.find("sheets"))
    for (const JsonField& one : sheets->elements(0, 100)) result.sheets.push_back(sheet(one));
  if (const auto largest = field.find("largest_sheet"); largest && largest->find("width_mm"))
    result.sheets.push_back(sheet(*largest));
  return result;
}

ToolAdvice tool(const JsonField& field) {
  return {.follower_radius = field["follower_radius_mm"].number_or_null(),
          .cutter_radius = field["cutter_radius_mm"].number_or_null(),
          .exact_follower_radius = field["exact_follower_radius_mm"].number_or_null(),
          .exact_cutter_radius = field["exact_cutter_radius_mm"].number_or_null(),
          .cut_outside = field["cut_outside_mm"].number_or_null(),
          .template_offset = field["template_offset_mm"].number_or_null()};
}

void read_run(const JsonField& field, StoredDesign& design) {
  if (const auto objective = field.find("objective")) {
    std::vector<std::pair<std::string, Objective>> choices;
    for (const Objective one : {Objective::size, Objective::transmission, Objective::copy_error,
                                Objective::footprint, Objective::load_error, Objective::mass})
      choices.emplace_back(name(one), one);
    design.objective = one_of(*objective, choices);
  }
  if (const auto value = field.find("value")) design.value = value->number();
  StoredSearch& search = design.search;
  if (const auto solvers = field.find("solvers"))
    for (const JsonField& solver : solvers->elements(0, most_solvers))
      search.solvers.push_back(printable(solver.text(), longest_solver_name));
  if (const auto evaluations = field.find("evaluations")) search.evaluations = evaluations->natural();
  if (const auto seed = field.find("seed")) search.seed = seed->natural();
  if (const auto complete = field.find("complete")) search.complete = complete->boolean();
}

}  // namespace

void read_claims(const JsonField& root, StoredDesign& design) {
  design.quality = quality(root["quality"]);
  design.footprint = amount_or_null(root["quality"]["footprint_mm2"]);
  design.region_covered = root["workspace"]["region_covered"].boolean();
  design.map = stored_map(root["workspace"]);
  design.verification = verification(root["verification"]);
}

void read_search(const JsonField& root, StoredDesign& design) {
  if (const auto field = root.find("tool")) design.tool = tool(*field);
  if (const auto field = root.find("search")) read_run(*field, design);
}

}  // namespace kempe::stored
