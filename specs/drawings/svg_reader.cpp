#include "specs/drawings/svg_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <pugixml.hpp>

#include "specs/drawings/drawing_cover.hpp"
#include "specs/drawings/svg_path_reader.hpp"
#include "specs/drawings/svg_units.hpp"

namespace kempe {
namespace {

using Eigen::Affine2d;

constexpr int deepest_element = 256;
constexpr std::size_t most_elements = 2'000'000;  ///< drawn, those of `use` counted each time

/// "svg:path" and "path" are the same here: files with prefixes for SVG's own namespace are met.
std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const auto colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string_view attribute(const pugi::xml_node& node, const char* name) {
  return node.attribute(name).value();
}

/// The value of a property in an element's style attribute, else of the attribute of that name.
std::string_view property(const pugi::xml_node& node, std::string_view name) {
  std::string_view style = attribute(node, "style");
  while (!style.empty()) {
    const std::string_view entry = style.substr(0, style.find(';'));
    style.remove_prefix(std::min(style.size(), entry.size() + 1));
    SvgScanner scan(entry);
    scan.skip_space();
    if (scan.word() != name) continue;
    const auto colon = entry.find(':');
    if (colon == std::string_view::npos) continue;
    SvgScanner value(entry.substr(colon + 1));
    value.skip_space();
    return value.word();
  }
  return attribute(node, std::string(name).c_str());
}

int line_at(std::string_view text, std::ptrdiff_t offset) {
  const auto end = std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(text.size()));
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + end, '\n'));
}

/// Walks the tree in drawing order. Stops at the first fault.
class SvgWalk {
 public:
  SvgWalk(std::string_view text, const std::string& file, double tolerance)
      : text_(text), file_(file), tolerance_(tolerance) {}

  tl::expected<StrokeDrawing, InputError> read(const pugi::xml_node& root) {
    index(root);
    draw_root(root);
    if (fault_) return tl::unexpected(*fault_);
    return std::move(drawing_);
  }

 private:
  void refuse(const pugi::xml_node& node, const std::string& what, const std::string& found,
              const std::string& allowed) {
    if (!fault_) fault_ = InputError{file_, line_at(text_, node.offset_debug()), what, found, allowed};
  }

  /// Every element with an id, for `use`; the first of equal ids counts. Depth is checked here, before any
  /// recursion.
  void index(const pugi::xml_node& root) {
    pugi::xml_node node = root;
    int depth = 0;
    while (node) {
      if (const auto id = node.attribute("id")) by_id_.emplace(id.value(), node);
      if (node.first_child()) {
        node = node.first_child();
        if (++depth > deepest_element)
          return refuse(node, "", "elements nested deeper than 256", "a drawing");
        continue;
      }
      while (node && node != root && !node.next_sibling()) {
        node = node.parent();
        --depth;
      }
      node = node == root ? pugi::xml_node() : node.next_sibling();
    }
  }

  double length(const pugi::xml_node& node, const char* name, double whole, double otherwise) {
    const std::string_view text = attribute(node, name);
    if (text.empty() || text == "auto") return otherwise;
    const auto value = svg_length(text, whole);
    if (!value)
      refuse(node, name, fmt::format("\"{}\"", SvgScanner(text).excerpt()),
             "a length in px, mm, cm, in, pt, pc, Q or %");
    return value.value_or(otherwise);
  }

  Affine2d transform(const pugi::xml_node& node) {
    const auto map = svg_transform(attribute(node, "transform"));
    if (!map) refuse(node, "transform", SvgScanner(attribute(node, "transform")).excerpt(), "SVG transforms");
    return map.value_or(Affine2d::Identity());
  }

  /// The map of an element's viewBox into its viewport; the viewport's size becomes the whole that % refers
  /// to.
  Affine2d viewport(const pugi::xml_node& node, const Point& corner, const Point& size) {
    const std::string_view text = attribute(node, "viewBox");
    whole_ = size;
    if (text.empty()) return Affine2d(Eigen::Translation2d(corner));
    const auto view = svg_view_box(text);
    if (!view) refuse(node, "viewBox", SvgScanner(text).excerpt(), "four numbers, width and height above 0");
    if (!view) return Affine2d::Identity();
    whole_ = {view->width, view->height};
    return svg_view_map(*view, corner, size, attribute(node, "preserveAspectRatio"));
  }

  void draw_root(const pugi::xml_node& root) {
    const auto view = svg_view_box(attribute(root, "viewBox"));
    const Point natural = view ? Point(view->width, view->height) : Point(0, 0);
    const Point size(length(root, "width", natural.x(), natural.x()),
                     length(root, "height", natural.y(), natural.y()));
    drawing_.page = size * svg_px;
    Affine2d to_table = Affine2d::Identity();
    to_table.matrix().topRows<2>() << svg_px, 0, 0, 0, -svg_px, drawing_.page.y();
    draw_children(root, to_table * viewport(root, Point::Zero(), size), 0);
  }

