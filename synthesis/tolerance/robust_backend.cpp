// Mean value theorem. theta: the eight lengths, the pins' displacements and the tracer's distance r from the pole; a cell
// is all instruments and a range of r, its centre the drawn instrument at the middle. Of two holes, in any unit direction n,
//   n . (b - a) >= its value at the centre - sum over lengths of t sup |n . d(b - a)| - sum over pins of
//                  radius sup |(n . d_x(b - a), n . d_y(b - a))| - half the range of r times sup |n . d_r(b - a)|
// with the suprema over the cell. Two convex pieces are apart by at least the smallest such value over the corners that
// span them; n points along their shortest connection at the centre. Seen from a link of the pair, what turns the whole
// linkage drops out: the gap does not depend on it.
//
// Cells of r are halved until the smallest bound is as good as the bound at a single distance.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <span>

#include "geometry/convex_distance.hpp"
#include "synthesis/tolerance/instrument_box.hpp"
#include "synthesis/tolerance/robust.hpp"
#include "workspace/contact/clearance.hpp"
#include "workspace/contact/contact_scene.hpp"
#include "workspace/contact/self_contact.hpp"

namespace kempe {
namespace {

constexpr std::size_t first_cells = 8, most_cells = 3000;
/// The bound is sharpened until it is within this share of the largest change of a source.
constexpr double sharp = 0.02;
constexpr double sharp_share = 1e-7;  ///< or this share of the distance, where tolerances are next to nothing
/// A cell narrower than this share of its distance is not halved.
constexpr double narrowest = 1e-9;

/// A convex piece of a part: the holes that span it.
struct HolePiece {
  std::array<Hole, 3> holes{};
  std::size_t count = 1;
};

Hole hole_of(Link link, Joint joint) {
  switch (link) {
    case Link::VA: return joint == Joint::V ? Hole::V_VA : Hole::A_VA;
    case Link::VB: return joint == Joint::V ? Hole::V_VB : Hole::B_VB;
    case Link::ACX: return joint == Joint::A ? Hole::A_ACX : joint == Joint::C ? Hole::C_ACX : Hole::X_ACX;
    case Link::BCY: break;
  }
  return joint == Joint::B ? Hole::B_BCY : joint == Joint::C ? Hole::C_BCY : Hole::Y_BCY;
}

/// The holes that a pin or post may sit in: a pin in one link's or the other's.
std::vector<Hole> seats_of(const Part& part, const CopyingLinkage& linkage) {
  if (part.kind == Part::Kind::pole_post) return {Hole::pole};
  if (part.kind == Part::Kind::tracer_post) return {Hole::tracer};
  switch (part.joint) {
    case Joint::V:
      if (part.kind != Part::Kind::pin) return {Hole::V_VA};
      if (pole_is_at_V(linkage.grounding())) return {Hole::V_VA, Hole::V_VB, Hole::pole};
      return {Hole::V_VA, Hole::V_VB};
    case Joint::A: return {Hole::A_VA, Hole::A_ACX};
    case Joint::B: return {Hole::B_VB, Hole::B_BCY};
    case Joint::C: return {Hole::C_ACX, Hole::C_BCY};
    case Joint::X: return {Hole::X_ACX};
    case Joint::Y: break;
  }
  return {Hole::Y_BCY};
}

std::vector<HolePiece> pieces_of(const Part& part, const CopyingLinkage& linkage, PlateStyle plate) {
  std::vector<HolePiece> pieces;
  if (part.kind != Part::Kind::link) {
    for (const Hole seat : seats_of(part, linkage)) pieces.push_back({{seat, seat, seat}, 1});
    return pieces;
  }
  for (const JointHull& hull : axis_of(part, linkage.shape(), plate)) {
    HolePiece piece;
    piece.count = static_cast<std::size_t>(hull.count);
    for (std::size_t i = 0; i < piece.count; ++i) piece.holes[i] = hole_of(part.link, hull.joints[i]);
    pieces.push_back(piece);
  }
  return pieces;
}

/// Two parts with their pieces, seen from the link of one of them.
struct PairOfParts {
  std::vector<HolePiece> first, second;
  std::size_t seen_from = 0;
  double half_widths = 0;
  std::string name;
};

std::vector<PairOfParts> pairs_of(const MapTask& task) {
  std::vector<PairOfParts> pairs;
  for (const ContactPair& pair : contact_pairs(task.linkage, task.layers)) {
    PairOfParts one{pieces_of(pair.first, task.linkage, task.style.plate),
                    pieces_of(pair.second, task.linkage, task.style.plate), 0,
                    half_width(pair.first, task.style) + half_width(pair.second, task.style), name(pair)};
    for (const Part* part : {&pair.second, &pair.first})
      if (part->kind == Part::Kind::link) one.seen_from = static_cast<std::size_t>(part->link);
    pairs.push_back(std::move(one));
  }
  return pairs;
}

Complex middle(const IntervalComplex& z) {
  return {0.5 * (z.re.inf() + z.re.sup()), 0.5 * (z.im.inf() + z.im.sup())};
}

/// From the first piece towards the second along their shortest connection; nothing if they overlap.
std::optional<Complex> direction_between(std::span<const Complex> first, std::span<const Complex> second) {
  const NearestRounding nearest;
  const NearestFeatures found = nearest_features(first, second);
  if (!(found.distance > 0)) return std::nullopt;
  const auto corners = found.corner_of_first ? first : second,
             others = found.corner_of_first ? second : first;
  Complex towards_corner = corners[found.corner] - others[found.from];
  if (found.is_edge) towards_corner = Complex(0, found.side) * (others[found.to] - others[found.from]);
  const double size = std::abs(towards_corner);
  if (!(size > 0)) return std::nullopt;
  return (found.corner_of_first ? -1.0 : 1.0) / size * towards_corner;
}

Interval along(Complex n, const IntervalComplex& z) {
  return Interval(n.real()) * z.re + Interval(n.imag()) * z.im;
}
/// Bounds of a value; infinite where a wide cell gave no number.
double at_least(const Interval& value) { return std::isnan(value.inf()) ? -infinity : value.inf(); }
double at_most(const Interval& value) { return std::isnan(value.sup()) ? infinity : value.sup(); }
double largest(const Interval& value) { return std::max(-at_least(value), at_most(value)); }

/// How far a place can be from that of the drawn instrument in direction n, the tracer's distance unchanged.
Interval shift_along(Complex n, const BoxPlace& place, const CopyTolerance& tolerance) {
  Interval sum(0);
  for (std::size_t i = 0; i < length_count; ++i)
    if (tolerance.length[i] > 0)
      sum += Interval(tolerance.length[i]) * Interval(largest(along(n, place.by[i])));
  for (std::size_t i = 0; i < pin_count; ++i) {
    if (!(tolerance.play[i] > 0)) continue;
    const std::size_t x = length_count + 2 * i;
    const Interval by_x(largest(along(n, place.by[x]))), by_y(largest(along(n, place.by[x + 1])));
    sum += Interval(0.5 * tolerance.play[i]) * CGAL::sqrt(CGAL::square(by_x) + CGAL::square(by_y));
  }
  return sum;
}

/// Distances of the tracer from the pole, mm, and the instrument's poses over them.
struct PoseCell {
  BoxPose every, drawn;
  double half;  ///< of the range of distances
};

/// A lower bound of the distance of two pieces over a cell; minus infinity where they overlap at its centre.
double piece_distance(const PairOfParts& pair, const HolePiece& first, const HolePiece& second,
                      const PoseCell& cell, const CopyTolerance& tolerance) {
  const BoxPlace &turn = cell.every.seen_from[pair.seen_from],
                 &drawn_turn = cell.drawn.seen_from[pair.seen_from];
  std::array<Complex, 3> a, b;
  for (std::size_t i = 0; i < first.count; ++i) a[i] = middle(cell.drawn[first.holes[i]].at * drawn_turn.at);
  for (std::size_t i = 0; i < second.count; ++i)
    b[i] = middle(cell.drawn[second.holes[i]].at * drawn_turn.at);
  const auto n = direction_between(std::span(a).first(first.count), std::span(b).first(second.count));
  if (!n) return -infinity;
  double least = infinity;
  for (std::size_t i = 0; i < first.count; ++i)
    for (std::size_t j = 0; j < second.count; ++j) {
      const Hole from = first.holes[i], to = second.holes[j];
      const IntervalComplex drawn = (cell.drawn[to].at - cell.drawn[from].at) * drawn_turn.at;
      const BoxPlace between = (cell.every[to] - cell.every[from]) * turn;
      const Interval bound = along(*n, drawn) - shift_along(*n, between, tolerance) -
                             Interval(cell.half) * Interval(largest(along(*n, between.by[distance_index])));
      least = std::min(least, at_least(bound));
    }
  const Interval size = length(exactly(*n));
  return at_least(Interval(least) / Interval(least < 0 ? size.inf() : size.sup()));
}

/// The smallest gap that a cell's instruments certainly keep.
struct CellGap {
  double gap = -infinity;
  std::size_t pair = 0;
};

CellGap smallest_gap(const std::vector<PairOfParts>& pairs, const PoseCell& cell,
                     const CopyTolerance& tolerance) {
  CellGap result{infinity, 0};
  for (std::size_t k = 0; k < pairs.size(); ++k)
    for (const HolePiece& first : pairs[k].first)
      for (const HolePiece& second : pairs[k].second) {
        const double apart = piece_distance(pairs[k], first, second, cell, tolerance);
        const double gap = (Interval(std::max(apart, 0.0)) - pairs[k].half_widths).inf();
        if (gap < result.gap) result = {gap, k};
      }
  return result;
}

/// A range of distances with what is known of it.
struct RadialCell {
  double from, to;
  CellGap bound;  ///< of all its distances; -infinity: not proven to close
  bool operator<(const RadialCell& other) const { return bound.gap > other.bound.gap; }
};

/// The linkage's own parts.
class OwnGaps {
 public:
  OwnGaps(const MapTask& task, const InstrumentBox& instruments)
      : instruments_(instruments), tolerance_(instruments.tolerance()), pairs_(pairs_of(task)) {
    for (const double one : tolerance_.length) most_ = std::max(most_, one);
    for (const double one : tolerance_.play) most_ = std::max(most_, one);
  }

