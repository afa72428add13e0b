#include "geometry/regions/ring_sweep.hpp"

#include <algorithm>
#include <cstdint>
#include <set>

#include "geometry/orientation.hpp"

namespace kempe {
namespace {

/// Corners and edges of all rings numbered through; edge i leaves corner i.
using Index = std::uint32_t;

struct FlatRings {
  explicit FlatRings(const std::vector<Ring>& rings) {
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const Index first = static_cast<Index>(corner.size());
      const Index count = static_cast<Index>(rings[r].size());
      for (Index i = 0; i < count; ++i) {
        corner.push_back(rings[r][i]);
        next.push_back(first + (i + 1) % count);
        previous.push_back(first + (i + count - 1) % count);
        ring.push_back(static_cast<Index>(r));
      }
      first_of_ring.push_back(first);
    }
  }

  RingEdge edge(Index flat) const { return {ring[flat], flat - first_of_ring[ring[flat]]}; }
  const Point& from(Index flat) const { return corner[flat]; }
  const Point& to(Index flat) const { return corner[next[flat]]; }
  bool runs_right(Index flat) const { return sweeps_before(from(flat), to(flat)); }
  const Point& left_end(Index flat) const { return runs_right(flat) ? from(flat) : to(flat); }
  const Point& right_end(Index flat) const { return runs_right(flat) ? to(flat) : from(flat); }

  /// Two edges that may not have a point in common beyond a corner that joins them.
  bool in_contact(Index a, Index b) const {
    if (next[a] != b && next[b] != a) return segments_meet(from(a), to(a), from(b), to(b));
    if (next[b] == a) std::swap(a, b);
    // Neighbours: a ends where b begins. They meet elsewhere only if b runs back along a.
    return orientation(from(a), to(a), to(b)) == 0 && (from(a) - to(a)).dot(to(b) - from(b)) > 0;
  }

  std::vector<Point> corner;
  std::vector<Index> next, previous, ring, first_of_ring;
};

/// Below-to-above order of two edges that the sweep line cuts and that do not meet.
struct Below {
  const FlatRings* rings;
  bool operator()(Index a, Index b) const {
    if (a == b) return false;
    const Point& a_left = rings->left_end(a);
    const Point& b_left = rings->left_end(b);
    if (a_left == b_left) return orientation(a_left, rings->right_end(a), rings->right_end(b)) > 0;
    if (sweeps_before(a_left, b_left)) return orientation(a_left, rings->right_end(a), b_left) > 0;
    return orientation(b_left, rings->right_end(b), a_left) < 0;
  }
};

class Sweep {
 public:
  explicit Sweep(const std::vector<Ring>& rings)
      : rings_(rings), status_(Below{&rings_}), place_(rings_.corner.size(), status_.end()) {
    nesting_.counter_clockwise.resize(rings.size());
    nesting_.parent.resize(rings.size());
    seen_.resize(rings.size(), false);
  }

  tl::expected<RingNesting, RingContact> run() {
    const std::vector<Index> order = corners_in_order();
    for (std::size_t i = 0; i < order.size() && !contact_; ++i) {
      if (i > 0 && rings_.corner[order[i - 1]] == rings_.corner[order[i]]) {
        report(order[i - 1], order[i]);
      } else {
        visit(order[i]);
      }
    }
    if (contact_) return tl::unexpected(*contact_);
    return std::move(nesting_);
  }

 private:
  using Status = std::set<Index, Below>;

  std::vector<Index> corners_in_order() const {
    std::vector<Index> order(rings_.corner.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
    std::sort(order.begin(), order.end(), [this](Index a, Index b) {
      const Point& at = rings_.corner[a];
      const Point& bt = rings_.corner[b];
      return sweeps_before(at, bt) || (at == bt && a < b);
    });
    return order;
  }

  void visit(Index corner) {
    const Index incoming = rings_.previous[corner], outgoing = corner;
    const bool incoming_lies_right = !rings_.runs_right(incoming);
    const bool outgoing_lies_right = rings_.runs_right(outgoing);
    if (incoming_lies_right && outgoing_lies_right) {
      begin(incoming, outgoing);
    } else if (!incoming_lies_right && !outgoing_lies_right) {
      end(incoming, outgoing);
    } else if (outgoing_lies_right) {
      pass(incoming, outgoing);
    } else {
      pass(outgoing, incoming);
    }
  }

  /// Both edges of a corner begin here.
  void begin(Index incoming, Index outgoing) {
    if (rings_.in_contact(incoming, outgoing)) return report(incoming, outgoing);
    const Point& corner = rings_.corner[outgoing];
    const bool outgoing_above = orientation(corner, rings_.from(incoming), rings_.to(outgoing)) > 0;
    const Index lower = outgoing_above ? incoming : outgoing;
    const Index upper = outgoing_above ? outgoing : incoming;
    const auto above = status_.upper_bound(lower);
    const bool has_below = above != status_.begin();
    const Index below = has_below ? *std::prev(above) : lower;
    if (above != status_.end() && (meets(*above, upper) || meets(*above, lower))) return;
    if (has_below && (meets(below, lower) || meets(below, upper))) return;
    note_nesting(outgoing, outgoing_above, has_below ? std::optional(below) : std::nullopt);
    place_[upper] = status_.insert(above, upper);
    place_[lower] = status_.insert(place_[upper], lower);
  }

  /// One edge of a corner ends here, the other takes its place.
  void pass(Index ending, Index beginning) {
    if (rings_.in_contact(ending, beginning)) return report(ending, beginning);
    const auto above = status_.erase(place_[ending]);
    if (above != status_.end() && meets(*above, beginning)) return;
    if (above != status_.begin() && meets(*std::prev(above), beginning)) return;
    place_[beginning] = status_.insert(above, beginning);
  }

  /// Both edges of a corner end here.
  void end(Index incoming, Index outgoing) {
    if (rings_.in_contact(incoming, outgoing)) return report(incoming, outgoing);
    status_.erase(place_[incoming]);
    const auto above = status_.erase(place_[outgoing]);
    if (above != status_.end() && above != status_.begin()) meets(*std::prev(above), *above);
  }

  /// At the leftmost corner of a ring: how it turns there is how it runs; the edge below tells what lies
  /// around it.
  void note_nesting(Index corner, bool outgoing_above, std::optional<Index> below) {
    const Index ring = rings_.ring[corner];
    if (seen_[ring]) return;
    seen_[ring] = true;
    nesting_.counter_clockwise[ring] = !outgoing_above;
    if (!below) return;
    const Index neighbour = rings_.ring[*below];
    const bool inside = rings_.runs_right(*below) == nesting_.counter_clockwise[neighbour];
    nesting_.parent[ring] = inside ? std::optional<std::size_t>(neighbour) : nesting_.parent[neighbour];
  }

  bool meets(Index a, Index b) {
    if (!rings_.in_contact(a, b)) return false;
    report(a, b);
    return true;
  }

  void report(Index a, Index b) {
    contact_ = RingContact{rings_.edge(std::min(a, b)), rings_.edge(std::max(a, b))};
  }

  FlatRings rings_;
  Status status_;
  std::vector<Status::iterator> place_;
  std::vector<bool> seen_;
  RingNesting nesting_;
  std::optional<RingContact> contact_;
};

}  // namespace

tl::expected<RingNesting, RingContact> examine_rings(const std::vector<Ring>& rings) {
  return Sweep(rings).run();
}

}  // namespace kempe
