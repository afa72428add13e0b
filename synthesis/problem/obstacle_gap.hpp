#pragma once
// The gap between a part of the linkage and an obstacle, or another obstruction, with the tracer at a given place, with exact derivatives by the
// lengths and the pole.
//
// In the linkage's own frame (link_gap.hpp) a joint stands at F_j(u, v, d); seen from pole and tracer it stands at
//     z_j = P + (T - P) xi_j,   xi_j = (F_j - F_pole) / (F_tracer - F_pole),
// where the opening d(u, v, P) is that at which the tracer is |T - P| from the pole, so that with r(u, v, d) of smooth_reach.hpp
//     d_u = -r_u / r_d,   d_v = -r_v / r_d,   grad_P d = -(T - P) / (|T - P| r_d).
// Solids that tracer or pen carries are at rest in a frame at that joint: there a joint stands at the difference of two such places,
// and where the frame turns with a link whose x axis has the direction e, |e| = 1, at that difference times conj(e). A corner c of a body
// that turns with a link stands at z_j + e c, and e changes by  e_x = i e Im(w_x / w),  w being that side of the parallelogram, A - V or
// B - V, with which the link turns.
// The gap is that of convex_distance.hpp; with its features held, its derivative is that of the features' places.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "geometry/convex_distance.hpp"
#include "kinematics/stop_flag.hpp"
#include "synthesis/problem/link_gap.hpp"
#include "workspace/obstructions.hpp"

namespace kempe {

/// Convex corners with a circle around them.
struct EncircledPart {
  FixedConvex outline;
  Complex centre;
  double radius = 0;
};

/// A circle around parts that follow each other.
struct PartGroup {
  std::uint32_t first, parts;
  Complex centre;
  double radius;
};

/// An obstruction (obstructions.hpp) as the search and the bound ask it, in its frame: its convex parts, whose nearest features have
/// derivatives, with a circle around all of them.
struct ObstacleShape {
  std::vector<EncircledPart> parts;
  Complex centre;
  double radius = 0;
  /// Of many parts, as a round obstacle has: a tree of circles, each group before its halves; else empty. A group of n parts has
  /// 2 n - 1 groups below and with it.
  std::vector<PartGroup> groups{};
};
/// In the order of the obstructions; once stopped, those so far.
std::vector<ObstacleShape> obstacle_shapes(const std::vector<Obstruction>& obstructions,
                                           const StopFlag& stop = {});

/// What a piece of a body has beyond a piece of a link: its corners stand beside the link's end, and turn with it.
struct BesideLink {
  Link link{};
  std::array<Complex, 3>
      corners{};  ///< mm, along the link's axes at its end; as many as the piece has joints, which are all that end
};

/// A piece of a part, or of a body that turns with a link, and an obstruction that it may meet.
struct ObstacleTerm {
  AxisPiece piece{};                 ///< its half width with what the obstruction is grown by
  std::size_t obstacle = 0;          ///< in the order of the obstructions
  std::optional<Joint> seen_from{};  ///< the joint that carries the obstruction's frame; absent: the table's
  std::optional<Link> turns_with{};  ///< the link with which that frame turns; absent: it keeps its direction
  std::optional<BesideLink> beside{};  ///< of a body that turns; absent: the piece's corners are joints
};
/// `bodies` are those that the obstructions were made of.
std::vector<ObstacleTerm> obstacle_terms(const CopyingLinkage& linkage, const LayerAssignment& layers,
                                         const LinkStyle& style, const std::vector<Obstruction>& obstructions,
                                         const std::vector<Body>& bodies = {});

/// Value and derivatives by u, v and the pole's place, mm.
struct PlacedJet {
  double value = 0;
  double by_u = 0, by_v = 0;
  Point by_pole = Point::Zero();
};

/// The joints in the table's frame with the tracer at a place.
class PlacedJoints {
 public:
  PlacedJoints(const Reach& reach, const JointRoles& roles, const LogLengths& lengths, const Point& pole,
               const Point& tracer)
      : PlacedJoints(reach, roles, lengths, reach.sides(lengths), pole, tracer) {}
  /// `sides`: reach.sides(lengths), worked out once for many places.
  PlacedJoints(const Reach& reach, const JointRoles& roles, const LogLengths& lengths,
               const SideLengths& sides, const Point& pole, const Point& tracer);
  Complex operator[](Joint joint) const { return at_[static_cast<std::size_t>(joint)]; }
  const std::array<Complex, 6>& all() const { return at_; }  ///< in the order of Joint
  /// The direction of the x axis of what is fixed to the link at its end, of size 1.
  Complex axis(Link link) const;

  struct Motion {
    Complex by_u, by_v, by_pole_x, by_pole_y;
  };
  Motion motion(Joint joint) const;
  /// What turns the link, rad per unit of each.
  struct Turning {
    double by_u, by_v, by_pole_x, by_pole_y;
  };
  Turning turning(Link link) const;

 private:
  const Reach& reach_;
  JointRoles roles_;
  LogLengths lengths_;
  SideLengths sides_;
  Complex reach_vector_;  ///< tracer - pole
  JointFrame frame_;
  std::array<Complex, 6> at_;
};

/// What is returned for a gap larger than `enough`: a lower bound that is close to it, or any number above `enough`, which is quicker.
enum class Beyond { near_it, anything };

/// The gap, mm; negative: depth. Where it is larger than `enough`, what `beyond` says.
double obstacle_gap(const ObstacleTerm& term, const ObstacleShape& obstacle, const PlacedJoints& joints,
                    double enough, Beyond beyond = Beyond::near_it);
PlacedJet obstacle_gap_jet(const ObstacleTerm& term, const ObstacleShape& obstacle,
                           const PlacedJoints& joints);

/// The smallest gaps of one design over places of the tracer. Assignments of layers share most of their terms: each is worked
/// out once, whichever of them asks first.
class SmallestGaps {
 public:
  /// Gaps larger than `up_to` (mm) count as `up_to`. What is referred to must outlive this.
  SmallestGaps(const Reach& reach, const JointRoles& roles, const LogLengths& lengths, const Point& pole,
               std::span<const Point> places, const std::vector<ObstacleShape>& obstacles, double up_to);

  double up_to() const { return up_to_; }
  std::size_t places() const { return joints_.size(); }
  double of(const ObstacleTerm& term);

 private:
  using Key =
      std::tuple<std::size_t, double, int, std::array<Joint, 3>, std::optional<Joint>, std::optional<Link>>;
  double smallest(const ObstacleTerm& term) const;

  std::vector<PlacedJoints> joints_;  ///< with the tracer at each place
  const std::vector<ObstacleShape>& obstacles_;
  double up_to_;
  std::map<Key, double> known_;
};

/// Places of the tracer at which obstacles are looked at: along the region's outline and inside, about `about` of them.
std::vector<Point> tracer_places(const Region& region, int about);

}  // namespace kempe
