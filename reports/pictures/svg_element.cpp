#include "reports/pictures/svg_element.hpp"

#include "reports/pictures/html_text.hpp"

namespace kempe {

SvgElement& SvgElement::with(std::string_view key, std::string_view value) {
  attributes_.append(" ").append(key).append("=\"").append(html_escaped(value)).append("\"");
  return *this;
}

SvgElement& SvgElement::with(std::string_view key, double value, int decimals) {
  return with(key, coordinate(value, decimals));
}

SvgElement& SvgElement::at(std::string_view x_key, std::string_view y_key, const Point& place, int decimals) {
  return with(x_key, place.x(), decimals).with(y_key, place.y(), decimals);
}

SvgElement& SvgElement::saying(std::string_view words) { return holding(html_escaped(words)); }

SvgElement& SvgElement::holding(std::string_view elements) {
  inside_ += elements;
  return *this;
}

std::string SvgElement::text() const {
  const std::string start = "<" + name_ + attributes_;
  return inside_.empty() ? start + "/>" : start + ">" + inside_ + "</" + name_ + ">";
}

std::string svg_file(const SvgElement& root) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + root.line();
}

std::string view_box(double left, double top, double width, double height) {
  return coordinate(left) + " " + coordinate(top) + " " + coordinate(width) + " " + coordinate(height);
}

SvgElement svg_words(std::string_view css, const Point& at) {
  return SvgElement("text").with("class", css).at("x", "y", {at.x(), -at.y()}).with("dy", ".35em");
}

SvgElement svg_disc(std::string_view css, const Point& at, double radius) {
  return SvgElement("circle").with("class", css).at("cx", "cy", {at.x(), -at.y()}).with("r", radius);
}

SvgElement svg_shape(std::string_view css, std::string_view data) {
  return SvgElement("path").with("class", css).with("d", data);
}

}  // namespace kempe
