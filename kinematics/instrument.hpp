#pragma once
// A made instrument: the copying linkage with the lengths that it really has, closed numerically.
//
// Unlike CopyingLinkage nothing here knows that the figure V-A-C-B should be a parallelogram or the plates
// similar: the two plates and two bars are closed loop by loop, so the pen goes where such an instrument
// would draw.
//
//   plate 1 in its own frame (C at the origin, X on the axis):  X = (CX, 0),  A = (CX - AX, offset_A)
//   plate 2 in its own frame (C at the origin, Y on the axis):  Y = (CY, 0),  B = (BC, offset_B)
//   bars |A - V| = VA, |B - V| = VB;  the pole joint stands at (pole_x, pole_y) on the table;
//   the output is read in a frame with its origin at (origin_x, origin_y), turned by `turn` against the
//   table.
//
// AX and BC are therefore distances *along* the straight line of the plate, AX from X toward C and BC from C
// toward Y; both keep their meaning, and their derivatives, where a plate is straight and its three lengths
// are dependent.

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <tl/expected.hpp>

#include "kinematics/copying_linkage.hpp"

namespace kempe {

/// What can be wrong with an instrument: eight measures of its links, its pole's place, and the frame in
/// which its output is read. Lengths mm, the turn rad.
enum class Measure { VA, VB, AX, CX, offset_A, BC, CY, offset_B, pole_x, pole_y, origin_x, origin_y, turn };
inline constexpr int measure_count = 13;
std::string_view name(Measure measure);
inline constexpr int index_of(Measure measure) { return static_cast<int>(measure); }

/// A value per measure, in their order.
using Measures = Eigen::Matrix<double, measure_count, 1>;
/// d(x, y) / d(measures).
using PlaceSlopes = Eigen::Matrix<double, 2, measure_count>;

/// On which side of each dyad's base its joint lies: the assembly mode of an instrument whose bars make no exact
/// parallelogram, so that LoopSides does not say how its loops close.
struct DyadSides {
  Side C_of_XY = Side::left;  ///< side of C, seen from X to Y; and so on
  Side V_of_AB = Side::left;
  Side A_of_VX = Side::left;
  Side B_of_VC = Side::left;
  Side B_of_VY = Side::left;
  Side A_of_VC = Side::left;
  bool operator==(const DyadSides&) const = default;
};

/// Which of the joints V, X, Y is pinned, which is set by hand and which is read.
struct Mounting {
  Joint pole = Joint::X;
  Joint input = Joint::Y;
  Joint output = Joint::V;
  bool operator==(const Mounting&) const = default;
};

/// An instrument as drawn: what its measures should be, how it is mounted and put together.
///
/// Invariant: with the measures as drawn it copies, output - pole = ratio * (input - pole).
struct Instrument {
  Measures drawn = Measures::Zero();
  Mounting mounting{};
  DyadSides sides{};
  Complex ratio{1, 0};

  /// The instrument with tracer and pen exchanged: what was read is set, what was set is read, the ratio
  /// 1/k.
  Instrument exchanged() const;
  /// The same links pinned, set and read at other joints.
  Instrument mounted(const Mounting& other) const;
};

/// The made form of a linkage: its own lengths as drawn, the pole where it stands, the reading frame the
/// table's.
Instrument instrument_of(const CopyingLinkage& linkage);

/// Knight's variable ratio pantograph set to `ratio` (0 < ratio < 1): arms of length `arm` (mm, > 0) with the
/// pole at the origin, C on the left of the line from the pole to the tracer (y toward C). In our letters his
/// pole is X, B is A, D is B, the pen E is V and the tracer F is Y; his AB = BE = CD = ratio * arm and DE
/// = (1 - ratio) * arm.
Instrument variable_ratio_instrument(double arm, double ratio);

/// Why no output comes back.
enum class ClosureFault {
  too_far,   ///< two joints are farther apart than the links between them reach
  too_near,  ///< nearer than the links between them can fold
  flat       ///< a triangle of joints is flat: a dead point or the change point
};
std::string_view name(ClosureFault fault);

/// Where the output is, in the reading frame, and how that changes with each measure while the input stays.
struct Output {
  Point at = Point::Zero();
  PlaceSlopes by = PlaceSlopes::Zero();
};

/// The output of an instrument with these measures (its own drawn ones or others near them) whose input joint
/// stands at `input` on the table. Exact derivatives, by implicit differentiation of each closure.
tl::expected<Output, ClosureFault> output_at(const Instrument& instrument, const Measures& measures,
                                             const Point& input);

/// The place of the output for the drawn measures, by the ratio alone: pole + ratio (input - pole) in the
/// reading frame.
Point wanted_output(const Instrument& instrument, const Point& input);

/// All six joints on the table, for pictures.
tl::expected<Pose, ClosureFault> pose_of(const Instrument& instrument, const Measures& measures,
                                         const Point& input);

/// The eight distances between joints that these measures make, in the order of LinkLengths::names, and their
/// slopes.
struct MeasuredLengths {
  Eigen::Matrix<double, 8, 1> values;
  Eigen::Matrix<double, 8, measure_count> by;
};
MeasuredLengths lengths_of(const Measures& measures);

/// True if A, C, X and B, C, Y are drawn in line: then the offsets are errors of their own, out of the line.
bool is_straight(const Instrument& instrument);

}  // namespace kempe
