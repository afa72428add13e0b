#include "workspace/contact/subdivision.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "geometry/sector.hpp"
#include "geometry/segment_distance.hpp"
#include "geometry/slack.hpp"

namespace kempe {
namespace {

/// Cells across and upwards to begin with: narrow enough for the first-order bounds to mean something.
constexpr std::uint32_t roots_across = 16, roots_upwards = 2;

/// A side that moves the joints this many times as far as the other is cut whatever the tightest item says:
/// bounds of items that are not yet single edges shrink with the whole motion.
constexpr double most_uneven = 12;

/// Rows and columns that are remembered.
constexpr std::size_t rows_remembered = 64, columns_remembered = 256;

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

/// Edges that stray from their chord by at most this share of the motion are decided as one: a round obstacle has some thousand.
constexpr double most_stray = 0.125;

/// Bounds of the distance to a node's edges: those to its chord, more or less by what the edges stray from it.
GapBounds bounds_to_edges(const MovingHull& hull, const EdgeTree::Chord& chord, const GapQuestion& question) {
  const auto& [segment, stray] = chord;
  GapBounds bounds =
      bounds_to_edge(hull, segment, {question.upper_below - stray, question.lower_from + stray});
  bounds.lower = std::max(0.0, bounds.lower - stray);
  bounds.upper += stray;
  return bounds;
}

}  // namespace

/// What the items of a cell have told so far.
struct Subdivision::Decision {
  bool in_contact = false;
  Encounter between{};
  double least = std::numeric_limits<double>::infinity();  ///< of lower bounds less what is needed, mm
  std::size_t tightest = 0;                                ///< its item in the list
  double by_opening = 1, by_bearing = 1;                   ///< its motions
  const ContactItem* apart = nullptr;                      ///< an item already found apart
};

/// A piece over a cell, and an obstacle.
struct Subdivision::Meeting {
  Encounter between;
  MovingHull hull;
  const SceneObstacle& obstacle;
  double needed;         ///< mm, between axis and edge
  GapQuestion question;  ///< of a single edge: are they in contact, are they apart?
};

Subdivision::Subdivision(const ContactScene& scene, const Encounters& encounters, const EdgeTree& region,
                         const AngleGrid& grid, double clearance, SubdivisionMode mode)
    : scene_(scene), encounters_(encounters), region_(region), grid_(grid), clearance_(clearance),
      mode_(mode), rows_(rows_remembered), columns_(columns_remembered) {
  add_roots();
}

void Subdivision::add_roots() {
  std::vector<ContactItem> items;
  for (const Encounter& between : encounters_.pairs) items.push_back({0, between});
  const std::uint32_t region_root = 0;
  for (std::uint32_t j = 0; j < roots_upwards; ++j)
    for (std::uint32_t i = 0; i < roots_across; ++i) {
      constexpr std::uint32_t width = AngleGrid::turn / roots_across,
                              height = AngleGrid::rise / roots_upwards;
      OpenCell whole{};
      whole.side = region_.empty() ? RegionSide::outside : RegionSide::crossing;
      whole.count = static_cast<std::uint32_t>(items.size());
      whole.region_count = region_.empty() ? 0 : 1;
      classify({i * width, j * height, width, height}, whole, items.data(), &region_root, lists_);
    }
}

bool Subdivision::split(const std::function<bool(const OpenCell&)>& wanted) {
  Lists next = std::move(spare_);
  next.open.clear();
  next.items.clear();
  next.region_items.clear();
  open_area_ = 0;
  bool any = false;
  for (const OpenCell& open : lists_.open) {
    const auto [x, y, width, height] = open.cell;
    const ContactItem* items = lists_.items.data() + open.first;
    const std::uint32_t* region_items = lists_.region_items.data() + open.region_first;
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
    for (const GridCell& half : {one, other}) classify(half, open, items, region_items, next);
  }
  spare_ = std::exchange(lists_, std::move(next));
  return any;
}

FramedOpenings Subdivision::over_openings(double opening, double half_opening) const {
  FramedOpenings over;
  over[0] = scene_.motion.over_openings(opening, half_opening);
  for (const SceneFrame frame : encounters_.frames)
    if (frame != SceneFrame::table)
      over[static_cast<std::size_t>(frame)] = scene_.motion_in(frame).over_openings(opening, half_opening);
  return over;
}

FramedJoints Subdivision::joints_over(const FramedOpenings& over, Complex turn, double half_bearing) const {
  FramedJoints joints;
  joints[0] = LinkageMotion::turned(over[0], turn, half_bearing);
  for (const SceneFrame frame : encounters_.frames)
    if (frame != SceneFrame::table) {
      const auto i = static_cast<std::size_t>(frame);
      joints[i] = scene_.motion_in(frame).turned_in_frame(over[i], turn, half_bearing);
    }
  return joints;
}

const Subdivision::Row& Subdivision::row_of(const GridCell& cell) {
  const auto [x, y, width, height] = cell;
  // Rows of one height are y / height = 0, 1, ..: neighbours have places of their own.
  const int level = std::countr_zero(height);
  Row& row = rows_[((y >> level) + 29 * static_cast<std::size_t>(level)) % rows_remembered];
  if (row.y != y || row.height != height)
    row = {y, height, over_openings(grid_.opening(y + 0.5 * height), half_sides(grid_, cell).opening),
           grid_.area_per_bearing(y, height)};
  return row;
}

Complex Subdivision::turn_of(const GridCell& cell) {
  const double middle = cell.x + 0.5 * cell.width;
  const int level = std::countr_zero(cell.width);
  Column& column = columns_[((cell.x >> level) + 29 * static_cast<std::size_t>(level)) % columns_remembered];
  if (column.middle != middle) column = {middle, std::polar(1.0, AngleGrid::bearing(middle))};
  return column.turn;
}

void Subdivision::classify(const GridCell& cell, const OpenCell& parent, const ContactItem* items,
                           const std::uint32_t* region_items, Lists& next) {
  RegionSide side = parent.side;
  const std::size_t first = next.items.size(), region_first = next.region_items.size();
  const HalfSides half = half_sides(grid_, cell);
  const Row& row = row_of(cell);
  const double cell_area = row.area_per_bearing * AngleGrid::bearing(cell.width);
  const FramedJoints joints = joints_over(row.over, turn_of(cell), half.bearing);
  if (side == RegionSide::crossing) {
    const MovingJoint& tracer = joints[0][static_cast<std::size_t>(grid_.linkage().tracer_joint())];
    side = side_of(tracer, region_items, parent.region_count, next);
  }
  if (side == RegionSide::outside && mode_.region_only) return;
  Decision decision;
  decision.tightest = first;
  const bool tightest_only =
      parent.all_decided && decide_tightest(parent, items, joints, half, decision, next);
  if (!tightest_only) {
    const ContactItem* end = items + parent.count;
    for (const ContactItem* item = items; item != end;)
      if (decide_group(item, end, joints, half, decision, next)) break;
  }
  if (next.items.size() > first && !decision.in_contact) {
    const std::size_t kept = next.items.size() - first, region_kept = next.region_items.size() - region_first;
    next.open.push_back({cell, side,
                         should_split_opening(joints[0], half, decision.by_opening, decision.by_bearing),
                         static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(kept),
                         static_cast<std::uint32_t>(decision.tightest - first), !tightest_only,
                         static_cast<std::uint32_t>(region_first), static_cast<std::uint32_t>(region_kept)});
    open_area_ += cell_area;
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
    free_area_ += cell_area;
  }
}

Subdivision::Meeting Subdivision::meeting_of(const Encounter& between, const FramedJoints& joints,
                                             const HalfSides& half) const {
  const SceneObstacle& obstacle = scene_.obstacles[between.obstacle];
  const ScenePiece& piece = scene_.pieces[between.piece];
  const double needed = piece.half_width + obstacle.grown + clearance_;
  const double contact_below = mode_.contacts_stay_open ? 0 : needed - obstacle.slack;
  return {between,
          {joints[static_cast<std::size_t>(obstacle.frame)], piece.hull,
           ContactScene::sides_in(obstacle.frame, half)},
          obstacle,
          needed,
          {contact_below, needed + obstacle.slack}};
}

/// Decides the item that was tightest in the parent: true if that is enough, because it is in contact all over
/// the cell or leaves it open. Others that end in contact here are seen a cut later; what is gained is that
/// most cells along a boundary look at one item only.
bool Subdivision::decide_tightest(const OpenCell& parent, const ContactItem* items,
                                  const FramedJoints& joints, const HalfSides& half, Decision& decision,
                                  Lists& next) const {
  const ContactItem* tightest = items + parent.tightest;
  const std::size_t first = next.items.size(), before = first + parent.tightest;
  next.items.insert(next.items.end(), items, tightest);
  decide_node(tightest->node, meeting_of(tightest->between, joints, half), decision, next);
  if (decision.in_contact) return true;
  if (next.items.size() == before) {
    next.items.resize(first);
    decision.apart = tightest;
    return false;
  }
  next.items.insert(next.items.end(), tightest + 1, items + parent.count);
  return true;
}

/// Decides the items of one piece and obstacle and moves `item` past them, or stops at one that is in contact
/// all over the cell: true then.
bool Subdivision::decide_group(const ContactItem*& item, const ContactItem* end, const FramedJoints& joints,
                               const HalfSides& half, Decision& decision, Lists& next) const {
  const Encounter between = item->between;
  const Meeting meeting = meeting_of(between, joints, half);
  const std::size_t first = next.items.size();
  for (; item != end && item->between.piece == between.piece && item->between.obstacle == between.obstacle;
       ++item) {
    if (item != decision.apart) decide_node(item->node, meeting, decision, next);
    if (decision.in_contact) return true;
  }
  if (next.items.size() > first) return false;
  // No edge comes near, so the piece is inside or outside all over the cell; outside the box it cannot be
  // inside.
  const EdgeTree& edges = meeting.obstacle.edges;
  const Point& at = meeting.hull[0].at;
  if (distance(edges.node(0).box, {at, at}) > 0 || !edges.winds_around(at)) return false;
  // A distance is never below 0: where that is enough, contact tells nothing new.
  if (mode_.contacts_stay_open && meeting.needed <= 0) return false;
  if (mode_.contacts_stay_open) next.items.push_back({0, between});
  decision.in_contact = !mode_.contacts_stay_open;
  decision.between = between;
  return decision.in_contact;
}

void Subdivision::decide_node(std::uint32_t node, const Meeting& meeting, Decision& decision,
                              Lists& next) const {
  const auto& [between, hull, obstacle, needed, question] = meeting;
  const EdgeTree::Node& here = obstacle.edges.node(node);
  const EdgeTree::Chord& chord = obstacle.edges.chord(node);
  if (here.edges > 1) {
    if (distance_from_box(hull, here.box) - hull.reach() >= question.lower_from) return;
    if (chord.stray > most_stray * hull.reach() && diagonal(here.box) > hull.reach()) {
      decide_node(EdgeTree::left(node), meeting, decision, next);
      if (!decision.in_contact) decide_node(obstacle.edges.right(node), meeting, decision, next);
      return;
    }
  }
  const GapBounds bounds = bounds_to_edges(hull, chord, question);
  if (bounds.upper < question.upper_below) {
    decision.in_contact = true;
    decision.between = between;
    return;
  }
  if (bounds.lower >= question.lower_from) return;
  // Two links that meet at a joint are equally near to what is nearest to the joint: the first counts, whatever rounding says.
  if (bounds.lower - needed < decision.least - obstacle.slack) {
    decision.least = bounds.lower - needed;
    decision.tightest = next.items.size();
    decision.by_opening = bounds.by_opening;
    decision.by_bearing = bounds.by_bearing;
  }
  next.items.push_back({node, between});
}

RegionSide Subdivision::side_of(const MovingJoint& tracer, const std::uint32_t* items, std::size_t count,
                                Lists& next) const {
  const std::size_t first = next.region_items.size();
  const double reach = tracer.reach * (1 + slack::rounding);
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
  std::erase_if(lists_.open, [&](const OpenCell& open) { return !region_point_in(open); });
  open_area_ = 0;
  for (const OpenCell& open : lists_.open) open_area_ += grid_.area(open.cell);
}

std::optional<Point> Subdivision::region_point_in(const OpenCell& open) const {
  return region_point(open.cell, open.side, lists_.region_items.data() + open.region_first,
                      open.region_count);
}

}  // namespace kempe
