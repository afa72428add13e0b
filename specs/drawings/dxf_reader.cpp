#include "specs/drawings/dxf_reader.hpp"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <mutex>
#include <sstream>

#include "specs/drawings/drawing_cover.hpp"

namespace kempe {
namespace {

/// $INSUNITS to mm; 0 where the number names no length (or none at all).
double unit_of(int insunits) {
  switch (insunits) {
    case 1: return 25.4;
    case 2: return 304.8;
    case 3: return 1609344;
    case 4: return 1;
    case 5: return 10;
    case 6: return 1000;
    case 7: return 1e6;
    case 8: return 25.4e-6;
    case 9: return 25.4e-3;
    case 10: return 914.4;
    case 13: return 1e-3;
    case 14: return 100;
    case 15: return 1e4;
    case 16: return 1e5;
    default: return 0;
  }
}

/// Takes what dxflib reads. A polyline or a spline comes in several calls; the next entity or the end of the
/// section closes it (endEntity comes before the vertices of a POLYLINE).
class Collector : public DL_CreationAdapter {
 public:
  DxfDrawing take() {
    finish();
    return std::move(drawing_);
  }

  void setVariableInt(const std::string& key, int value, int) override {
    if (key == "$INSUNITS" && unit_of(value) > 0) drawing_.unit = unit_of(value);
  }
  void addLayer(const DL_LayerData& layer) override { drawing_.layers.push_back(layer.name); }
  void addBlock(const DL_BlockData& block) override {
    finish();
    block_ = &drawing_.blocks[block.name];
    block_->base = {block.bpx, block.bpy};
  }
  void endBlock() override {
    finish();
    block_ = nullptr;
  }

  void addLine(const DL_LineData& line) override {
    add(DxfPolyline{layer(), {{side({line.x1, line.y1}), 0}, {side({line.x2, line.y2}), 0}}, false});
  }
  void addArc(const DL_ArcData& arc) override {
    double from = radians(arc.angle1), sweep = std::remainder(radians(arc.angle2) - from, 2 * pi);
    if (sweep <= 0) sweep += 2 * pi;
    if (mirrored()) from = pi - from - sweep;
    add(DxfCircle{layer(), side({arc.cx, arc.cy}), arc.radius, from, sweep, true});
  }
  void addCircle(const DL_CircleData& circle) override {
    add(DxfCircle{layer(), side({circle.cx, circle.cy}), circle.radius});
  }
  void addEllipse(const DL_EllipseData& ellipse) override {
    add(DxfEllipse{layer(),
                   {ellipse.cx, ellipse.cy},
                   {ellipse.mx, ellipse.my},
                   ellipse.ratio,
                   ellipse.angle1,
                   ellipse.angle2});
  }

  void addPolyline(const DL_PolylineData& polyline) override {
    finish();
    // Meshes (16, 64) are surfaces, not lines.
    if ((polyline.flags & (16 | 64)) != 0) return other();
    polyline_ = DxfPolyline{layer(), {}, (polyline.flags & 1) != 0};
    flipped_ = mirrored();
  }
  void addVertex(const DL_VertexData& vertex) override {
    if (!polyline_) return;
    const Point at(flipped_ ? -vertex.x : vertex.x, vertex.y);
    polyline_->vertices.push_back({at, flipped_ ? -vertex.bulge : vertex.bulge});
  }

  void addSpline(const DL_SplineData& spline) override {
    finish();
    if (spline.nControl == 0) return other();
    spline_ = DxfSpline{layer(), static_cast<int>(spline.degree), {}, {}, {}};
  }
  void addKnot(const DL_KnotData& knot) override {
    if (spline_) spline_->knots.push_back(knot.k);
  }
  void addControlPoint(const DL_ControlPointData& control) override {
    if (!spline_) return;
    spline_->controls.emplace_back(control.x, control.y);
    spline_->weights.push_back(control.w);
  }
  void endSequence() override { finish(); }