  /// Over a range of distances.
  RobustCheck over(double from, double to) {
    RobustCheck check{.clearance = -infinity};
    const double sharpness = std::max(sharp * most_, sharp_share * to);
    for (std::size_t i = 0; i < first_cells; ++i)
      add(from + (to - from) * static_cast<double>(i) / first_cells,
          i + 1 == first_cells ? to : from + (to - from) * static_cast<double>(i + 1) / first_cells);
    for (std::size_t n = first_cells; n < most_cells; n += 2) {
      const RadialCell worst = cells_.top();
      if (impossible_ || (worst.bound.gap >= reached_ - sharpness && worst.bound.gap > -infinity)) break;
      if (!(worst.to - worst.from > narrowest * worst.to)) break;
      cells_.pop();
      const double middle = 0.5 * (worst.from + worst.to);
      add(worst.from, middle);
      add(middle, worst.to);
    }
    const RadialCell worst = cells_.top();
    check.closes = !impossible_ && worst.bound.gap > -infinity;
    check.at_distance = worst.to;
    if (!check.closes) return check;
    check.at_distance = 0.5 * (worst.from + worst.to);
    check.clearance = worst.bound.gap;
    check.sharpness = sharpness;
    check.parts = pairs_[worst.bound.pair].name;
    return check;
  }