  void draw_children(const pugi::xml_node& node, const Affine2d& map, int depth) {
    for (const pugi::xml_node& child : node.children()) {
      if (fault_) return;
      if (child.type() == pugi::node_element) draw(child, map, depth + 1);
    }
  }

  void draw(const pugi::xml_node& node, const Affine2d& outer, int depth) {
    if (depth > deepest_element)
      return refuse(node, "", "elements or uses nested deeper than 256", "a drawing without circles of use");
    if (++elements_ > most_elements) return refuse(node, "", "more than 2 million elements to draw", "fewer");
    if (property(node, "display") == "none") return;
    const std::string_view name = local_name(node);
    const Affine2d map = outer * transform(node);
    if (name == "g" || name == "a" || name == "switch") return draw_children(node, map, depth);
    if (name == "svg") return draw_nested(node, map, depth);
    if (name == "use") return draw_use(node, map, depth);
    if (property(node, "visibility") == "hidden") return;
    if (name == "text")
      ++drawing_.texts;
    else if (name == "image")
      draw_image(node);
    else
      draw_shape(node, name, map);
  }

  void draw_image(const pugi::xml_node& node) {
    ++drawing_.images;
    if (href(node).substr(0, 5) != "data:") ++drawing_.references;
  }

  void draw_nested(const pugi::xml_node& node, const Affine2d& map, int depth) {
    const Point outer_whole = whole_;
    const Point corner(length(node, "x", whole_.x(), 0), length(node, "y", whole_.y(), 0));
    const Point size(length(node, "width", whole_.x(), whole_.x()),
                     length(node, "height", whole_.y(), whole_.y()));
    draw_children(node, map * viewport(node, corner, size), depth);
    whole_ = outer_whole;
  }

  static std::string_view href(const pugi::xml_node& node) {
    const std::string_view plain = attribute(node, "href");
    return plain.empty() ? attribute(node, "xlink:href") : plain;
  }

  void draw_use(const pugi::xml_node& node, const Affine2d& map, int depth) {
    const std::string_view target = href(node);
    if (target.empty() || target.front() != '#') {
      ++drawing_.references;
      return;
    }
    const auto found = by_id_.find(std::string(target.substr(1)));
    if (found == by_id_.end()) return;
    const Point corner(length(node, "x", whole_.x(), 0), length(node, "y", whole_.y(), 0));
    const Affine2d moved = map * Eigen::Translation2d(corner);
    const std::string_view name = local_name(found->second);
    if (name != "symbol" && name != "svg") return draw(found->second, moved, depth + 1);
    const Point outer_whole = whole_;
    const Point size(length(node, "width", whole_.x(), whole_.x()),
                     length(node, "height", whole_.y(), whole_.y()));
    draw_children(found->second, moved * viewport(found->second, Point::Zero(), size), depth + 1);
    whole_ = outer_whole;
  }

  void draw_shape(const pugi::xml_node& node, std::string_view name, const Affine2d& map) {
    CurveFlattener curves(map, tolerance_, CurveFlattener::most_points - points_);
    if (name == "path")
      draw_path(node, curves);
    else if (name == "polyline" || name == "polygon")
      draw_points(node, name == "polygon", curves);
    else if (name == "line")
      draw_line(node, curves);
    else if (name == "rect")
      draw_rectangle(node, curves);
    else if (name == "circle" || name == "ellipse")
      draw_ellipse(node, name, curves);
    else
      return;
    keep(node, curves);
  }

  void keep(const pugi::xml_node& node, CurveFlattener& curves) {
    if (curves.is_full()) return refuse(node, "", "more than 5 million points", "a smaller drawing");
    points_ += curves.points();
    for (DrawnStroke& stroke : curves.take()) {
      if (!is_sound(stroke))
        return refuse(node, "", "coordinates beyond ten kilometres", "a drawing in millimetres");
      drawing_.strokes.push_back(std::move(stroke));
    }
  }

  void draw_path(const pugi::xml_node& node, CurveFlattener& curves) {
    if (const auto found = draw_svg_path(attribute(node, "d"), curves))
      refuse(node, "d", *found, "SVG path data");
  }

  void draw_points(const pugi::xml_node& node, bool closed, CurveFlattener& curves) {
    SvgScanner scan(attribute(node, "points"));
    bool first = true;
    while (!scan.at_end()) {
      const auto x = scan.number();
      scan.skip_separator();
      const auto y = scan.number();
      scan.skip_separator();
      if (!x || !y) return refuse(node, "points", scan.excerpt(), "pairs of numbers");
      first ? curves.move_to({*x, *y}) : curves.line_to({*x, *y});
      first = false;
    }
    if (closed && !first) curves.close();
  }

  double across(const pugi::xml_node& node, const char* name) { return length(node, name, whole_.x(), 0); }
  double down(const pugi::xml_node& node, const char* name) { return length(node, name, whole_.y(), 0); }

