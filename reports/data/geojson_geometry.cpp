#include "reports/data/geojson_geometry.hpp"

#include <array>
#include <string_view>

namespace kempe {
namespace {

using nlohmann::ordered_json;

ordered_json closed_ring(const Ring& ring) {
  ordered_json positions = ordered_json::array();
  for (const Point& point : ring) positions.push_back(position(point));
  if (!ring.empty()) positions.push_back(position(ring.front()));
  return positions;
}

/// Brackets, commas and lines as ordered_json::dump() sets them.
class JsonText {
 public:
  JsonText(std::string& text, int indent, int depth) : text_(text), indent_(indent), depth_(depth) {}

  void key(std::string_view name) {
    begin_item();
    text_.append(1, '"').append(name).append(indent_ < 0 ? "\":" : "\": ");
    place_ = Place::after_key;
  }
  void open(char bracket) {
    begin_item();
    text_ += bracket;
    ++depth_;
    place_ = Place::after_bracket;
  }
  void close(char bracket) {
    --depth_;
    if (place_ != Place::after_bracket) new_line();
    text_ += bracket;
    place_ = Place::after_item;
  }
  void value(std::string_view one) {
    begin_item();
    text_.append(1, '"').append(one).append(1, '"');
  }
  /// Finite, as dump() writes it: with a value for each of a map's numbers a fifth of its time would go into them.
  void value(double one) {
    begin_item();
    std::array<char, 64> digits{};
    const char* end = nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), one);
    text_.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
  }

 private:
  enum class Place { after_key, after_bracket, after_item };

  void begin_item() {
    if (place_ == Place::after_item) text_ += ',';
    if (place_ != Place::after_key) new_line();
    place_ = Place::after_item;
  }
  void new_line() {
    if (indent_ < 0) return;
    text_ += '\n';
    text_.append(static_cast<std::size_t>(indent_) * static_cast<std::size_t>(depth_), ' ');
  }

  std::string& text_;
  int indent_, depth_;
  Place place_ = Place::after_key;
};

void write(JsonText& text, const Ring& ring) {
  text.open('[');
  const auto write_position = [&](const Point& point) {
    text.open('[');
    text.value(point.x());
    text.value(point.y());
    text.close(']');
  };
  for (const Point& point : ring) write_position(point);
  if (!ring.empty()) write_position(ring.front());
  text.close(']');
}

}  // namespace

void append_multi_polygon(std::string& into, const Region& region, int indent, int depth) {
  JsonText text(into, indent, depth);
  text.open('{');
  text.key("type");
  text.value("MultiPolygon");
  text.key("coordinates");
  text.open('[');
  for (const Polygon& polygon : region.polygons) {
    text.open('[');
    write(text, polygon.outer);
    for (const Ring& hole : polygon.holes) write(text, hole);
    text.close(']');
  }
  text.close(']');
  text.close('}');
}

ordered_json position(const Point& point) { return ordered_json::array({point.x(), point.y()}); }

ordered_json multi_polygon(const Region& region) {
  ordered_json coordinates = ordered_json::array();
  for (const Polygon& polygon : region.polygons) {
    ordered_json rings = ordered_json::array({closed_ring(polygon.outer)});
    for (const Ring& hole : polygon.holes) rings.push_back(closed_ring(hole));
    coordinates.push_back(std::move(rings));
  }
  return {{"type", "MultiPolygon"}, {"coordinates", std::move(coordinates)}};
}

}  // namespace kempe
