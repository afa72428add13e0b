#include "workspace/grid_outline.hpp"

#include <algorithm>
#include <boost/sort/pdqsort/pdqsort.hpp>
#include <limits>
#include <numeric>
#include <tuple>

namespace kempe {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Sets that grow together.
class Components {
 public:
  explicit Components(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// One side of a cell on a grid line: from from() to `to` along it, the cell after the line (above it, or
/// right of it) or before.
struct Side {
  std::uint64_t order;  ///< by line, then by after(), then by place: lines and places have 31 bits
  std::uint32_t to, cell;

  Side(std::uint32_t line, std::uint32_t from, std::uint32_t end, std::uint32_t of_cell, bool after)
      : order((std::uint64_t{line} << 32) | (std::uint64_t{after} << 31) | from), to(end), cell(of_cell) {}
  std::uint32_t line() const { return static_cast<std::uint32_t>(order >> 32); }
  bool after() const { return (order >> 31) & 1; }
  std::uint32_t from() const { return static_cast<std::uint32_t>(order & (AngleGrid::turn - 1)); }
};

/// A side of the outline: from a grid point, `step` units along x or y, the set on the left.
struct Step {
  std::uint32_t x, y;  ///< start; x in [0, turn)
  std::int64_t step;
  bool across;         ///< along x
  std::uint32_t cell;  ///< the cell on its left
};

std::uint32_t wrapped(std::int64_t x) { return static_cast<std::uint32_t>(x & (AngleGrid::turn - 1)); }

/// The sides of all cells on lines of one direction, sorted by line and place.
std::vector<Side> sides_of(const std::vector<GridCell>& cells, bool across) {
  std::vector<Side> sides;
  sides.reserve(2 * cells.size());
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    const GridCell& cell = cells[i];
    if (across) {
      sides.emplace_back(cell.y, cell.x, cell.right(), i, true);
      sides.emplace_back(cell.top(), cell.x, cell.right(), i, false);
    } else {
      sides.emplace_back(cell.x, cell.y, cell.top(), i, true);
      sides.emplace_back(wrapped(cell.right()), cell.y, cell.top(), i, false);
    }
  }
  boost::sort::pdqsort_branchless(sides.begin(), sides.end(),
                                  [](const Side& a, const Side& b) { return a.order < b.order; });
  return sides;
}

/// What is left of the sides of one line after those with a cell on both sides have cancelled: calls
/// use(from, to, cell, after) in rising order, and meet(cell, cell) for cells that share a side.
template <class Use, class Meet>
void cancel(const Side* before, const Side* before_end, const Side* after, const Side* after_end, Use use,
            Meet meet) {
  std::uint32_t place = 0;
  while (before != before_end || after != after_end) {
    const std::uint32_t next_before = before != before_end ? before->from() : none;
    const std::uint32_t next_after = after != after_end ? after->from() : none;
    place = std::max(place, std::min(next_before, next_after));
    const bool on_before = next_before <= place, on_after = next_after <= place;
    std::uint32_t stop = none;
    if (before != before_end) stop = std::min(stop, on_before ? before->to : before->from());
    if (after != after_end) stop = std::min(stop, on_after ? after->to : after->from());
    if (on_before && on_after) meet(before->cell, after->cell);
    if (on_before != on_after) use(place, stop, on_after ? after->cell : before->cell, on_after);
    place = stop;
    if (before != before_end && before->to <= place) ++before;
    if (after != after_end && after->to <= place) ++after;
  }
}

/// Appends the outline's steps on lines of one direction.
void add_steps(std::vector<Step>& steps, const std::vector<GridCell>& cells, bool across,
               Components& components) {
  const std::vector<Side> sides = sides_of(cells, across);
  for (std::size_t begin = 0; begin < sides.size();) {
    const std::uint32_t line = sides[begin].line();
    std::size_t middle = begin;
    while (middle < sides.size() && sides[middle].line() == line && !sides[middle].after()) ++middle;
    std::size_t end = middle;
    while (end < sides.size() && sides[end].line() == line) ++end;
    std::uint32_t last_end = none;
    bool last_after = false;
    const auto use = [&](std::uint32_t from, std::uint32_t to, std::uint32_t cell, bool after) {
      const std::int64_t length = static_cast<std::int64_t>(to) - from;
      const bool goes_up = across == after;  // along its line, with the cell on the left
      if (from == last_end && after == last_after) {
        Step& last = steps.back();
        last.step += goes_up ? length : -length;
        if (!goes_up) (across ? last.x : last.y) = across ? wrapped(to) : to;
      } else {
        const std::uint32_t start = goes_up ? from : to;
        steps.push_back({across ? wrapped(start) : line, across ? line : start, goes_up ? length : -length,
                         across, cell});
      }
      last_end = to;
      last_after = after;
    };
    cancel(sides.data() + begin, sides.data() + middle, sides.data() + middle, sides.data() + end, use,
           [&](std::uint32_t a, std::uint32_t b) { components.unite(a, b); });
    begin = end;
  }
}

std::uint64_t key(std::uint32_t x, std::uint32_t y) { return (static_cast<std::uint64_t>(x) << 32) | y; }
std::uint64_t start_of(const Step& step) { return key(step.x, step.y); }
std::uint64_t end_of(const Step& step) {
  if (step.across) return key(wrapped(step.x + step.step), step.y);
  return key(step.x, static_cast<std::uint32_t>(step.y + step.step));
}

GridPoint direction_of(const Step& step) {
  const std::int64_t sign = step.step > 0 ? 1 : -1;
  return step.across ? GridPoint{sign, 0} : GridPoint{0, sign};
}

std::int64_t turn_between(const GridPoint& a, const GridPoint& b) { return a.x * b.y - a.y * b.x; }

/// The steps in the order in which they are walked.
class Chains {
 public:
  Chains(std::vector<Step> steps, Corners corners)
      : steps_(std::move(steps)), used_(steps_.size()), corners_(corners) {
    std::sort(steps_.begin(), steps_.end(), [](const Step& a, const Step& b) {
      return std::tuple(start_of(a), a.across, a.step) < std::tuple(start_of(b), b.across, b.step);
    });
  }
  const std::vector<Step>& steps() const { return steps_; }

