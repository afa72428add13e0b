#pragma once
// Many poses of one copying linkage at once, column by column, so that the compiler works on several poses an
// instruction. No angle is formed: with w = X - V, a = VA, b = VB/|s|, D = (a - b)(a + b),
//
//   p = w (|w|^2 + D - i h) / (2 |w|^2),    q/s = w (|w|^2 - D + i h) / (2 |w|^2),
//   h = +-sqrt(((a + b)^2 - |w|^2) (|w|^2 - (a - b)^2)),
//
// the two circles about V and X meeting in A; the sign is the assembly mode's.

#include <array>
#include <cstdint>
#include <span>
#include <tl/expected.hpp>
#include <vector>

#include "kinematics/copying_linkage.hpp"

namespace kempe {

/// Poses in columns: x and y of each joint, table frame, mm. Keeps its room from one use to the next.
///
/// Invariant: all columns have the same length. A row that is unreachable holds zeros.
class PoseBatch {
 public:
  std::size_t size() const { return outcome_.size(); }

  std::span<const double> x(Joint joint) const { return x_[static_cast<std::size_t>(joint)]; }
  std::span<const double> y(Joint joint) const { return y_[static_cast<std::size_t>(joint)]; }

  /// Rows that are poses.
  std::size_t reached() const { return reached_; }

  /// Row `row` as a pose, or why there is none.
  tl::expected<Pose, Unreachable> operator[](std::size_t row) const;

 private:
  friend void poses_with_tracer_at(const CopyingLinkage& linkage, std::span<const double> tracer_x,
                                   std::span<const double> tracer_y, PoseBatch& poses);
  void resize(std::size_t count);

  std::array<std::vector<double>, 6> x_, y_;
  std::vector<std::uint8_t> outcome_;  ///< 0: a pose; else 1 + Unreachable
  std::size_t reached_ = 0;
};

/// The poses whose tracers stand at (tracer_x[i], tracer_y[i]), table frame, mm; both spans of the same length.
///
/// Each row agrees with CopyingLinkage::pose_with_tracer_at: the outcome is the same except within 1e-12 of
/// the reach around a limit, and where the transmission angle is mu the places differ by less than
/// 4e-14 / sin^2(mu) of the farthest joint's distance from V. Every link keeps its length to the same 4e-14, at dead
/// points too. The same bytes on every machine.
void poses_with_tracer_at(const CopyingLinkage& linkage, std::span<const double> tracer_x,
                          std::span<const double> tracer_y, PoseBatch& poses);

}  // namespace kempe
