#include "reports/data/stored/values.hpp"

namespace kempe::stored {

double coordinate(const JsonField& field) { return field.number(-largest_coordinate, largest_coordinate); }

double length(const JsonField& field) {
  const double value = field.positive();
  if (value > largest_coordinate) field.refuse(fmt::format("a length up to {} mm", largest_coordinate));
  return value;
}

std::optional<double> perhaps_length(const JsonField& field, std::string_view key) {
  const auto one = field.find(key);
  return one ? std::optional(length(*one)) : std::nullopt;
}

Point point(const JsonField& field) {
  const auto both = field.elements(2, 2);
  return both.size() == 2 ? Point(coordinate(both[0]), coordinate(both[1])) : Point(Point::Zero());
}

namespace {

Ring ring(const JsonField& field) {
  Ring result;
  const std::size_t before = field.faults();
  for (const JsonField& place : field.elements(4, many)) {
    result.push_back(point(place));
    if (field.failed()) return {};
  }
  if (field.faults() != before) return {};
  if (result.front() != result.back())
    field.refuse("an open ring", "a ring whose last position repeats the first");
  result.pop_back();
  return result;
}

}  // namespace

Region region(const JsonField& field) {
  Region result;
  if (field["type"].text() != "MultiPolygon") field["type"].refuse("\"MultiPolygon\"");
  for (const JsonField& rings : field["coordinates"].elements(0, many)) {
    Polygon polygon;
    for (const JsonField& one : rings.elements(1, many)) {
      if (polygon.outer.empty())
        polygon.outer = ring(one);
      else
        polygon.holes.push_back(ring(one));
      if (field.failed()) return {};
    }
    result.polygons.push_back(std::move(polygon));
  }
  return result;
}

Polygon one_polygon(const JsonField& field) {
  const Region shape = region(field);
  if (shape.polygons.size() == 1) return shape.polygons.front();
  field.refuse("one polygon");
  return {};
}

Joint joint(const JsonField& field) {
  std::vector<std::pair<std::string, Joint>> choices;
  for (const Joint one : all_joints) choices.emplace_back(std::string(1, letter(one)), one);
  return one_of(field, choices);
}

Grounding grounding(const JsonField& field) {
  std::vector<std::pair<std::string, Grounding>> choices;
  for (const Grounding each : all_groundings) choices.emplace_back(name(each), each);
  return one_of(field, choices);
}

}  // namespace kempe::stored