  void addText(const DL_TextData& text) override { add(DxfText{layer(), text.text}); }
  void addMText(const DL_MTextData& text) override { add(DxfText{layer(), text.text}); }
  void addInsert(const DL_InsertData& insert) override {
    const Point scale(mirrored() ? -insert.sx : insert.sx, insert.sy);
    add(DxfInsert{layer(),
                  insert.name,
                  side({insert.ipx, insert.ipy}),
                  scale,
                  {insert.colSp, insert.rowSp},
                  radians(mirrored() ? -insert.angle : insert.angle),
                  insert.cols,
                  insert.rows});
  }
  void addHatch(const DL_HatchData&) override { other(); }
  void addSolid(const DL_SolidData&) override { other(); }
  void addTrace(const DL_TraceData&) override { other(); }
  void addPoint(const DL_PointData&) override { other(); }
  void addImage(const DL_ImageData&) override { other(); }

 private:
  std::string layer() { return getAttributes().getLayer(); }

  /// Entities drawn on the back of the plane (extrusion 0, 0, -1) have x mirrored.
  bool mirrored() {
    const DL_Extrusion* plane = getExtrusion();
    return plane != nullptr && plane->getDirection()[2] < 0;
  }
  Point side(const Point& point) { return mirrored() ? Point(-point.x(), point.y()) : point; }

  void add(DxfEntity entity) {
    finish();
    (block_ != nullptr ? block_->entities : drawing_.entities).push_back(std::move(entity));
  }
  void other() {
    finish();
    ++drawing_.others;
  }
  void finish() {
    auto& list = block_ != nullptr ? block_->entities : drawing_.entities;
    if (polyline_ && polyline_->vertices.size() > 1) list.emplace_back(std::move(*polyline_));
    if (spline_) list.emplace_back(std::move(*spline_));
    polyline_.reset();
    spline_.reset();
  }

  DxfDrawing drawing_;
  DxfBlock* block_ = nullptr;
  std::optional<DxfPolyline> polyline_;
  std::optional<DxfSpline> spline_;
  bool flipped_ = false;
};

/// The next line without the spaces around it.
std::string_view next_line(std::string_view& text) {
  const auto end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  const auto first = line.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

/// How many vertices, knots, points or edges an entity announces; the library makes room for them before it meets any.
std::optional<long> announced_count(std::string_view entity, std::string_view code, std::string_view value) {
  struct Count {
    std::string_view entity;
    int code;
  };
  static constexpr std::array counts{Count{"LWPOLYLINE", 90}, Count{"SPLINE", 72}, Count{"SPLINE", 73},
                                     Count{"SPLINE", 74},     Count{"LEADER", 76}, Count{"HATCH", 91},
                                     Count{"HATCH", 93}};
  const auto number = [](std::string_view text) -> std::optional<long> {
    if (text.starts_with('+')) text.remove_prefix(1);
    long result = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), result);
    if (fault == std::errc::result_out_of_range) return std::numeric_limits<long>::max();
    return fault == std::errc() ? std::optional(result) : std::nullopt;
  };
  const auto which = number(code);
  const bool counts_here = std::any_of(counts.begin(), counts.end(), [&](const Count& count) {
    return entity == count.entity && which == count.code;
  });
  return counts_here ? number(value) : std::nullopt;
}

/// Whether a group's value is a real number that the library reads: coordinates, lengths, angles, bulges, weights.
bool holds_real(std::string_view code) {
  int number = 0;
  std::from_chars(code.data(), code.data() + code.size(), number);
  return (number >= 10 && number < 60) || (number >= 110 && number < 150) || (number >= 210 && number < 240);
}

/// The library leaves a number without digits as it finds it in memory.
bool begins_with_real(std::string_view value) {
  if (value.starts_with('+')) value.remove_prefix(1);
  double result = 0;
  const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), result);
  return fault == std::errc() && std::isfinite(result);
}

