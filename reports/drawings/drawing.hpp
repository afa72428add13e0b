#pragma once
// A drawing as values: layers and what lies on them, 1:1 in mm, y upward. The DXF and the SVG writer render
// the same one.

#include <string>
#include <variant>
#include <vector>

#include "geometry/arc_polygon.hpp"

namespace kempe {

/// A layer of a drawing: its name (letters, digits, _ and -) and its colour.
struct DrawingLayer {
  std::string name;
  int dxf_colour = 7;  ///< AutoCAD colour index, 1..255; 7 is black on white
  std::string svg_colour = "#000";
  bool is_cut = false;  ///< cut through; other layers are engraved or only looked at
};

/// A closed outline of lines and true arcs, or an open line of straight segments.
struct OutlineShape {
  std::string layer;
  ArcRing ring;
  bool closed = true;
};

struct CircleShape {
  std::string layer;
  Point centre = Point::Zero();
  double radius = 1;  ///< mm, > 0
};

enum class Anchor { left, middle };

/// One line of text; `at` is on its baseline.
struct TextShape {
  std::string layer;
  std::string text;
  Point at = Point::Zero();
  double height = 3;  ///< mm, of a capital letter
  double turn = 0;    ///< rad
  Anchor anchor = Anchor::left;
};

using Shape = std::variant<OutlineShape, CircleShape, TextShape>;

/// Invariant: every shape's layer is one of `layers`; all numbers are finite.
struct Drawing {
  std::vector<DrawingLayer> layers;
  std::vector<Shape> shapes;
};

/// Smallest axis-parallel box of a ring, its arcs included; the ring must not be empty.
Box bounding_box(const ArcRing& ring);
/// Smallest box of all shapes, a text by its estimated width; a box of size 0 at the origin for an empty
/// drawing.
Box bounding_box(const Drawing& drawing);
/// How many decimals keep 13 digits of a thing of this size (mm); at least 12, so that ordinary files stay as they are.
int decimals_for(double size);
/// About how wide a text is, mm.
double text_width(const TextShape& text);

/// A rigid motion: turned by `turn` (rad, counter-clockwise) about the origin, then moved.
struct Placement {
  Point move = Point::Zero();
  double turn = 0;
};
Point placed(const Point& point, const Placement& placement);
ArcRing placed(const ArcRing& ring, const Placement& placement);
Shape placed(const Shape& shape, const Placement& placement);

/// Adds another drawing's shapes and the layers that are new.
void append(Drawing& drawing, const Drawing& other, const Placement& placement = {});

}  // namespace kempe
