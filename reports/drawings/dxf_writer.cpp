#include "reports/drawings/dxf_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "geometry/fixed_text.hpp"

namespace kempe {
namespace {

/// Pairs of group code and value, the only grammar DXF has.
class Groups {
 public:
  Groups& text(int code, std::string_view value) {
    fmt::format_to(std::back_inserter(out_), "{:3}\n{}\n", code, value);
    return *this;
  }
  Groups& integer(int code, int value) { return text(code, std::to_string(value)); }
  Groups& number(int code, double value) {
    const std::string digits = short_text(value, decimals_);
    return text(code, digits.find('.') == std::string::npos ? digits + ".0" : digits);
  }
  Groups& point(const Point& at, int code = 10) {
    return number(code, at.x()).number(code + 10, at.y()).number(code + 20, 0);
  }
  /// As exactly as a thing of this size (mm) needs.
  Groups& as_exact_as(double size) {
    decimals_ = decimals_for(size);
    return *this;
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
  int decimals_ = decimals_for(1);
};

/// The code point that starts at `i`, which moves to its last byte; U+FFFD for what is no UTF-8.
unsigned code_point(std::string_view text, std::size_t& i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned first = byte(i);
  const unsigned length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 1;
  if (length == 1 || first >= 0xF8 || i + length > text.size()) return 0xFFFD;
  unsigned code = first & (0x7FU >> length);
  for (unsigned k = 1; k < length; ++k) {
    if ((byte(i + k) & 0xC0) != 0x80) return 0xFFFD;
    code = code << 6 | (byte(i + k) & 0x3FU);
  }
  i += length - 1;
  return code;
}

/// What R12 reads as one character, from the byte at `i`, which moves to its last one.
std::string escaped_character(std::string_view text, std::size_t& i) {
  const auto byte = static_cast<unsigned char>(text[i]);
  if (byte == '%' && i + 1 < text.size() && text[i + 1] == '%') return "% ";  // %% starts a control sequence
  if (byte < 0x20 || byte == 0x7F) return " ";
  if (byte < 0x80) return std::string(1, text[i]);
  const unsigned code = code_point(text, i);
  return code <= 0xFFFF ? fmt::format("\\U+{:04X}", code) : "?";
}

std::string escaped(std::string_view text) {
  constexpr std::size_t longest = 250;  // R12 allows 255 in a string
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string next = escaped_character(text, i);
    if (result.size() + next.size() > longest) break;
    result += next;
  }
  return result;
}

void write_header(Groups& out, const Box& extent) {
  out.text(0, "SECTION").text(2, "HEADER");
  out.text(9, "$ACADVER").text(1, "AC1009");
  out.text(9, "$INSBASE").point(Point::Zero());
  out.text(9, "$EXTMIN").point(extent.lower);
  out.text(9, "$EXTMAX").point(extent.upper);
  out.text(9, "$INSUNITS").integer(70, 4);
  out.text(9, "$MEASUREMENT").integer(70, 1);
  out.text(0, "ENDSEC");
}

void write_tables(Groups& out, const std::vector<DrawingLayer>& layers) {
  out.text(0, "SECTION").text(2, "TABLES");
  out.text(0, "TABLE").text(2, "LTYPE").integer(70, 1);
  out.text(0, "LTYPE").text(2, "CONTINUOUS").integer(70, 64).text(3, "Solid line").integer(72, 65);
  out.integer(73, 0).number(40, 0).text(0, "ENDTAB");
  out.text(0, "TABLE").text(2, "LAYER").integer(70, static_cast<int>(layers.size()) + 1);
  out.text(0, "LAYER").text(2, "0").integer(70, 0).integer(62, 7).text(6, "CONTINUOUS");
  for (const DrawingLayer& layer : layers)
    out.text(0, "LAYER")
        .text(2, layer.name)
        .integer(70, 0)
        .integer(62, layer.dxf_colour)
        .text(6, "CONTINUOUS");
  out.text(0, "ENDTAB");
  out.text(0, "TABLE").text(2, "STYLE").integer(70, 1);
  out.text(0, "STYLE").text(2, "STANDARD").integer(70, 0).number(40, 0).number(41, 1).number(50, 0);
  out.integer(71, 0).number(42, 3).text(3, "txt").text(4, "").text(0, "ENDTAB");
  out.text(0, "ENDSEC");
}

void write(Groups& out, const OutlineShape& outline) {
  const Box box = bounding_box(outline.ring);
  out.as_exact_as((box.upper - box.lower).maxCoeff());
  out.text(0, "POLYLINE").text(8, outline.layer).integer(66, 1).point(Point::Zero());
  out.integer(70, outline.closed ? 1 : 0);
  for (const ArcVertex& vertex : outline.ring) {
    out.text(0, "VERTEX").text(8, outline.layer).point(vertex.at);
    if (vertex.bulge != 0) out.number(42, vertex.bulge);
  }
  out.text(0, "SEQEND").text(8, outline.layer);
}

void write(Groups& out, const CircleShape& circle) {
  out.as_exact_as(circle.radius);
  out.text(0, "CIRCLE").text(8, circle.layer).point(circle.centre).number(40, circle.radius);
}

void write(Groups& out, const TextShape& text) {
  out.as_exact_as(text.height);
  out.text(0, "TEXT").text(8, text.layer).point(text.at).number(40, text.height).text(1, escaped(text.text));
  out.number(50, degrees(text.turn)).text(7, "STANDARD");
  if (text.anchor == Anchor::middle) out.integer(72, 1).point(text.at, 11);
}

}  // namespace

std::string dxf_text(const Drawing& drawing) {
  Groups out;
  write_header(out, bounding_box(drawing));
  write_tables(out, drawing.layers);
  out.text(0, "SECTION").text(2, "ENTITIES");
  for (const Shape& shape : drawing.shapes) std::visit([&](const auto& one) { write(out, one); }, shape);
  out.text(0, "ENDSEC").text(0, "EOF");
  return out.take();
}

}  // namespace kempe
