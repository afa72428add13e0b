#pragma once
// The blanks: what a link is cut from.

#include <string>
#include <vector>

#include "synthesis/design/design.hpp"

namespace kempe {

/// The pose of a link turned so that the upright rectangle round its outline has the smallest area and lies down; its first
/// joint is the origin. A side of that rectangle lies along a side of the joints' hull: between two such directions both
/// sides of the rectangle are positive concave functions of the turn, so their product is smallest at an end (Freeman and
/// Shapira, Communications of the ACM 18 (1975), for polygons; growing the hull by half a width adds a constant to both).
///
/// It depends on the link alone, not on where the pole stands: far from the origin it loses no digits.
Pose lying_pose(const Design& design, Link link);

/// The rectangle of smallest area that holds a link's outline, without kerf, mm.
struct Blank {
  double length;  ///< >= width
  double width;
};
Blank blank_of(const Design& design, Link link);

/// The longest link over its ends, mm: its farthest joints and half its width beyond each. No blank is longer, however a link
/// is laid.
double longest_over_ends(const Design& design);

/// True if all holes of the link lie on one line, so that it is a bar however it was asked for.
bool is_straight_link(const Design& design, Link link);

/// "bar", "straight bar, three holes", "bent plate" or "triangular plate".
std::string_view form_of(const Design& design, Link link);

/// Straight links that are sawn off one strip, one after the other, their ends rounded afterwards.
struct Strip {
  struct Piece {
    Link link;
    double length;  ///< mm, over the ends
  };
  double width, thickness;    ///< mm, what to buy
  std::vector<Piece> pieces;  ///< the longest first
  double length;              ///< mm, what to buy at least: all pieces, and a kerf for each
};

/// What to buy for the straight links; nothing if there is none (there always are two: VA and VB).
Strip strip_of(const Design& design);

}  // namespace kempe
