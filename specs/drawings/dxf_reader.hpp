#pragma once
// Drawings from DXF (all versions that dxflib reads): entities as they stand, and as strokes in millimetres.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "kempe/input_error.hpp"
#include "specs/drawings/curve_flattening.hpp"
#include "specs/drawings/region_file.hpp"

namespace kempe {

/// A corner of a polyline; bulge = tan(sweep / 4) of the arc to the next corner, positive counter-clockwise.
struct DxfVertex {
  Point at = Point::Zero();
  double bulge = 0;
};

/// An entity in the drawing's own unit, as the file has it.
struct DxfPolyline {
  std::string layer;
  std::vector<DxfVertex> vertices;
  bool closed = false;
};
/// A circle, or an arc from angle `from` counter-clockwise by `sweep` (rad).
struct DxfCircle {
  std::string layer;
  Point centre = Point::Zero();
  double radius = 0;
  double from = 0, sweep = 2 * pi;
  bool is_arc = false;
};
/// A B-spline; weights as many as controls.
struct DxfSpline {
  std::string layer;
  int degree = 3;
  std::vector<double> knots, weights;
  std::vector<Point> controls;
};
struct DxfEllipse {
  std::string layer;
  Point centre = Point::Zero(), major = Point::Zero();
  double ratio = 1, from = 0, to = 2 * pi;
};
struct DxfText {
  std::string layer, text;
};

/// A block put in at a place: scaled, turned, moved, perhaps in columns and rows.
struct DxfInsert {
  std::string layer, block;
  Point at = Point::Zero(), scale = Point::Ones(), spacing = Point::Zero();
  double turn = 0;  ///< rad
  int columns = 1, rows = 1;
};

using DxfEntity = std::variant<DxfPolyline, DxfCircle, DxfEllipse, DxfSpline, DxfText, DxfInsert>;

struct DxfBlock {
  Point base = Point::Zero();
  std::vector<DxfEntity> entities;
};

/// What a file holds, in its order; lines are polylines of two corners.
struct DxfDrawing {
  std::vector<DxfEntity> entities;
  std::map<std::string, DxfBlock> blocks;
  std::vector<std::string> layers;  ///< names in the layer table
  std::optional<double> unit;       ///< mm to a drawing unit, by $INSUNITS; absent: the file does not say
  std::size_t others = 0;           ///< entities of other kinds
};

/// Reads a DXF text. Refused: text that is no DXF (no EOF, broken groups), numbers that are not finite.
tl::expected<DxfDrawing, InputError> read_dxf(std::string_view text, const std::string& file_name);

/// The drawing's lines, arcs, circles, ellipses and splines as strokes in mm, blocks put in; `unit` mm to a
/// drawing unit. Refused: coordinates beyond ten kilometres, more than 5 million points, blocks in a circle.
tl::expected<std::vector<DrawnStroke>, InputError> dxf_strokes(const DxfDrawing& drawing,
                                                               const std::string& file_name, double unit,
                                                               double tolerance);

/// The region that a drawing covers: the reader of ".dxf" for region files. A file without units is refused
/// unless the options give them.
tl::expected<Region, InputError> read_dxf_region(std::string_view contents, const std::string& file_name,
                                                 const RegionFileOptions& options);

}  // namespace kempe
