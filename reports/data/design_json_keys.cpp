#include "reports/data/design_json_keys.hpp"

namespace kempe {
namespace {
constexpr std::size_t most = 10'000'000;
}  // namespace

void note_keys(const JsonField& root, StoredDesign& design) {
  design.tables = root.unknown_keys({});
  const auto look = [&](const JsonField& field, std::initializer_list<std::string_view> known) {
    const auto keys = field.unknown_keys(known);
    design.unknown_keys.insert(design.unknown_keys.end(), keys.begin(), keys.end());
  };
  look(root, {"format",
              "title",
              "copy",
              "region",
              "mechanism",
              "quality",
              "workspace",
              "verification",
              "search",
              "limits",
              "tolerance",
              "obstacles",
              "why_not_fewer_layers",
              "tool",
              "pole",
              "links",
              "objective",
              "cutting",
              "bodies",
              "table",
              "material",
              "load"});
  const auto look_in = [&](std::string_view table, std::initializer_list<std::string_view> known) {
    if (const auto field = root.find(table)) look(*field, known);
  };
  look_in("copy", {"scale", "rotation_deg", "wanted_scale", "wanted_rotation_deg", "ratio_error"});
  look_in("region", {"type", "coordinates"});
  look_in("mechanism", {"vertex", "pole", "tracer", "pen", "pole_position_mm", "shape", "assembly",
                        "opening_deg", "lengths_mm", "orientation", "links", "link_width_mm",
                        "pin_diameter_mm", "thickness_mm", "hardware"});
  if (const auto hardware = root["mechanism"].find("hardware"); hardware && hardware->is_object())
    look(*hardware, {"default", "V", "A", "B", "C", "X", "Y"});
  look(root["mechanism"]["lengths_mm"], {"VA", "VB", "AC", "BC", "AX", "CX", "BY", "CY"});
  look(root["mechanism"]["orientation"], {"parallelogram", "plate_ACX", "plate_BCY"});
  for (const JsonField& link : root["mechanism"]["links"].elements(0, most))
    look(link, {"name", "joints", "shape", "layer"});
  look_in("quality", {"size_mm", "transmission_min_deg", "clearance_min_mm", "copy_error_worst_mm",
                      "copy_error_rss_mm", "distortion_worst_mm", "footprint_mm2", "lower_bound", "robust",
                      "load_error_max_mm", "load_error_min_mm", "pin_force_max_N", "hand_force_max_N",
                      "stress_max_MPa", "sag_max_mm", "mass_kg"});
  if (const auto robust = root["quality"].find("robust"))
    look(*robust, {"holds", "clearance_min_mm", "clearance_loss_mm", "nominal_value"});
  look_in("workspace",
          {"reachable_mm2", "usable_mm2", "collision_free_mm2", "uncertain_mm2", "region_covered",
           "why_not_covered", "largest_sheet", "sheets", "tightest_parts", "map_tolerance"});
  look_in("verification", {"samples", "copy_error_max_mm", "loop_residual_max_mm", "scale", "rotation_deg",
                           "flips", "certified", "failure", "driven_over"});
  look_in("search", {"objective", "value", "solvers", "evaluations", "seed", "complete"});
  look_in("limits", {"clearance_mm", "transmission_deg", "sheets_gap_mm", "copy_error_mm", "longest_strip_mm",
                     "load_error_mm", "sag_mm"});
  look_in("material", {"name", "E_GPa", "density_kg_m3", "strength_MPa", "G_GPa"});
  look_in("load", {"pen_N", "rests", "pen_mass_kg", "tracer_mass_kg", "tilt_deg", "grip_mm", "friction"});
  look_in("tolerance", {"length_mm", "play_mm", "robust"});
  if (const auto obstacles = root.find("obstacles"))
    for (const JsonField& one : obstacles->elements(0, most)) look(one, {"name", "shape", "layers"});
  if (const auto bodies = root.find("bodies"))
    for (const JsonField& one : bodies->elements(0, most)) {
      look(one, {"name", "at", "turns_with", "shape", "circle_mm", "layers"});
      if (const auto circle = one.find("circle_mm")) look(*circle, {"centre", "radius"});
    }
  look_in("table", {"type", "coordinates"});
  look_in("tool", {"follower_radius_mm", "cutter_radius_mm", "exact_follower_radius_mm",
                   "exact_cutter_radius_mm", "cut_outside_mm", "template_offset_mm"});
  look_in("pole", {"at_mm", "within_mm"});
  look_in("links", {"layers", "shortest_mm", "longest_mm", "wall_mm", "grid_mm", "stock_mm", "VA_mm", "VB_mm",
                    "AC_mm", "BC_mm", "AX_mm", "CX_mm", "BY_mm", "CY_mm", "seat_mm", "sections_mm"});
  look_in("objective", {"groundings"});
  look_in("cutting", {"hole_fit_mm", "kerf_mm", "sheet_mm", "gap_mm", "process"});
}

}  // namespace kempe
