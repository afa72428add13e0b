// The entities of a DXF drawing as strokes.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "specs/drawings/dxf_reader.hpp"

namespace kempe {
namespace {

using Eigen::Affine2d;

constexpr int deepest_block = 32;
constexpr int most_copies = 100'000;
/// rad: an ellipse whose ends are nearer goes all the way round: from 0 to 2 pi is written with rounded digits.
constexpr double one_end = 1e-9;

/// The polar form of a B-spline: its value for `degree` parameters, in homogeneous coordinates. With knots u
/// (left) and v of a span, the values for i times v and the rest u are the Bezier points of that span.
/// Source: L. Ramshaw, Blossoming: a connect-the-dots approach to splines, 1987.
class Blossom {
 public:
  explicit Blossom(const DxfSpline& spline) : spline_(spline) {}

  /// `span`: the knot index k with knots[k] < knots[k + 1].
  Eigen::Vector3d at(std::size_t span, const std::vector<double>& parameters) const {
    const auto degree = static_cast<std::size_t>(spline_.degree);
    std::vector<Eigen::Vector3d> value(degree + 1);
    for (std::size_t i = 0; i <= degree; ++i) value[i] = control(span - degree + i);
    for (std::size_t level = 1; level <= degree; ++level)
      for (std::size_t i = degree; i >= level; --i) {
        const double left = spline_.knots[span - degree + i], right = spline_.knots[span + 1 + i - level];
        const double share = right > left ? (parameters[level - 1] - left) / (right - left) : 0;
        value[i] = (1 - share) * value[i - 1] + share * value[i];
      }
    return value[degree];
  }

 private:
  Eigen::Vector3d control(std::size_t i) const {
    const double w = spline_.weights[i];
    return {w * spline_.controls[i].x(), w * spline_.controls[i].y(), w};
  }

  const DxfSpline& spline_;
};

bool is_sound(const DxfSpline& spline) {
  const auto degree = static_cast<std::size_t>(std::max(spline.degree, 0));
  return spline.degree >= 1 && spline.degree <= 25 && spline.controls.size() > degree &&
         spline.knots.size() == spline.controls.size() + degree + 1 &&
         std::is_sorted(spline.knots.begin(), spline.knots.end()) &&
         std::all_of(spline.weights.begin(), spline.weights.end(),
                     [](double w) { return w > 0 && std::isfinite(w); });
}

bool is_rational(const DxfSpline& spline) {
  return std::any_of(spline.weights.begin(), spline.weights.end(),
                     [&](double w) { return w != spline.weights.front(); });
}

Point projected(const Eigen::Vector3d& value) { return {value.x() / value.z(), value.y() / value.z()}; }

class DxfStrokes {
 public:
  DxfStrokes(const DxfDrawing& drawing, const std::string& file, double tolerance)
      : drawing_(drawing), file_(file), tolerance_(tolerance) {}

  tl::expected<std::vector<DrawnStroke>, InputError> draw(const Affine2d& map) {
    draw_all(drawing_.entities, map, 0);
    if (!fault_.empty())
      return tl::unexpected(InputError{file_, 0, "", fault_, "a plain drawing in its own units"});
    return std::move(strokes_);
  }

 private:
  void draw_all(const std::vector<DxfEntity>& entities, const Affine2d& map, int depth) {
    if (depth > deepest_block) fault_ = "blocks nested deeper than 32, or in a circle";
    for (const DxfEntity& entity : entities) {
      if (!fault_.empty()) return;
      CurveFlattener curves(map, tolerance_, CurveFlattener::most_points - points_);
      if (const auto* insert = std::get_if<DxfInsert>(&entity))
        draw_insert(*insert, map, depth);
      else
        std::visit([&](const auto& one) { draw_one(one, curves); }, entity);
      keep(curves);
    }
  }

  void keep(CurveFlattener& curves) {
    if (curves.is_full()) fault_ = "more than 5 million points";
    points_ += curves.points();
    for (DrawnStroke& stroke : curves.take()) {
      if (!is_sound(stroke)) fault_ = "coordinates that are not finite or beyond ten kilometres";
      strokes_.push_back(std::move(stroke));
    }
  }

  void draw_insert(const DxfInsert& insert, const Affine2d& map, int depth) {
    const auto block = drawing_.blocks.find(insert.block);
    if (block == drawing_.blocks.end()) return;
    const int columns = std::max(insert.columns, 1), rows = std::max(insert.rows, 1);
    copies_ += static_cast<long long>(columns) * rows;
    if (copies_ > most_copies) fault_ = "more than 100000 copies of blocks";
    for (int row = 0; row < rows && fault_.empty(); ++row)
      for (int column = 0; column < columns && fault_.empty(); ++column) {
        const Point offset(column * insert.spacing.x(), row * insert.spacing.y());
        const Affine2d placed = map * Eigen::Translation2d(insert.at) * Eigen::Rotation2Dd(insert.turn) *
                                Eigen::Translation2d(offset) *
                                Eigen::Scaling(insert.scale.x(), insert.scale.y()) *
                                Eigen::Translation2d(-block->second.base);
        draw_all(block->second.entities, placed, depth + 1);
      }
  }

