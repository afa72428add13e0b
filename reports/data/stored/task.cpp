#include <fmt/format.h>

#include "reports/data/stored/parts.hpp"
#include "reports/data/stored/values.hpp"
#include "specs/materials.hpp"
#include "specs/text/printable.hpp"

namespace kempe::stored {
namespace {

Limits limits(const JsonField& field) {
  Limits result;
  result.clearance = field["clearance_mm"].number(0, largest_coordinate);
  result.transmission = radians(field["transmission_deg"].number(0, 90));
  if (const auto gap = field.find("sheets_gap_mm")) result.copy_gap = gap->number();
  if (const auto error = field.find("copy_error_mm")) result.copy_error = error->number();
  if (const auto strip = field.find("longest_strip_mm")) result.longest_strip = length(*strip);
  if (const auto error = field.find("load_error_mm")) result.load_error = length(*error);
  if (const auto in_all = field.find("load_error_in_all")) result.load_error_in_all = in_all->boolean();
  if (const auto sag = field.find("sag_mm")) result.sag = length(*sag);
  return result;
}

Tolerance tolerance(const JsonField& field) {
  const auto robust = field.find("robust");
  return {.length = field["length_mm"].number(0, largest_coordinate),
          .play = field["play_mm"].number(0, largest_coordinate),
          .robust = robust && robust->boolean()};
}

/// Name and layers of an obstacle or a body.
template <typename Thing>
void read_name_and_layers(const JsonField& field, Thing& thing) {
  if (const auto name = field.find("name")) thing.name = printable(name->text());
  const auto layers = field["layers"].elements(2, 2);
  if (layers.size() != 2) return;
  thing.lowest_layer = static_cast<int>(layers[0].integer(1, 100));
  thing.highest_layer = static_cast<int>(layers[1].integer(thing.lowest_layer, 100));
}

Obstacle obstacle(const JsonField& field) {
  Obstacle result;
  result.shape = one_polygon(field["shape"]);
  read_name_and_layers(field, result);
  return result;
}

Body body(const JsonField& field) {
  Body result;
  result.at = one_of<Carrier>(field["at"], {{"tracer", Carrier::tracer}, {"pen", Carrier::pen}});
  if (const auto link = field.find("turns_with"))
    result.turns_with =
        one_of<Link>(*link, {{"VA", Link::VA}, {"VB", Link::VB}, {"ACX", Link::ACX}, {"BCY", Link::BCY}});
  if (const auto circle = field.find("circle_mm")) {
    const double radius = (*circle)["radius"].number(0, largest_coordinate);
    if (!(radius > 0)) (*circle)["radius"].refuse("a number > 0");
    result.shape = Disc{point((*circle)["centre"]), radius};
  } else {
    result.shape = one_polygon(field["shape"]);
  }
  read_name_and_layers(field, result);
  return result;
}

Material material(const JsonField& field) {
  Material result{.name = printable(field["name"].text()),
                  .E = MPa_per_GPa * field["E_GPa"].positive(),
                  .density = field["density_kg_m3"].positive(),
                  .strength = field["strength_MPa"].positive()};
  if (const auto shear = field.find("G_GPa")) result.G = MPa_per_GPa * shear->positive();
  return result;
}

Load load(const JsonField& field) {
  constexpr double largest_mass = 1e4;
  Load result{.pen_force = field["pen_N"].positive()};
  if (const auto mass = field.find("pen_mass_kg")) result.pen_mass = mass->number(0, largest_mass);
  if (const auto mass = field.find("tracer_mass_kg")) result.tracer_mass = mass->number(0, largest_mass);
  if (const auto tilt = field.find("tilt_deg")) result.tilt = radians(tilt->number(0, 90));
  if (const auto grip = field.find("grip_mm")) result.grip = grip->positive();
  if (const auto friction = field.find("friction")) result.friction = friction->number(0, 2);
  if (const auto rests = field.find("rests"))
    for (const JsonField& one : rests->elements(0, 2))
      result.rests.push_back(one_of<Carrier>(one, {{"tracer", Carrier::tracer}, {"pen", Carrier::pen}}));
  return result;
}

CuttingSpec cutting(const JsonField& field) {
  CuttingSpec result{.hole_fit = field["hole_fit_mm"].number(-1000, 1000),
                     .kerf = field["kerf_mm"].number(0, 1000)};
  if (const auto process = field.find("process"))
    result.process = one_of<Process>(*process, {{"laser", Process::laser},
                                                {"mill", Process::mill},
                                                {"print", Process::print},
                                                {"drill", Process::drill}});
  if (const auto sheet = field.find("sheet_mm")) result.stock_sheet = point(*sheet);
  result.gap = field["gap_mm"].number(0, largest_coordinate);
  return result;
}

std::string title(const JsonField& field) {
  std::string text = field.text();
  if (text.size() > most_title_bytes || printable(text) != text)
    field.refuse(fmt::format("one line of at most {} bytes, without control characters", most_title_bytes));
  return text;
}

PoleSpec pole(const JsonField& field) {
  PoleSpec result;
  if (const auto at = field.find("at_mm"))
    result.place = point(*at);
  else if (Region area = region(field["within_mm"]); !area.empty())
    result.place = std::move(area);
  else
    field["within_mm"].refuse("an area of at least one polygon");
  return result;
}

void read_links_limits(const JsonField& field, Allowed& allowed) {
  allowed.layers = static_cast<int>(field["layers"].integer(2, 100));
  allowed.shortest = length(field["shortest_mm"]);
  allowed.longest = length(field["longest_mm"]);
  allowed.wall = perhaps_length(field, "wall_mm");
  allowed.seat = perhaps_length(field, "seat_mm");
  allowed.stock_lengths.grid = perhaps_length(field, "grid_mm");
  if (const auto stock = field.find("stock_mm"))
    for (const JsonField& one : stock->elements(0, many)) allowed.stock_lengths.stock.push_back(length(one));
  for (std::size_t i = 0; i < LinkLengths::names.size(); ++i)
    allowed.stock_lengths.locked[i] = perhaps_length(field, std::string(LinkLengths::names[i]) + "_mm");
  if (const auto sections = field.find("sections_mm"))
    for (const JsonField& one : sections->elements(0, most_sections))
      if (const auto sides = one.elements(2, 2); sides.size() == 2)
        allowed.sections.push_back({length(sides[0]), length(sides[1])});
}

std::vector<Grounding> groundings(const JsonField& field) {
  std::vector<Grounding> result;
  for (const JsonField& one : field.elements(1, 3)) result.push_back(grounding(one));
  return result;
}

}  // namespace

void read_task(const JsonField& root, StoredDesign& design) {
  if (const auto field = root.find("title")) design.title = title(*field);
  if (const auto field = root.find("limits")) design.limits = limits(*field);
  if (const auto field = root.find("tolerance")) design.tolerance = tolerance(*field);
  if (const auto field = root.find("material")) design.material = material(*field);
  if (const auto field = root.find("load")) design.load = load(*field);
  if (const auto field = root.find("obstacles"))
    for (const JsonField& one : field->elements(0, many)) design.obstacles.push_back(obstacle(one));
  if (const auto field = root.find("bodies"))
    for (const JsonField& one : field->elements(0, many)) design.bodies.push_back(body(one));
  if (const auto field = root.find("table")) design.table = one_polygon(*field);
  if (const auto field = root.find("cutting")) design.cutting = cutting(*field);
}

void read_allowed(const JsonField& root, StoredDesign& design) {
  if (!root.find("pole") && !root.find("links") && !root.find("objective")) return;
  Allowed& allowed = design.allowed.emplace();
  allowed.pole = pole(root["pole"]);
  read_links_limits(root["links"], allowed);
  allowed.groundings = groundings(root["objective"]["groundings"]);
}

}  // namespace kempe::stored
