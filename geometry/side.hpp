#pragma once
// On which side of a directed line a point lies.

namespace kempe {

/// Seen along the line from its first point to its second. The values are the signs of the cross product of the line with the
/// way to the point, as files store them.
enum class Side : int { right = -1, on_line = 0, left = 1 };

/// The side on which a cross product of this value lies.
constexpr Side side_of(double cross_product) {
  return static_cast<Side>((cross_product > 0) - (cross_product < 0));
}

constexpr int sign(Side side) { return static_cast<int>(side); }

constexpr Side opposite(Side side) { return static_cast<Side>(-sign(side)); }

}  // namespace kempe
