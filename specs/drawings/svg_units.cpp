#include "specs/drawings/svg_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "specs/drawings/svg_path_reader.hpp"

namespace kempe {
namespace {

using Eigen::Affine2d;

struct Unit {
  std::string_view name;
  double px;
};
constexpr std::array<Unit, 8> units{{{"", 1},
                                     {"px", 1},
                                     {"mm", 96 / 25.4},
                                     {"cm", 960 / 25.4},
                                     {"Q", 24 / 25.4},
                                     {"in", 96},
                                     {"pt", 96.0 / 72},
                                     {"pc", 16}}};

Affine2d affine(double a, double b, double c, double d, double e, double f) {
  Affine2d map = Affine2d::Identity();
  map.matrix().topRows<2>() << a, c, e, b, d, f;
  return map;
}

/// cos and sin of degrees, exact at quarter turns.
Affine2d rotation(double angle) {
  const Complex unit = copy_ratio(1, radians(angle));
  return affine(unit.real(), unit.imag(), -unit.imag(), unit.real(), 0, 0);
}

Affine2d translation(double x, double y) { return affine(1, 0, 0, 1, x, y); }

std::optional<Affine2d> one_transform(std::string_view name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return affine(v[0], v[1], v[2], v[3], v[4], v[5]);
  if (name == "translate" && (n == 1 || n == 2)) return translation(v[0], n == 2 ? v[1] : 0);
  if (name == "scale" && (n == 1 || n == 2)) return affine(v[0], 0, 0, v[n - 1], 0, 0);
  if (name == "rotate" && n == 1) return rotation(v[0]);
  if (name == "rotate" && n == 3) return translation(v[1], v[2]) * rotation(v[0]) * translation(-v[1], -v[2]);
  if (name == "skewX" && n == 1) return affine(1, 0, std::tan(radians(v[0])), 1, 0, 0);
  if (name == "skewY" && n == 1) return affine(1, std::tan(radians(v[0])), 0, 1, 0, 0);
  return std::nullopt;
}

/// 0, 0.5 or 1 for "Min", "Mid" or "Max" after `letter`.
double alignment(std::string_view text, std::string_view letter) {
  const auto at = text.find(letter);
  const std::string_view word = at == std::string_view::npos ? "" : text.substr(at + letter.size(), 3);
  return word == "Min" ? 0 : word == "Max" ? 1 : 0.5;
}

}  // namespace

std::optional<double> svg_length(std::string_view text, double whole) {
  SvgScanner scan(text);
  const auto value = scan.number();
  if (!value) return std::nullopt;
  if (scan.look() == '%') {
    scan.take();
    return scan.at_end() ? std::optional(0.01 * *value * whole) : std::nullopt;
  }
  const std::string_view name = scan.word();
  const auto unit =
      std::find_if(units.begin(), units.end(), [&](const Unit& one) { return one.name == name; });
  if (unit == units.end() || !scan.at_end()) return std::nullopt;
  return *value * unit->px;
}

std::optional<SvgBox> svg_view_box(std::string_view text) {
  SvgScanner scan(text);
  std::array<double, 4> v{};
  for (double& value : v) {
    const auto number = scan.number();
    if (!number) return std::nullopt;
    value = *number;
    scan.skip_separator();
  }
  if (!scan.at_end() || !(v[2] > 0) || !(v[3] > 0)) return std::nullopt;
  return SvgBox{v[0], v[1], v[2], v[3]};
}

Affine2d svg_view_map(const SvgBox& view, const Point& corner, const Point& size, std::string_view preserve) {
  double x_scale = size.x() / view.width, y_scale = size.y() / view.height;
  if (preserve.find("none") == std::string_view::npos) {
    const bool slices = preserve.find("slice") != std::string_view::npos;
    x_scale = y_scale = slices ? std::max(x_scale, y_scale) : std::min(x_scale, y_scale);
  }
  const double x = corner.x() + alignment(preserve, "x") * (size.x() - x_scale * view.width);
  const double y = corner.y() + alignment(preserve, "Y") * (size.y() - y_scale * view.height);
  return translation(x, y) * affine(x_scale, 0, 0, y_scale, 0, 0) * translation(-view.x, -view.y);
}

std::optional<Affine2d> svg_transform(std::string_view text) {
  Affine2d map = Affine2d::Identity();
  SvgScanner scan(text);
  while (!scan.at_end()) {
    const std::string_view name = scan.word();
    scan.skip_space();
    if (scan.take() != '(') return std::nullopt;
    std::vector<double> values;
    while (const auto value = scan.number()) {
      values.push_back(*value);
      scan.skip_separator();
    }
    if (scan.take() != ')') return std::nullopt;
    const auto one = one_transform(name, values);
    if (!one) return std::nullopt;
    map = map * *one;
    scan.skip_separator();
  }
  return map;
}

}  // namespace kempe
