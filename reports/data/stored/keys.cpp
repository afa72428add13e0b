// The keys of design.json (docs/design-file.md).

#include "reports/data/stored/parts.hpp"
#include "reports/data/stored/values.hpp"

namespace kempe::stored {
namespace {

/// The keys that an object may have.
struct KnownKeys {
  std::string_view place;  ///< from the root, with dots; `[]`: each element of an array
  std::string_view keys;   ///< with a space between two
};

constexpr KnownKeys known_keys[] = {
    {"",
     "format title copy region mechanism quality workspace verification search limits tolerance obstacles "
     "why_not_fewer_layers tool pole links objective cutting bodies table material load"},
    {"copy", "scale rotation_deg wanted_scale wanted_rotation_deg ratio_error"},
    {"region", "type coordinates"},
    {"mechanism",
     "vertex pole tracer pen pole_position_mm shape assembly opening_deg lengths_mm orientation links "
     "link_width_mm pin_diameter_mm thickness_mm hardware"},
    {"mechanism.hardware", "default V A B C X Y"},
    {"mechanism.lengths_mm", "VA VB AC BC AX CX BY CY"},
    {"mechanism.orientation", "parallelogram plate_ACX plate_BCY"},
    {"mechanism.links[]", "name joints shape layer"},
    {"quality",
     "size_mm transmission_min_deg clearance_min_mm copy_error_worst_mm copy_error_rss_mm "
     "distortion_worst_mm footprint_mm2 lower_bound robust load_error_max_mm load_error_min_mm "
     "pin_force_max_N hand_force_max_N stress_max_MPa load_error_layered_max_mm load_rise_max_mm "
     "stress_layered_max_MPa weight_error_max_mm weight_error_layered_max_mm weight_rise_max_mm sag_max_mm "
     "mass_kg copy_error_at_corner_mm"},
    {"quality.robust", "holds clearance_min_mm clearance_loss_mm nominal_value"},
    {"workspace",
     "reachable_mm2 usable_mm2 collision_free_mm2 uncertain_mm2 region_covered why_not_covered "
     "largest_sheet sheets tightest_parts map_tolerance"},
    {"verification",
     "samples copy_error_max_mm loop_residual_max_mm scale rotation_deg flips certified failure "
     "driven_over"},
    {"search", "objective value solvers evaluations seed complete"},
    {"limits",
     "clearance_mm transmission_deg sheets_gap_mm copy_error_mm longest_strip_mm load_error_mm "
     "load_error_in_all sag_mm"},
    {"material", "name E_GPa density_kg_m3 strength_MPa G_GPa"},
    {"load", "pen_N rests pen_mass_kg tracer_mass_kg tilt_deg grip_mm friction"},
    {"tolerance", "length_mm play_mm robust"},
    {"obstacles[]", "name shape layers"},
    {"bodies[]", "name at turns_with shape circle_mm layers"},
    {"bodies[].circle_mm", "centre radius"},
    {"table", "type coordinates"},
    {"tool",
     "follower_radius_mm cutter_radius_mm exact_follower_radius_mm exact_cutter_radius_mm cut_outside_mm "
     "template_offset_mm"},
    {"pole", "at_mm within_mm"},
    {"links",
     "layers shortest_mm longest_mm wall_mm grid_mm stock_mm VA_mm VB_mm AC_mm BC_mm AX_mm CX_mm BY_mm "
     "CY_mm seat_mm sections_mm"},
    {"objective", "groundings"},
    {"cutting", "hole_fit_mm kerf_mm sheet_mm gap_mm process"},
};

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t end = 0; end != text.npos; text.remove_prefix(end == text.npos ? 0 : end + 1)) {
    end = text.find(' ');
    words.push_back(text.substr(0, end));
  }
  return words;
}

/// Calls `look` for every object at the place below `field`; not for what is absent or null.
template <class Look>
void for_each_at(const JsonField& field, std::string_view place, const Look& look) {
  if (place.empty()) return look(field);
  const std::size_t dot = place.find('.');
  const std::string_view rest = dot == place.npos ? "" : place.substr(dot + 1);
  std::string_view key = place.substr(0, dot);
  const bool each = key.ends_with("[]");
  if (each) key.remove_suffix(2);
  const auto member = field.find(key);
  if (!member) return;
  if (!each) return for_each_at(*member, rest, look);
  for (const JsonField& one : member->elements(0, many)) for_each_at(one, rest, look);
}

}  // namespace

void note_keys(const JsonField& root, StoredDesign& design) {
  design.tables = root.unknown_keys({});
  for (const auto& [place, keys] : known_keys)
    for_each_at(root, place, [&, known = words_of(keys)](const JsonField& field) {
      for (std::string& key : field.unknown_keys(known)) design.unknown_keys.push_back(std::move(key));
    });
}

}  // namespace kempe::stored