  void draw_line(const pugi::xml_node& node, CurveFlattener& curves) {
    curves.move_to({across(node, "x1"), down(node, "y1")});
    curves.line_to({across(node, "x2"), down(node, "y2")});
  }

  void draw_rectangle(const pugi::xml_node& node, CurveFlattener& curves) {
    const double x = across(node, "x"), y = down(node, "y");
    const double width = across(node, "width"), height = down(node, "height");
    if (!(width > 0) || !(height > 0)) return;
    double rx = length(node, "rx", whole_.x(), -1), ry = length(node, "ry", whole_.y(), -1);
    if (rx < 0) rx = ry;
    if (ry < 0) ry = rx;
    rx = std::clamp(rx, 0.0, 0.5 * width);
    ry = std::clamp(ry, 0.0, 0.5 * height);
    curves.move_to({x + rx, y});
    curves.line_to({x + width - rx, y});
    draw_svg_arc(curves, rx, ry, 0, false, true, {x + width, y + ry});
    curves.line_to({x + width, y + height - ry});
    draw_svg_arc(curves, rx, ry, 0, false, true, {x + width - rx, y + height});
    curves.line_to({x + rx, y + height});
    draw_svg_arc(curves, rx, ry, 0, false, true, {x, y + height - ry});
    curves.line_to({x, y + ry});
    draw_svg_arc(curves, rx, ry, 0, false, true, {x + rx, y});
    curves.close();
  }

  void draw_ellipse(const pugi::xml_node& node, std::string_view name, CurveFlattener& curves) {
    const double diagonal = whole_.norm() / std::sqrt(2.0);
    const bool is_circle = name == "circle";
    const double rx = is_circle ? length(node, "r", diagonal, 0) : across(node, "rx");
    const double ry = is_circle ? rx : down(node, "ry");
    if (!(rx > 0) || !(ry > 0)) return;
    const Point centre(across(node, "cx"), down(node, "cy")), start = centre + Point(rx, 0);
    curves.move_to(start);
    curves.elliptic_to(centre, {rx, 0}, {0, ry}, 0, 2 * pi, start);
    curves.close();
  }

  std::string_view text_;
  const std::string& file_;
  double tolerance_;
  std::map<std::string, pugi::xml_node> by_id_;
  Point whole_ = Point::Zero();  ///< what % refers to, user units
  StrokeDrawing drawing_;
  std::size_t points_ = 0, elements_ = 0;
  std::optional<InputError> fault_;
};

/// Entities of a document type that refer to others grow beyond measure when expanded. The parser expands
/// none, so plain ones (some programs write them for namespaces) do no harm.
bool has_entity_bomb(const pugi::xml_document& document) {
  for (const pugi::xml_node& node : document.children()) {
    if (node.type() != pugi::node_doctype) continue;
    std::string_view text = node.value();
    for (auto at = text.find("<!ENTITY"); at != std::string_view::npos; at = text.find("<!ENTITY")) {
      text.remove_prefix(at + 8);
      const std::string_view declaration = text.substr(0, text.find("<!"));
      if (declaration.find('&') != std::string_view::npos || declaration.find('%') != std::string_view::npos)
        return true;
    }
  }
  return false;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return count == 1 ? "1 " + one : fmt::format("{} {}", count, many);
}

}  // namespace

std::string StrokeDrawing::remark() const {
  std::string text;
  const auto add = [&](const std::string& sentence) { text += (text.empty() ? "" : "; ") + sentence; };
  if (texts > 0)
    add(counted(texts, "text is", "texts are") +
        " not drawn: turn text into paths in the drawing program first");
  if (images > 0) add(counted(images, "picture is", "pictures are") + " not drawn");
  if (references > 0)
    add(counted(references, "link to another file is", "links to other files are") + " not followed");
  return text;
}

tl::expected<StrokeDrawing, InputError> read_svg(std::string_view text, const std::string& file_name,
                                                 const SvgOptions& options) {
  pugi::xml_document document;
  const auto refused = [&](int line, const std::string& found, const std::string& allowed) {
    return tl::unexpected(InputError{file_name, line, "", found, allowed});
  };
  const auto parsed =
      document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_doctype);
  if (has_entity_bomb(document))
    return refused(0, "entities that expand to other entities", "an SVG drawing without them");
  if (!parsed)
    return refused(line_at(text, parsed.offset), std::string("broken XML: ") + parsed.description(),
                   "an SVG drawing");
  const pugi::xml_node root = document.document_element();
  if (local_name(root) != "svg")
    return refused(0, fmt::format("the root element <{}>", root.name()), "<svg>");
  return SvgWalk(text, file_name, options.tolerance).read(root);
}

tl::expected<Region, InputError> read_svg_region(std::string_view contents, const std::string& file_name,
                                                 const RegionFileOptions& options) {
  return read_svg(contents, file_name).and_then([&](const StrokeDrawing& drawing) {
    return covered_region(drawing.strokes, drawing.remark(), file_name, options);
  });
}

}  // namespace kempe
