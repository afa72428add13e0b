#pragma once
// Lengths, boxes and transforms as SVG writes them.

#include <Eigen/Geometry>
#include <optional>
#include <string_view>

#include "geometry/point.hpp"

namespace kempe {

/// SVG's px, mm.
inline constexpr double svg_px = 25.4 / 96;

/// A length in px: "12", "12px", "1.2e1mm", "50%" (of `whole`, px). Nothing for what is no such length.
std::optional<double> svg_length(std::string_view text, double whole);

/// min-x, min-y, width > 0, height > 0.
struct SvgBox {
  double x = 0, y = 0, width = 0, height = 0;
};
std::optional<SvgBox> svg_view_box(std::string_view text);

/// The map of a viewBox onto a viewport at `corner` of the given size, by preserveAspectRatio's rules
/// (https://www.w3.org/TR/SVG11/coords.html).
Eigen::Affine2d svg_view_map(const SvgBox& view, const Point& corner, const Point& size,
                             std::string_view preserve_aspect_ratio);

/// A list of transforms: matrix, translate, scale, rotate, skewX, skewY. Nothing for what is none.
std::optional<Eigen::Affine2d> svg_transform(std::string_view text);

}  // namespace kempe