 private:
  /// The bound over a range of distances; nothing where it is not proven that all close.
  std::optional<CellGap> bound(double from, double to, double middle) const {
    auto drawn = instruments_.drawn_pose(middle);
    auto every = drawn ? instruments_.pose(Interval(from, to)) : std::nullopt;
    if (!every) return std::nullopt;
    const double half = std::max((Interval(to) - middle).sup(), (Interval(middle) - from).sup());
    return smallest_gap(pairs_, {*std::move(every), *std::move(drawn), half}, tolerance_);
  }
  void add(double from, double to) {
    const double middle = std::clamp(0.5 * (from + to), from, to);
    const auto here = bound(middle, middle, middle);
    if (here) reached_ = std::min(reached_, here->gap);
    impossible_ = impossible_ || !here;
    cells_.push({from, to, impossible_ ? CellGap{} : bound(from, to, middle).value_or(CellGap{})});
  }

  const InstrumentBox& instruments_;
  const CopyTolerance& tolerance_;
  std::vector<PairOfParts> pairs_;
  std::priority_queue<RadialCell> cells_;
  double most_ = 0;
  double reached_ = infinity;  ///< the smallest bound of a single distance
  bool impossible_ = false;    ///< a single distance is not proven to close
};

constexpr std::size_t direction_count = 16;

/// Directions all around a half turn, and what the length of a vector may exceed its largest component along them by.
struct Directions {
  std::array<Complex, direction_count> each;
  double stretch;
  Directions() {
    for (std::size_t i = 0; i < direction_count; ++i)
      each[i] = std::polar(1.0, pi * static_cast<double>(i) / direction_count);
    stretch = (1 + 1e-12) / std::cos(0.5 * pi / direction_count);
  }
};

/// No corner of a piece is farther from its place than this, in any instrument of the cell.
double piece_shift(const HolePiece& piece, const BoxPose& every, const CopyTolerance& tolerance,
                   const Directions& directions) {
  double most = 0;
  for (std::size_t i = 0; i < piece.count; ++i)
    for (const Complex n : directions.each)
      most = std::max(most, at_most(shift_along(n, every[piece.holes[i]], tolerance)));
  return at_most(Interval(most) * directions.stretch);
}

double largest_shift(const std::vector<HolePiece>& pieces, const BoxPose& every,
                     const CopyTolerance& tolerance, const Directions& directions) {
  double most = 0;
  for (const HolePiece& piece : pieces)
    most = std::max(most, piece_shift(piece, every, tolerance, directions));
  return most;
}

/// The largest shift of some pieces over a range of distances: cells are halved where the largest is found.
double largest_shift_over(const std::vector<HolePiece>& pieces, const InstrumentBox& instruments, double from,
                          double to, const Directions& directions) {
  if (pieces.empty()) return 0;
  struct Cell {
    double shift, from, to;
    bool operator<(const Cell& other) const { return shift < other.shift; }
  };
  std::priority_queue<Cell> cells;
  double reached = 0;
  const auto shift = [&](const Interval& distances) {
    const auto every = instruments.pose(distances);
    return every ? largest_shift(pieces, *every, instruments.tolerance(), directions) : infinity;
  };
  const auto add = [&](double lower, double upper) {
    const double middle = std::clamp(0.5 * (lower + upper), lower, upper);
    reached = std::max(reached, shift(Interval(middle)));
    cells.push({shift(Interval(lower, upper)), lower, upper});
  };
  add(from, to);
  for (std::size_t n = 1; n < most_cells; n += 2) {
    const Cell worst = cells.top();
    if (worst.shift <= (1 + sharp) * reached || !(worst.to - worst.from > narrowest * worst.to)) break;
    cells.pop();
    const double middle = 0.5 * (worst.from + worst.to);
    add(worst.from, middle);
    add(middle, worst.to);
  }
  return cells.top().shift;
}

/// Pieces of the parts that may come nearer to an obstacle than `within`, mm.
std::vector<HolePiece> pieces_near_obstacles(const MapTask& task, double within) {
  const ContactScene scene(task, within);
  std::vector<Part> parts;
  for (const Encounter& one : scene.encounters.pairs)
    if (const Part& part = scene.pieces[one.piece].part;
        std::find(parts.begin(), parts.end(), part) == parts.end())
      parts.push_back(part);
  std::vector<HolePiece> pieces;
  for (const Part& part : parts)
    for (const HolePiece& piece : pieces_of(part, task.linkage, task.style.plate)) pieces.push_back(piece);
  return pieces;
}

/// Distances of the region from the pole, with room for their rounding.
DistanceRange distances_of(const MapTask& task) {
  const DistanceRange range = distance_range(task.region, task.linkage.pole());
  const Box box = bounding_box(task.region);
  const double size = std::max({box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff(),
                                task.linkage.pole().cwiseAbs().maxCoeff()});
  const double slack = 64 * std::numeric_limits<double>::epsilon() * size;
  return {std::max(0.0, range.nearest - slack), range.farthest + slack};
}

}  // namespace

std::string robust_fault(const RobustCheck& check, double clearance) {
  if (!check.closes)
    return "it is not proven that every instrument closes on the assembly mode that is drawn";
  return fmt::format("{} of some instruments may {}; {:.4g} mm are required", check.parts,
                     check.clearance > 0 ? fmt::format("come within {:.4g} mm", check.clearance) : "touch",
                     clearance);
}

RobustCheck check_robust(const MapTask& task, const CopyTolerance& tolerance) {
  const DistanceRange range = distances_of(task);
  if (!(range.nearest > 0)) return {.clearance = -infinity};
  const InstrumentBox instruments(task.linkage, tolerance);
  const Directions directions;
  RobustCheck check;
  {
    const OutwardRounding rounding;
    check = OwnGaps(task, instruments).over(range.nearest, range.farthest);
  }
  if (!check.closes || task.obstacles.empty()) return check;
  if (const auto post = tightest(gaps_at_pole(task)); post && post->gap < check.clearance) {
    check.clearance = post->gap;  // neither moves
    check.parts = post->post + " and " + post->obstacle;
    check.at_distance = 0;
  }
  const double own = check.clearance;
  const auto shift_of = [&](const std::vector<HolePiece>& pieces) {
    const OutwardRounding rounding;
    return largest_shift_over(pieces, instruments, range.nearest, range.farthest, directions);
  };
  const double farthest = shift_of(pieces_near_obstacles(task, infinity));
  check.obstacle_shift =
      farthest < infinity ? shift_of(pieces_near_obstacles(task, own + farthest)) : farthest;
  const ObstacleClearance obstacles = obstacle_clearance(task, own + check.obstacle_shift);
  const bool are_farther = obstacles.figure.certified && obstacles.figure.parts.empty();
  if (are_farther || obstacles.proven - check.obstacle_shift >= own) return check;
  check.clearance = obstacles.proven - check.obstacle_shift;
  check.parts = obstacles.figure.parts;
  check.at_distance = (obstacles.figure.at - task.linkage.pole()).norm();
  return check;
}

}  // namespace kempe
