#pragma once
// Kempe and Sylvester's plagiograph on the coupler of a four-bar: two links more, and a second point draws the coupler curve turned and
// scaled about a fixed pivot.
//
// With O the pivot, J the joint of its crank on the coupler, P the coupler point and s the ratio, a complex number:
//   C = J + s (P - J)   on the coupler        Q = O + s (P - J)   parallelogram O-J-C-Q
//   Y = Q + s (C - Q)   on the link Q-C       Y - O = s (P - J) + s (J - O) = s (P - O)

#include <cstddef>
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "synthesis/paths/path_generator.hpp"

namespace kempe {

/// The pivot about which the curve is turned and scaled.
enum class CopyPole { crank_pivot, rocker_pivot };

/// What is asked for.
struct CopyTask {
  double scale = 1;              ///< > 0
  double rotation = 0;           ///< rad
  std::optional<CopyPole> pole;  ///< nothing: the one whose parallelogram stays farther from flat
};

/// The six-bar, moved over the path by the general solver.
struct CouplerCopy {
  CopyPole pole = CopyPole::crank_pivot;
  CouplerFourBar linkage;  ///< the four-bar that it stands on: the answer, or its cognate
  CognateDriver driver = CognateDriver::crank;
  double offset = 0;                    ///< rad: the driver's angle is the answer's crank angle and this
  Point coupler_joint = Point::Zero();  ///< C in the coupler's frame, from A along A-B and to its left, mm
  double arm = 0;                       ///< O-Q, mm
  double link = 0;                      ///< Q-C, mm
  Point copy_point = Point::Zero();     ///< Y in the frame of the link Q-C, mm
  Point Q = Point::Zero(), C = Point::Zero();  ///< where they are at the first point, mm
  std::vector<Point> copied;                   ///< where Y is at each point of the path, mm
  double parallelogram_min = 0;  ///< rad: how near to flat it comes, the least of `copy_places` places
  double error_max = 0;          ///< mm: Y from s (P - O) + O, the largest over those places
};

/// How many places along the path a copy is looked at, the path's own points besides.
inline constexpr std::size_t copy_places = 361;

/// The plagiograph on an answer, or on one of its cognates (0 or 1, which the answer must have). The general solver moves the six-bar
/// through `copy_places` places and the path's points, every step certified. The error is a sentence: the copy would be the curve
/// itself, the coupler point lies on the joint, or the parallelogram lies flat on the way (a change point), and where.
tl::expected<CouplerCopy, std::string> copy_on_coupler(const PathAnswer& answer,
                                                       std::optional<std::size_t> cognate,
                                                       const CopyTask& task);

}  // namespace kempe