  static void draw_edge(CurveFlattener& curves, const DxfVertex& from, const Point& to) {
    if (from.bulge == 0 || from.at == to) return curves.line_to(to);
    const Complex a = as_complex(from.at), b = as_complex(to);
    const Complex centre = 0.5 * (a + b) + Complex(0, 0.25 * (1 / from.bulge - from.bulge)) * (b - a);
    const double radius = std::abs(a - centre);
    curves.elliptic_to(as_point(centre), {radius, 0}, {0, radius}, std::arg(a - centre),
                       4 * std::atan(from.bulge), to);
  }

  static void draw_one(const DxfPolyline& polyline, CurveFlattener& curves) {
    const auto& vertices = polyline.vertices;
    curves.move_to(vertices.front().at);
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) draw_edge(curves, vertices[i], vertices[i + 1].at);
    if (!polyline.closed) return;
    draw_edge(curves, vertices.back(), vertices.front().at);
    curves.close();
  }

  static void draw_one(const DxfCircle& circle, CurveFlattener& curves) {
    const auto at = [&](double angle) {
      return Point(circle.centre + as_point(std::polar(circle.radius, angle)));
    };
    const double end = circle.is_arc ? circle.from + circle.sweep : circle.from;
    curves.move_to(at(circle.from));
    curves.elliptic_to(circle.centre, {circle.radius, 0}, {0, circle.radius}, circle.from, circle.sweep,
                       at(end));
    if (!circle.is_arc) curves.close();
  }

  static void draw_one(const DxfEllipse& ellipse, CurveFlattener& curves) {
    const Point minor = ellipse.ratio * Point(-ellipse.major.y(), ellipse.major.x());
    const auto at = [&](double t) {
      return Point(ellipse.centre + ellipse.major * std::cos(t) + minor * std::sin(t));
    };
    double sweep = std::remainder(ellipse.to - ellipse.from, 2 * pi);
    const bool full = std::abs(sweep) < one_end;
    if (full || sweep < 0) sweep = full ? 2 * pi : sweep + 2 * pi;
    curves.move_to(at(ellipse.from));
    curves.elliptic_to(ellipse.centre, ellipse.major, minor, ellipse.from, sweep,
                       at(full ? ellipse.from : ellipse.to));
    if (full) curves.close();
  }

  static void draw_one(const DxfSpline& spline, CurveFlattener& curves) {
    if (!is_sound(spline)) return;
    const auto degree = static_cast<std::size_t>(spline.degree);
    const bool exact = spline.degree <= 3 && !is_rational(spline);
    bool first = true;
    for (std::size_t span = degree; span + degree + 1 < spline.knots.size(); ++span) {
      if (!(spline.knots[span] < spline.knots[span + 1])) continue;
      if (first) curves.move_to(spline_point(spline, span, 0));
      first = false;
      exact ? draw_bezier_span(spline, span, curves) : draw_sampled_span(spline, span, curves);
    }
  }

  static Point spline_point(const DxfSpline& spline, std::size_t span, double share) {
    const double u = spline.knots[span] + share * (spline.knots[span + 1] - spline.knots[span]);
    return projected(
        Blossom(spline).at(span, std::vector<double>(static_cast<std::size_t>(spline.degree), u)));
  }

  static void draw_bezier_span(const DxfSpline& spline, std::size_t span, CurveFlattener& curves) {
    const auto degree = static_cast<std::size_t>(spline.degree);
    std::vector<Point> bezier;
    for (std::size_t i = 0; i <= degree; ++i) {
      std::vector<double> parameters(degree, spline.knots[span]);
      std::fill(parameters.begin(), parameters.begin() + static_cast<std::ptrdiff_t>(i),
                spline.knots[span + 1]);
      bezier.push_back(projected(Blossom(spline).at(span, parameters)));
    }
    if (degree == 1) curves.line_to(bezier[1]);
    if (degree == 2) curves.quadratic_to(bezier[1], bezier[2]);
    if (degree == 3) curves.cubic_to(bezier[1], bezier[2], bezier[3]);
  }

  /// Rational splines and those of high degree have no cheap bound: halved until the curve's quarters are
  /// near the chord.
  static void draw_sampled_span(const DxfSpline& spline, std::size_t span, CurveFlattener& curves) {
    const double near = 0.5 * curves.own_tolerance();
    const auto draw = [&](const auto& self, double from, double to, int level) -> void {
      const Point a = spline_point(spline, span, from), b = spline_point(spline, span, to);
      const auto off = [&](double share) {
        return std::abs(cross(b - a, spline_point(spline, span, from + share * (to - from)) - a)) /
               (b - a).norm();
      };
      const bool straight = a != b && std::max({off(0.25), off(0.5), off(0.75)}) <= near;
      if (level > 16 || (level > 3 && straight)) return curves.line_to(b);
      self(self, from, 0.5 * (from + to), level + 1);
      self(self, 0.5 * (from + to), to, level + 1);
    };
    draw(draw, 0, 1, 0);
  }

  static void draw_one(const DxfText&, CurveFlattener&) {}
  static void draw_one(const DxfInsert&, CurveFlattener&) {}

  const DxfDrawing& drawing_;
  const std::string& file_;
  double tolerance_;
  std::vector<DrawnStroke> strokes_;
  std::size_t points_ = 0;
  long long copies_ = 0;
  std::string fault_;
};

}  // namespace

tl::expected<std::vector<DrawnStroke>, InputError> dxf_strokes(const DxfDrawing& drawing,
                                                               const std::string& file_name, double unit,
                                                               double tolerance) {
  Affine2d map = Affine2d::Identity();
  map.linear() *= unit;
  return DxfStrokes(drawing, file_name, tolerance).draw(map);
}

}  // namespace kempe
