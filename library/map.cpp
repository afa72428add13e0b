// The class Map of kempe/map.hpp.

#include "kempe/map.hpp"

#include "synthesis/design/assemble.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

bool Map::covers_region() const { return inside_->map.coverage.covered; }
std::string Map::why_not_covered() const { return inside_->map.coverage.why_not; }

double Map::reachable_area() const { return area(inside_->map.reachable); }
double Map::usable_area() const { return area(inside_->map.usable); }
double Map::collision_free_area() const { return area(inside_->map.collision_free); }
double Map::uncertain_area() const { return area(inside_->map.uncertain); }

Region Map::reachable(double tolerance) const {
  return flattened(inside_->map.reachable, tolerance, Flatten::grows);
}

Region Map::collision_free(double tolerance) const {
  return flattened(inside_->map.collision_free, tolerance, Flatten::shrinks);
}

std::vector<Loss> Map::losses() const {
  std::vector<Loss> losses;
  for (const LostArea& lost : inside_->map.lost)
    losses.push_back({std::string(name(lost.cause)), lost.parts, area(lost.area)});
  return losses;
}

std::vector<SheetThatFits> Map::largest_sheets() const {
  std::vector<SheetThatFits> sheets;
  for (const FittingSheet& sheet : inside_->map.largest_sheets)
    sheets.push_back({sheet.name, sheet.width, sheet.height, sheet.centre, sheet.turn});
  return sheets;
}

OpeningInterval Map::certified_opening() const { return inside_->map.certified_opening; }

PointVerdict Map::at(const Point& tracer) const {
  const Verdict verdict = verdict_at(map_task(*inside_), tracer);
  return {verdict.free, verdict.uncertain, verdict.sentence};
}

bool Map::complete() const { return inside_->map.complete; }

}  // namespace kempe