  struct Next {
    std::size_t step;
    bool at_crossing;  ///< another chain passes the same point
  };
  /// The step that follows: at a crossing the left one keeps the corners apart, the right one joins them.
  Next after(const Step& step) const {
    const auto [first, count] = leaving(end_of(step));
    if (count < 2) return {first, false};
    const std::int64_t turn = turn_between(direction_of(step), direction_of(steps_[first]));
    const bool take_first = (turn > 0) == (corners_ == Corners::part);
    return {take_first ? first : first + 1, true};
  }
  /// The steps that leave a point: the first and how many.
  std::pair<std::size_t, std::size_t> leaving(std::uint64_t point) const {
    const auto first = std::lower_bound(steps_.begin(), steps_.end(), point,
                                        [](const Step& a, std::uint64_t b) { return start_of(a) < b; });
    auto last = first;
    while (last != steps_.end() && start_of(*last) == point) ++last;
    return {static_cast<std::size_t>(first - steps_.begin()), static_cast<std::size_t>(last - first)};
  }
  /// True the first time.
  bool take(std::size_t step) {
    if (used_[step]) return false;
    return used_[step] = true;
  }

 private:
  std::vector<Step> steps_;
  std::vector<bool> used_;
  Corners corners_;
};

/// Appends the corner between two steps; a crossing's is walked around by one unit.
void add_corner(std::vector<GridPoint>& corners, const GridPoint& at, const Step& in,
                const Chains::Next& next, const Step& out) {
  const GridPoint a = direction_of(in), b = direction_of(out);
  if (next.at_crossing) {
    corners.push_back({at.x - a.x, at.y - a.y});
    corners.push_back({at.x - a.x + b.x, at.y - a.y + b.y});
    corners.push_back({at.x + b.x, at.y + b.y});
  } else if (a.x != b.x || a.y != b.y) {
    corners.push_back(at);
  }
}

GridRing chain_from(std::size_t start, Chains& chains) {
  GridRing ring;
  GridPoint at{chains.steps()[start].x, chains.steps()[start].y};
  const std::int64_t first_x = at.x;
  for (std::size_t i = start; chains.take(i);) {
    const Step& step = chains.steps()[i];
    (step.across ? at.x : at.y) += step.step;
    const Chains::Next next = chains.after(step);
    add_corner(ring.corners, at, step, next, chains.steps()[next.step]);
    i = next.step;
  }
  ring.winding = static_cast<int>((at.x - first_x) / static_cast<std::int64_t>(AngleGrid::turn));
  if (ring.corners.empty()) ring.corners.push_back({first_x, at.y});  // a whole circle has no corner
  return ring;
}

/// Cells that meet at a corner only become one where corners join.
void unite_at_crossings(const Chains& chains, Components& components) {
  const auto& steps = chains.steps();
  for (std::size_t i = 0; i + 1 < steps.size(); ++i)
    if (start_of(steps[i]) == start_of(steps[i + 1])) components.unite(steps[i].cell, steps[i + 1].cell);
}

}  // namespace

GridOutline outline_of(const std::vector<GridCell>& cells, Corners corners) {
  Components components(cells.size());
  std::vector<Step> steps;
  add_steps(steps, cells, true, components);
  add_steps(steps, cells, false, components);
  Chains chains(std::move(steps), corners);
  if (corners == Corners::join) unite_at_crossings(chains, components);
  GridOutline outline;
  for (std::size_t i = 0; i < chains.steps().size(); ++i) {
    GridRing ring = chain_from(i, chains);
    if (ring.corners.size() == 1 && ring.winding == 0) continue;  // already walked
    ring.component = components.root(chains.steps()[i].cell);
    outline.rings.push_back(std::move(ring));
  }
  outline.component_of.resize(cells.size());
  for (std::uint32_t i = 0; i < cells.size(); ++i) outline.component_of[i] = components.root(i);
  return outline;
}

}  // namespace kempe
