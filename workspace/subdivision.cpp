#include "workspace/subdivision.hpp"

#include <algorithm>
#include <cmath>

#include "workspace/sector.hpp"
#include "workspace/segment_distance.hpp"

namespace kempe {
namespace {

/// Cells across and upwards to begin with: narrow enough for the first-order bounds to mean something.
constexpr std::uint32_t roots_across = 16, roots_upwards = 2;

/// A side that moves the joints this many times as far as the other is cut whatever the tightest item says:
/// bounds of items that are not yet single edges shrink with the whole motion.
constexpr double most_uneven = 12;

HalfSides half_sides(const AngleGrid& grid, const GridCell& cell) {
  return {0.5 * grid.openings().width() * cell.height / AngleGrid::rise,
          0.5 * AngleGrid::bearing(cell.width)};
}

Sector sector_of(const AngleGrid& grid, const GridCell& cell) {
  const double a = grid.radius(cell.y), b = grid.radius(cell.top());
  return {std::min(a, b), std::max(a, b), AngleGrid::bearing(cell.x), AngleGrid::bearing(cell.right())};
}

/// Whether the next cut should halve the opening rather than the bearing.
bool should_split_opening(const MovingJoints& joints, const HalfSides& half, double by_opening,
                          double by_bearing) {
  double opening_motion = 0, bearing_motion = 0;
  for (const MovingJoint& joint : joints) {
    opening_motion = std::max(opening_motion, joint.speed * half.opening);
    bearing_motion = std::max(bearing_motion, joint.far * half.bearing);
  }
  if (opening_motion > most_uneven * bearing_motion) return true;
  if (bearing_motion > most_uneven * opening_motion) return false;
  return by_opening > by_bearing;
}

double diagonal(const Box& box) { return (box.upper - box.lower).norm(); }

}  // namespace

/// What the items of a cell have told so far.
struct Subdivision::Decision {
  bool in_contact = false;
  Encounter between{};
  double tightest = std::numeric_limits<double>::infinity();  ///< of lower bound less what is needed
  double by_opening = 1, by_bearing = 1;                      ///< of the tightest item
};

Subdivision::Subdivision(const ContactScene& scene, const EdgeTree& region, const AngleGrid& grid,
                         double clearance, SubdivisionMode mode)
    : scene_(scene), region_(region), grid_(grid), clearance_(clearance), mode_(mode) {
  add_roots();
}

void Subdivision::add_roots() {
  std::vector<ContactItem> items;
  for (const Encounter& between : scene_.encounters) items.push_back({0, between});
  const std::uint32_t region_root = 0;
  Lists next;
  for (std::uint32_t j = 0; j < roots_upwards; ++j)
    for (std::uint32_t i = 0; i < roots_across; ++i) {
      constexpr std::uint32_t width = AngleGrid::turn / roots_across,
                              height = AngleGrid::rise / roots_upwards;
      const RegionSide side = region_.empty() ? RegionSide::outside : RegionSide::crossing;
      const GridCell cell{i * width, j * height, width, height};
      classify(cell, over_openings_of(cell), side, items.data(), items.size(), &region_root,
               region_.empty() ? 0 : 1, next);
    }
  open_ = std::move(next.open);
  items_ = std::move(next.items);
  region_items_ = std::move(next.region_items);
}

bool Subdivision::split(const std::function<bool(const OpenCell&)>& wanted) {
  Lists next;
  open_area_ = 0;
  bool any = false;
  for (const OpenCell& open : open_) {
    const auto [x, y, width, height] = open.cell;
    const ContactItem* items = items_.data() + open.first;
    const std::uint32_t* region_items = region_items_.data() + open.region_first;
    const bool narrow = width <= AngleGrid::smallest, low = height <= AngleGrid::smallest;
    if ((narrow && low) || !wanted(open)) {
      OpenCell& kept = next.open.emplace_back(open);
      kept.first = static_cast<std::uint32_t>(next.items.size());
      kept.region_first = static_cast<std::uint32_t>(next.region_items.size());
      open_area_ += grid_.area(kept.cell);
      next.items.insert(next.items.end(), items, items + open.count);
      next.region_items.insert(next.region_items.end(), region_items, region_items + open.region_count);
      continue;
    }
    any = true;
    const bool upwards = narrow || (open.split_opening && !low);
    const GridCell one = upwards ? GridCell{x, y, width, height / 2} : GridCell{x, y, width / 2, height};
    const GridCell other = upwards ? GridCell{x, y + height / 2, width, height / 2}
                                   : GridCell{x + width / 2, y, width / 2, height};
    const OpeningJoints over_one = over_openings_of(one);
    classify(one, over_one, open.side, items, open.count, region_items, open.region_count, next);
    classify(other, upwards ? over_openings_of(other) : over_one, open.side, items, open.count, region_items,
             open.region_count, next);
  }
  open_ = std::move(next.open);
  items_ = std::move(next.items);
  region_items_ = std::move(next.region_items);
  return any;
}

OpeningJoints Subdivision::over_openings_of(const GridCell& cell) const {
  return scene_.motion.over_openings(grid_.opening(cell.y + 0.5 * cell.height),
                                     half_sides(grid_, cell).opening);
}

void Subdivision::classify(const GridCell& cell, const OpeningJoints& over, RegionSide side,
                           const ContactItem* items, std::size_t count, const std::uint32_t* region_items,
                           std::size_t region_count, Lists& next) {
  const std::size_t first = next.items.size(), region_first = next.region_items.size();
  const HalfSides half = half_sides(grid_, cell);
  const MovingJoints joints =
      LinkageMotion::turned(over, AngleGrid::bearing(cell.x + 0.5 * cell.width), half.bearing);
  if (side == RegionSide::crossing) {
    const MovingJoint& tracer = joints[static_cast<std::size_t>(grid_.linkage().tracer_joint())];
    side = side_of(tracer, region_items, region_count, next);
  }
  if (side == RegionSide::outside && mode_.region_only) return;
  Decision decision;
  for (const ContactItem* item = items; item != items + count;)
    if (decide_group(item, items + count, joints, half, decision, next)) break;
  if (next.items.size() > first && !decision.in_contact) {
    const std::size_t kept = next.items.size() - first, region_kept = next.region_items.size() - region_first;
    next.open.push_back({cell, side,
                         should_split_opening(joints, half, decision.by_opening, decision.by_bearing),
                         static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(kept),
                         static_cast<std::uint32_t>(region_first), static_cast<std::uint32_t>(region_kept)});
    open_area_ += grid_.area(cell);
    return;
  }
  const auto meeting = region_point(cell, side, next.region_items.data() + region_first,
                                    next.region_items.size() - region_first);
  next.items.resize(first);
  next.region_items.resize(region_first);
  if (decision.in_contact) {
    contact_.push_back({cell, decision.between, meeting.has_value()});
    if (meeting && !region_in_contact_) region_in_contact_ = {contact_.back(), *meeting};
  } else {
    free_.push_back({cell, meeting.has_value()});
    free_area_ += grid_.area(cell);
  }
}

/// Decides the items of one piece and obstacle and moves `item` past them; true if they are in contact all
/// over the cell.
bool Subdivision::decide_group(const ContactItem*& item, const ContactItem* end, const MovingJoints& joints,
                               const HalfSides& half, Decision& decision, Lists& next) const {
  const Encounter between = item->between;
  const std::size_t first = next.items.size();
  for (; item != end && item->between.piece == between.piece && item->between.obstacle == between.obstacle;
       ++item)
    decide_node(item->node, between, joints, half, decision, next);
  if (decision.in_contact) return true;
  if (next.items.size() > first) return false;
  // No edge comes near, so the piece is inside or outside all over the cell; outside the box it cannot be
  // inside.
  const SceneObstacle& obstacle = scene_.obstacles[between.obstacle];
  const Point& at = joints[static_cast<std::size_t>(scene_.pieces[between.piece].hull.joints[0])].at;
  if (distance(obstacle.edges.node(0).box, {at, at}) > 0 || !obstacle.edges.winds_around(at)) return false;
  // A distance is never below 0: where that is enough, contact tells nothing new.
  if (mode_.contacts_stay_open && scene_.pieces[between.piece].half_width + clearance_ <= 0) return false;
  if (mode_.contacts_stay_open) next.items.push_back({0, between});
  decision.in_contact = !mode_.contacts_stay_open;
  decision.between = between;
  return decision.in_contact;
}

void Subdivision::decide_node(std::uint32_t node, const Encounter& between, const MovingJoints& joints,
                              const HalfSides& half, Decision& decision, Lists& next) const {
  const SceneObstacle& obstacle = scene_.obstacles[between.obstacle];
  const ScenePiece& piece = scene_.pieces[between.piece];
  const EdgeTree::Node& here = obstacle.edges.node(node);
  const double needed = piece.half_width + clearance_;
  if (here.edges > 1) {
    const double reach = reach_of(joints, piece.hull);
    if (distance_from_box(joints, piece.hull, here.box) - reach >= needed + obstacle.slack) return;
    if (diagonal(here.box) > reach) {
      decide_node(EdgeTree::left(node), between, joints, half, decision, next);
      if (!decision.in_contact)
        decide_node(obstacle.edges.right(node), between, joints, half, decision, next);
      return;
    }
  }
  // Of a node that is small against the motion one edge is as good as all to prove contact.
  const GapBounds bounds =
      bounds_to_edge(joints, piece.hull, obstacle.edges.edge(here.first_edge), half, needed - obstacle.slack);
  if (bounds.upper < needed - obstacle.slack && !mode_.contacts_stay_open) {
    decision.in_contact = true;
    decision.between = between;
    return;
  }
  if (here.edges == 1 && bounds.lower >= needed + obstacle.slack) return;
  next.items.push_back({node, between});
  if (bounds.lower - needed < decision.tightest) {
    decision.tightest = bounds.lower - needed;
    decision.by_opening = bounds.by_opening;
    decision.by_bearing = bounds.by_bearing;
  }
}

RegionSide Subdivision::side_of(const MovingJoint& tracer, const std::uint32_t* items, std::size_t count,
                                Lists& next) const {
  const std::size_t first = next.region_items.size();
  const double reach = tracer.reach * (1 + 1e-12);
  const Box around{tracer.at - Point::Constant(reach), tracer.at + Point::Constant(reach)};
  std::array<std::uint32_t, 40> stack;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t depth = 0;
    stack[depth++] = items[i];
    while (depth > 0) {
      const std::uint32_t index = stack[--depth];
      const EdgeTree::Node& node = region_.node(index);
      if (distance(node.box, around) > 0) continue;
      if (node.edges == 1) {
        const EdgeTree::Edge& edge = region_.edge(node.first_edge);
        if (squared_distance(tracer.at, edge.from, edge.to) <= reach * reach)
          next.region_items.push_back(index);
      } else if (diagonal(node.box) > reach) {
        stack[depth++] = region_.right(index);
        stack[depth++] = EdgeTree::left(index);
      } else {
        next.region_items.push_back(index);
      }
    }
  }
  if (next.region_items.size() > first) return RegionSide::crossing;
  return region_.winds_around(tracer.at) ? RegionSide::inside : RegionSide::outside;
}

