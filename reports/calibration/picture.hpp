#pragma once
// Error vectors on the map: what the instrument did wrong where, and what is left once it is corrected.

#include <string>

#include "synthesis/calibration/job.hpp"

namespace kempe {

enum class ErrorVectors { before, after };

struct VectorPicture {
  std::string svg;
  double magnification = 1;  ///< arrows are drawn this many times too long
};

/// The instrument in one pose, an arrow at each place that was read (and before the corrections, thin, all
/// over the reach by the fitted measures), a circle of the target's radius in the arrows' scale. Nothing to
/// draw gives an empty svg. y is turned downward.
VectorPicture vector_picture(const CalibrationRecord& record, ErrorVectors which);

}  // namespace kempe
