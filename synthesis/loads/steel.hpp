#pragma once
// The steel of pins and posts.

namespace kempe::steel {

inline constexpr double E = 200e3;  ///< MPa
inline constexpr double G = 77e3;   ///< MPa

}  // namespace kempe::steel
