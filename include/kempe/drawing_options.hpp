#pragma once
// How a drawing lies on the table, and what copies it: the options of `kempe trace`; and the paper that drawings are printed on.

#include <cstdint>
#include <functional>
#include <optional>

#include "kempe/point.hpp"

namespace kempe {

/// How a drawing is placed, and by which instrument it is copied.
struct DrawingOptions {
  std::optional<Point> at;          ///< mm: where its page's lower left corner lies; absent: (0, 0)
  std::optional<double> scale;      ///< it is so many times enlarged, 1e-6 to 1e6; absent: 1
  bool fit = false;                 ///< instead of both: in the middle of the region's box, as large as fits
  std::optional<double> tolerance;  ///< mm, 1e-7 to 10: curves are followed to this; absent: 0.01, or a
                                    ///< thousandth of the region's diagonal if less
  std::optional<double> step;       ///< mm, 1e-4 to 1e3: poses are at most this far apart; absent: 0.5, or a
                                    ///< twentieth of the region's diagonal if less
  std::optional<std::uint64_t> instrument;  ///< seed of an instrument made within the design's tolerances
  bool load = false;                        ///< the pen gives way under the design's load
  bool keep_joints = false;                 ///< make the table of the joints' places
  bool keep_forces = false;      ///< make the table of the hand's forces, and colour the copy by them
  std::function<bool()> stop{};  ///< true ends it; asked at every pose, in the thread that copies
};

/// The paper that drawings are printed on.
enum class Paper {
  A4,  ///< 210 x 297 mm
  A3   ///< 297 x 420 mm
};

}  // namespace kempe
