#pragma once
// One SVG element as text: attributes escaped, numbers short and without the locale.

#include <string>
#include <string_view>

#include "geometry/point.hpp"

namespace kempe {

/// <name key="value" ...>inside</name>, or <name .../> with nothing inside. Attributes stand in the order in which they are given.
class SvgElement {
 public:
  explicit SvgElement(std::string_view name) : name_(name) {}

  /// The value is escaped.
  SvgElement& with(std::string_view key, std::string_view value);
  /// At most `decimals` decimals, trailing zeros cut.
  SvgElement& with(std::string_view key, double value, int decimals = 3);
  /// Two numbers, as x and y or cx and cy, in the picture's frame (y downward).
  SvgElement& at(std::string_view x_key, std::string_view y_key, const Point& place, int decimals = 3);
  /// Words between the tags, escaped.
  SvgElement& saying(std::string_view words);
  /// Elements between the tags, as they are.
  SvgElement& holding(std::string_view elements);

  /// The element and a line's end.
  std::string line() const { return text() + "\n"; }
  std::string text() const;

 private:
  std::string name_, attributes_, inside_;
};

inline constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";
/// The outermost element of an SVG file.
inline SvgElement svg_root() { return SvgElement("svg").with("xmlns", svg_namespace); }

/// The text of a file with this root.
std::string svg_file(const SvgElement& root);

/// "left top width height", as a viewBox says it.
std::string view_box(double left, double top, double width, double height);

/// In a picture whose y runs upward, as the table's: words about a place, and a circle.
SvgElement svg_words(std::string_view css, const Point& at);
SvgElement svg_disc(std::string_view css, const Point& at, double radius);
/// A path of this class.
SvgElement svg_shape(std::string_view css, std::string_view data);

}  // namespace kempe