std::optional<Point> Subdivision::region_point(const GridCell& cell, RegionSide side,
                                               const std::uint32_t* items, std::size_t count) const {
  if (side == RegionSide::outside) return std::nullopt;
  const Point middle = grid_.place(cell.x + 0.5 * cell.width, cell.y + 0.5 * cell.height);
  const Point& pole = grid_.linkage().pole();
  if (side == RegionSide::inside) return middle;
  const Sector sector = sector_of(grid_, cell);
  const Box box = box_around(sector);
  std::vector<std::uint32_t> stack(items, items + count);
  while (!stack.empty()) {
    const std::uint32_t index = stack.back();
    stack.pop_back();
    const EdgeTree::Node& node = region_.node(index);
    if (distance(node.box, box) > 0) continue;
    if (node.edges == 1) {
      if (const auto point = point_in(sector, region_.edge(node.first_edge))) return Point(pole + *point);
    } else {
      stack.push_back(region_.right(index));
      stack.push_back(EdgeTree::left(index));
    }
  }
  if (region_.winds_around(middle - pole)) return middle;
  return std::nullopt;
}

void Subdivision::look_at_region_only() {
  mode_.region_only = true;
  std::erase_if(open_, [&](const OpenCell& open) { return !region_point_in(open); });
  open_area_ = 0;
  for (const OpenCell& open : open_) open_area_ += grid_.area(open.cell);
}

std::optional<Point> Subdivision::region_point_in(const OpenCell& open) const {
  return region_point(open.cell, open.side, region_items_.data() + open.region_first, open.region_count);
}

}  // namespace kempe
