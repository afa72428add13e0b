#pragma once
// A sheet of paper as values: what is drawn on it, in mm from its lower left corner, y upward. pdf.hpp writes sheets.

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geometry/arc_polygon.hpp"

namespace kempe::workshop {

/// The kinds of line of ISO 128, for the line group 0.5 mm.
enum class Pen {
  outline,  ///< 0.5, visible edges
  hidden,   ///< 0.25, dashed: edges below something
  centre,   ///< 0.25, long dashes and dots: axes of holes
  phantom,  ///< 0.25, long dashes and double dots: what stands beside the part, joins of tiles
  thin,     ///< 0.25: dimensions, leaders, tables
  hatch,    ///< 0.13
  frame     ///< 0.7, the sheet's frame and the title block
};

enum class Fill {
  none,
  paper,  ///< white: hides what was drawn before
  ink,    ///< black
  shade   ///< a light grey
};

/// A line or an outline of straight edges and true arcs.
struct SheetPath {
  ArcRing ring;
  bool closed = true;
  Pen pen = Pen::outline;
  Fill fill = Fill::none;
  bool stroked = true;
};

enum class Align { left, middle, right };

/// One line of text; `at` is on its baseline. UTF-8; what the lettering lacks becomes a question mark.
struct SheetText {
  std::string text;
  Point at = Point::Zero();
  double height = 2.5;  ///< mm, of a capital letter
  Align align = Align::left;
  double turn = 0;  ///< rad
};

/// Paths between `ClipBegin` and `ClipEnd` show inside the box alone.
struct ClipBegin {
  Box box;
};
struct ClipEnd {};

using SheetMark = std::variant<SheetPath, SheetText, ClipBegin, ClipEnd>;

/// What the title block says of one sheet.
struct SheetTitle {
  std::string part;      ///< "Link ACX, item 3"
  std::string material;  ///< "4 mm sheet"
  std::string scale;     ///< "1:1"
};

struct Sheet {
  Point size = Point(210, 297);  ///< mm
  SheetTitle title{};
  std::vector<SheetMark> marks{};  ///< later ones lie on earlier ones

  void line(const Point& from, const Point& to, Pen pen);
  void rectangle(const Box& box, Pen pen, Fill fill = Fill::none);
  void outline(const ArcRing& ring, Pen pen, Fill fill = Fill::none);
  void circle(const Point& centre, double radius, Pen pen, Fill fill = Fill::none);
  void text(std::string text, const Point& at, double height, Align align = Align::left, double turn = 0);
};

/// How wide a text of that height is, mm: the same lettering as the file's.
using Lettering = std::function<double(std::string_view text, double height)>;

/// Heights of letters of ISO 3098, mm: of field names, ordinary text, headings, titles.
inline constexpr double small_text = 1.8, text_height = 2.5, heading_height = 3.5, title_height = 5;
/// From line to line, as a multiple of the height of letters.
inline constexpr double line_pitch = 2;

/// The text, or its beginning and "..." where it is wider than `width` (mm).
std::string shortened(const std::string& text, double height, double width, const Lettering& lettering);
/// The text in lines no wider than `width` (mm), broken between words, and inside a word that is wider alone.
std::vector<std::string> wrapped(const std::string& text, double height, double width,
                                 const Lettering& lettering);

/// A length as a drawing states it: at most three decimals, none that are zero.
std::string figure(double value);

/// How a part's plane lies on a sheet.
struct View {
  double scale = 1;
  Point origin = Point::Zero();  ///< of the part's frame, on the sheet
  Point at(const Point& point) const { return origin + scale * point; }
  ArcRing at(const ArcRing& ring) const;
};

/// The largest scale of ISO 5455 (5:1, 2:1, 1:1, 1:2, 1:5, 1:10, ...), at most `most`, that fits `size` into `room`, mm.
double fitting_scale(const Point& size, const Point& room, double most = 1);
/// "1:2".
std::string scale_text(double scale);

}  // namespace kempe::workshop
