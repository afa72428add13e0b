#pragma once
// What moves with the tracer or the pen: a router, a hand, a follower's holder.

#include <string>
#include <variant>

#include "kempe/region.hpp"

namespace kempe {

/// The point that carries a body.
enum class Carrier { tracer, pen };

/// A disc.
struct Disc {
  Point centre = Point::Zero();  ///< mm
  double radius = 0;             ///< mm, > 0
};

/// A body that tracer or pen carries along; it keeps its direction. Nothing is asked of it and the links that have its point,
/// nor of two bodies of one point: they are mounted on each other.
struct Body {
  Carrier at = Carrier::pen;  ///< what carries it
  std::variant<Disc, Polygon>
      shape;              ///< mm, seen from that point, along the table's axes; a polygon without holes
  int lowest_layer = 1;   ///< 1 is next to the table
  int highest_layer = 1;  ///< >= lowest_layer, at most 8
  std::string name = {};  ///< for people: "body 2" unless the spec names it; empty if not from a spec
};

}  // namespace kempe
