#pragma once
// The one copying linkage: its joints and links, its three groundings, and where its six points are.

#include <array>
#include <string_view>

#include "kempe/export.hpp"
#include "kempe/point.hpp"

namespace kempe {

/// The six named points of the drawing: the parallelogram V A C B, and the plates' ends X and Y. V, X and Y are the homologous
/// points, corners of a triangle that stays similar to itself.
enum class Joint { V, A, B, C, X, Y };

/// The four moving links, in the order of every array over links.
enum class Link { VA, VB, ACX, BCY };
/// The four, in that order.
inline constexpr std::array<Link, 4> all_links{Link::VA, Link::VB, Link::ACX, Link::BCY};

/// A grounding, named after what stands at the parallelogram's vertex V.
enum class Grounding {
  pole,    ///< pole V, tracer X, pen Y; s = k        (plagiograph)
  tracer,  ///< pole X, tracer V, pen Y; s = 1 - k    (drawing pantograph)
  pen      ///< pole X, tracer Y, pen V; s = 1 - 1/k  (variable ratio pantograph)
};
/// The three, in the order in which they are looked at and listed.
inline constexpr std::array<Grounding, 3> all_groundings{Grounding::pole, Grounding::tracer, Grounding::pen};

/// "pole", "tracer" or "pen".
KEMPE_EXPORT std::string_view name(Grounding grounding);

/// Where the six points are (or: their velocities, their accelerations), table frame, mm (mm/s, mm/s^2).
struct KEMPE_EXPORT Pose {
  Point V;  ///< vertex of the parallelogram
  Point A;  ///< of the parallelogram, on the plate A-C-X
  Point B;  ///< of the parallelogram, on the plate B-C-Y
  Point C;  ///< opposite to V
  Point X;  ///< end of the plate A-C-X
  Point Y;  ///< end of the plate B-C-Y
  /// The point of that name.
  const Point& operator[](Joint joint) const;
  /// The same, to be set.
  Point& operator[](Joint joint);
};

/// The eight distances between joints of one link, mm.
struct LinkLengths {
  double VA;  ///< from V to A
  double VB;  ///< from V to B
  double AC;  ///< from A to C
  double BC;  ///< from B to C
  double AX;  ///< from A to X
  double CX;  ///< from C to X
  double BY;  ///< from B to Y
  double CY;  ///< from C to Y
  /// Their names in their order.
  static constexpr std::array<std::string_view, 8> names{"VA", "VB", "AC", "BC", "AX", "CX", "BY", "CY"};
  /// The lengths in that order, mm.
  std::array<double, 8> values() const { return {VA, VB, AC, BC, AX, CX, BY, CY}; }
};

/// Why a pose does not exist: an outcome of the domain, not an error.
enum class Unreachable {
  too_far,             ///< beyond the outer reach (serial dead point V, A, X stretched)
  too_near,            ///< inside the inner reach (serial dead point folded), the pole itself included
  beyond_change_point  ///< the chain reaches it, but only with the parallelogram past its flat position
};
/// "beyond the outer reach" and so on, for a person.
KEMPE_EXPORT std::string_view name(Unreachable why);

/// A closed interval of the opening d = arg(B - V) - arg(A - V), rad, within [-pi, pi]; empty when lower > upper.
struct OpeningInterval {
  double lower = 1;  ///< rad
  double upper = 0;  ///< rad

  /// True if it holds no opening.
  bool empty() const { return !(lower <= upper); }
  /// rad; 0 if empty.
  double width() const { return empty() ? 0 : upper - lower; }
  /// rad.
  double middle() const { return 0.5 * (lower + upper); }
  /// True for an opening in it, its ends included.
  bool contains(double opening) const { return lower <= opening && opening <= upper; }
  /// True if every opening of the other is in it.
  bool contains(const OpeningInterval& other) const {
    return other.empty() || (lower <= other.lower && other.upper <= upper);
  }
  bool operator==(const OpeningInterval&) const = default;
};

}  // namespace kempe
