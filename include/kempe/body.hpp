#pragma once
// What moves with the tracer or the pen: a router, a hand, a follower's holder.

#include <optional>
#include <string>
#include <variant>

#include "kempe/link.hpp"
#include "kempe/region.hpp"

namespace kempe {

/// The point that carries a body.
enum class Carrier { tracer, pen };

/// A disc.
struct Disc {
  Point centre = Point::Zero();  ///< mm
  double radius = 0;             ///< mm, > 0
};

/// A body that tracer or pen carries along. It keeps its direction, or turns with a link: then it is fixed to that link, a part of its
/// plate. Nothing is asked of it and the links that have its point, nor of two bodies of one point: they are mounted on each other. Of a
/// body that turns and the pins of its own link nothing is asked either: they do not move against each other.
struct Body {
  Carrier at = Carrier::pen;  ///< what carries it
  std::variant<Disc, Polygon>
      shape;  ///< mm, seen from that point, along the table's axes or the link's; a polygon without holes
  int lowest_layer = 1;   ///< 1 is next to the table
  int highest_layer = 1;  ///< >= lowest_layer, at most 8
  std::string name = {};  ///< for people: "body 2" unless the spec names it; empty if not from a spec
  /// The link that it turns with, one that has its point: its x axis leads from there to the nearest of the link's other joints, of two
  /// equally near ones to the first of the link's name. Absent: it keeps its direction.
  std::optional<Link> turns_with = {};
};

}  // namespace kempe