/// What is wrong with the text as groups of code and value: the library itself passes over everything in
/// silence.
std::optional<InputError> group_fault(std::string_view text, const std::string& file) {
  const auto fault = [&](int line, std::string found, std::string allowed) {
    return InputError{file, line, "", std::move(found), std::move(allowed)};
  };
  if (text.substr(0, 18) == "AutoCAD Binary DXF")
    return fault(0, "a binary DXF", "a DXF saved as text (ASCII)");
  const auto groups = (std::count(text.begin(), text.end(), '\n') + 1) / 2;
  std::string_view entity;
  int line = 0;
  bool any = false;
  while (!text.empty()) {
    const std::string_view code = next_line(text), value = next_line(text);
    line += 2;
    const bool is_code =
        !code.empty() && code.size() <= 5 && code.find_first_not_of("0123456789-") == std::string_view::npos;
    if (!is_code)
      return any ? fault(line - 1, "no group code", "DXF's pairs of group code and value")
                 : fault(0, "text that is not DXF", "a DXF drawing");
    if (code == "0" && value == "EOF") return std::nullopt;
    if (code.find_first_not_of('0') == std::string_view::npos) entity = value;
    if (const auto count = announced_count(entity, code, value); count && *count > groups)
      return fault(line, fmt::format("{} of {} parts", entity, value),
                   fmt::format("at most as many as the file holds ({} groups)", groups));
    if (holds_real(code) && !begins_with_real(value))
      return fault(line, value.empty() ? "an empty line" : "no number",
                   fmt::format("a number, as group code {} asks for", code));
    any = true;
  }
  return fault(0, any ? "the end of the text without EOF" : "an empty file",
               any ? "the rest of the DXF: the file is cut short" : "a DXF drawing");
}

/// dxflib reads numbers with the global locale, which a host program may have set to decimal commas: for the time of a reading
/// it is the classic one. Readings take turns.
class ClassicLocale {
 public:
  ClassicLocale() : turn_(mutex()), before_(std::locale()), changes_(before_ != std::locale::classic()) {
    if (changes_) std::locale::global(std::locale::classic());
  }
  ~ClassicLocale() {
    if (changes_) std::locale::global(before_);
  }
  ClassicLocale(const ClassicLocale&) = delete;
  ClassicLocale& operator=(const ClassicLocale&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex only;
    return only;
  }
  std::lock_guard<std::mutex> turn_;
  std::locale before_;
  bool changes_;
};

}  // namespace

tl::expected<DxfDrawing, InputError> read_dxf(std::string_view text, const std::string& file_name) {
  if (auto fault = group_fault(text, file_name)) return tl::unexpected(std::move(*fault));
  std::istringstream stream{std::string(text)};
  Collector collector;
  const ClassicLocale classic;
  DL_Dxf dxf;
  if (!dxf.in(stream, &collector))
    return tl::unexpected(InputError{file_name, 0, "", "text that is not DXF", "a DXF drawing"});
  return collector.take();
}

tl::expected<Region, InputError> read_dxf_region(std::string_view contents, const std::string& file_name,
                                                 const RegionFileOptions& options) {
  const auto drawing = read_dxf(contents, file_name);
  if (!drawing) return tl::unexpected(drawing.error());
  const std::optional<double> unit = options.unit ? options.unit : drawing->unit;
  if (!unit)
    return tl::unexpected(
        InputError{file_name, 0, "$INSUNITS", "a drawing without units",
                   "units in the drawing, or region.units = \"mm\" (cm, m, inch) in the spec"});
  constexpr double tolerance = 0.01;
  const auto strokes = dxf_strokes(*drawing, file_name, *unit, tolerance);
  if (!strokes) return tl::unexpected(strokes.error());
  const auto texts =
      std::count_if(drawing->entities.begin(), drawing->entities.end(),
                    [](const DxfEntity& entity) { return std::holds_alternative<DxfText>(entity); });
  const std::string remark =
      texts > 0 ? fmt::format("{} texts are not drawn: turn text into lines first", texts) : "";
  return covered_region(*strokes, remark, file_name, options);
}

}  // namespace kempe
