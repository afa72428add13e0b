#pragma once
// All instruments within the tolerances at once: where the holes of their links are while the tracer is held, and
// how fast each hole moves with each error, as intervals. Only *_backend.cpp files include it.
//
// Frame: the pole post at the origin, the tracer on the positive x axis. Lengths and discs of play look the same
// from every side, so one distance of the tracer from the pole stands for a whole circle of places.

#include <array>
#include <optional>

#include "geometry/interval.hpp"
#include "kinematics/instrument.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe {

/// What changes: the eight lengths (or, of flat plates, the out-of-line errors in their place), the five pins'
/// displacements along x and y, the tracer's distance from the pole.
inline constexpr std::size_t length_count = 8, pin_count = 5;
inline constexpr std::size_t distance_index = length_count + 2 * pin_count;
inline constexpr std::size_t change_count = distance_index + 1;

/// A length over a box of instruments, and its derivative by each change.
struct BoxLength {
  Interval value{0};
  std::array<Interval, change_count> by;
  BoxLength() { by.fill(Interval(0)); }
};

/// A place, or a complex number, over a box of instruments, and its derivative by each change.
struct BoxPlace {
  IntervalComplex at{Interval(0), Interval(0)};
  std::array<IntervalComplex, change_count> by;
  BoxPlace() { by.fill({Interval(0), Interval(0)}); }
};

BoxPlace operator-(const BoxPlace& u, const BoxPlace& v);
BoxPlace operator*(const BoxPlace& u, const BoxPlace& v);
BoxPlace conjugate(BoxPlace z);

/// The holes' centres, each in its own link ("A_VA": hole A of bar VA), the pole post and the tracer.
enum class Hole { V_VA, V_VB, A_VA, A_ACX, B_VB, B_BCY, C_ACX, C_BCY, X_ACX, Y_BCY, pole, tracer };
inline constexpr std::size_t hole_count = 12;

/// Where they are, and the direction from first to second hole of each link as a unit complex number, conjugated:
/// times it, a difference of places is seen from the link.
struct BoxPose {
  std::array<BoxPlace, hole_count> holes;
  std::array<BoxPlace, 4> seen_from;  ///< VA, VB, ACX, BCY
  const BoxPlace& operator[](Hole hole) const { return holes[static_cast<std::size_t>(hole)]; }
  BoxPlace& operator[](Hole hole) { return holes[static_cast<std::size_t>(hole)]; }
};

/// A plate over a box: its corner (A or B) at 0, C on the positive axis, the third hole (X or Y) at `third`.
struct BoxPlate {
  BoxLength corner_to_C, corner_to_third, C_to_third;
  BoxPlace third;
};

/// The instruments of a linkage within tolerances. Made with the processor rounding to nearest; asked while an
/// OutwardRounding lives.
class InstrumentBox {
 public:
  InstrumentBox(const CopyingLinkage& linkage, const CopyTolerance& tolerance);

  /// Every instrument with the tracer at any of these distances (mm, > 0). Nothing if it is not proven that each of
  /// them closes, with the plates and dyads turned as the drawn instrument's are.
  std::optional<BoxPose> pose(const Interval& distance) const { return posed(every_, distance); }
  /// The instrument as drawn, at one distance.
  std::optional<BoxPose> drawn_pose(double distance) const { return posed(drawn_, Interval(distance)); }

  /// The greatest change of a length, or radius of a disc of play, mm.
  const CopyTolerance& tolerance() const { return tolerance_; }

 private:
  /// What instruments have, whatever the place.
  struct Links {
    std::array<BoxLength, length_count> lengths;
    std::array<BoxPlace, pin_count> pins;
    std::optional<BoxPlate> ACX, BCY;  ///< nothing: not proven to keep its turn
  };
  Links links(bool every) const;
  std::optional<BoxPose> posed(const Links& links, const Interval& distance) const;

  Grounding grounding_;
  CopyTolerance tolerance_;
  Complex shape_;
  bool flat_, straight_;
  std::array<double, length_count> lengths_;
  LoopSides loop_sides_;
  DyadSides dyad_sides_;
  Links drawn_, every_;
};

}  // namespace kempe
