#pragma once
// The paper that drawings are printed on.

namespace kempe {

enum class Paper {
  A4,  ///< 210 x 297 mm
  A3   ///< 297 x 420 mm
};

}  // namespace kempe
