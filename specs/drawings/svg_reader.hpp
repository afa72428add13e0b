#pragma once
// Drawings from SVG: every shape as strokes in millimetres. Nothing is fetched, run or copied.

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "kempe/input_error.hpp"
#include "specs/drawings/curve_flattening.hpp"
#include "specs/drawings/region_file.hpp"

namespace kempe {

/// A drawing as strokes in the order in which they are drawn.
struct StrokeDrawing {
  std::vector<DrawnStroke> strokes;  ///< mm, y upward; the page's lower left corner is the origin
  Point page = Point::Zero();        ///< width and height of the page, mm
  std::size_t texts = 0;             ///< texts that have no outlines here: they are not drawn
  std::size_t images = 0;            ///< pictures, not drawn
  std::size_t references = 0;        ///< links to other files, not followed
  /// What a person should know: "2 texts are not drawn: turn them into paths first". Empty if nothing was
  /// left out.
  std::string remark() const;
};

struct SvgOptions {
  double tolerance = 0.01;  ///< mm, > 0: polylines depart from curves by at most this
};

/// Reads paths, lines, polylines, polygons, rectangles, circles and ellipses with all transforms, groups,
/// nested svg elements, symbols and `use` of the same file. Lengths: px (96 to the inch), mm, cm, Q, in, pt,
/// pc, %; without a viewBox a unit is a px. What is not displayed, and definitions that are not used, are not
/// drawn; fills and strokes are not told apart.
///
/// Refused, with line and what stands there: text that is no SVG, entities that expand to others (an entity
/// bomb), path data or lengths or transforms that cannot be read, numbers that are not finite, more than 5
/// million points, nesting deeper than 256, `use` in a circle.
tl::expected<StrokeDrawing, InputError> read_svg(std::string_view text, const std::string& file_name,
                                                 const SvgOptions& options = {});

/// The region that a drawing covers: the reader of ".svg" for region files.
tl::expected<Region, InputError> read_svg_region(std::string_view contents, const std::string& file_name,
                                                 const RegionFileOptions& options);

}  // namespace kempe
