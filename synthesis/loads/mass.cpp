#include "synthesis/loads/mass.hpp"

#include <cmath>

#include "kinematics/assembly_mode.hpp"
#include "specs/hardware.hpp"
#include "synthesis/loads/gravity.hpp"

namespace kempe {
namespace {

double holes_in(Link link, const Spec& spec) {
  const LinkJoints joints = joints_of(link);
  double sum = 0;
  for (int i = 0; i < joints.count; ++i) {
    const double hole = hole_diameter(spec.links.style, spec.links.hardware,
                                      joints.joints[static_cast<std::size_t>(i)], spec.cutting);
    sum += 0.25 * pi * hole * hole;
  }
  return sum;
}

double mass_of(const Spec& spec, double area) {
  return spec.material ? cubic_metres_per_mm3 * spec.material->density * spec.links.style.thickness * area
                       : 0;
}

/// A size of linkage whose arms are long beside their width.
constexpr double widths_of_long_arms = 1e3;

}  // namespace

std::array<double, 4> link_areas(const CopyingLinkage& linkage, const Spec& spec) {
  const OpeningInterval& openings = linkage.assembly_mode().openings;
  const Pose pose = linkage.pose_at(0.5 * (openings.lower + openings.upper), 0);
  std::array<double, 4> areas{};
  for (const Link link : all_links)
    areas[static_cast<std::size_t>(link)] =
        area(link_outline(link, pose, spec.links.style)) - holes_in(link, spec);
  return areas;
}

double mass_of_links(const CopyingLinkage& linkage, const Spec& spec) {
  double sum = 0;
  for (const double each : link_areas(linkage, spec)) sum += each;
  return mass_of(spec, sum);
}

MassPolynomial mass_polynomial(const Spec& spec, Complex k, Grounding grounding) {
  const Complex s = shape_of(k, grounding);
  const double width = spec.links.style.width;
  // Straight and bent plates grow by their width times their length; triangles by their edges' and by their own area.
  const bool straight = is_straight(s),
             triangle = !straight && spec.links.style.plate == PlateStyle::triangle;
  const auto length_of = [&](Complex third) {
    const double x = third.real(), away = std::abs(third);
    if (straight) return std::max({1.0, x, 0.0}) - std::min(x, 0.0);
    return triangle ? 0.5 * (1 + away + std::abs(third - 1.0)) : 1 + away;
  };
  const auto face_of = [&](Complex third) { return triangle ? 0.5 * std::abs(third.imag()) : 0.0; };
  const double unit = widths_of_long_arms * width;
  const auto linkage = CopyingLinkage::make(k, grounding, unit, unit, 0);
  if (!linkage) return {};
  const std::array<double, 4> areas = link_areas(*linkage, spec);
  const auto polynomial = [&](Complex third, Link bar, Link plate) {
    const double c1 = width * (1 + length_of(third)), c2 = face_of(third);
    const double c0 = areas[static_cast<std::size_t>(bar)] + areas[static_cast<std::size_t>(plate)] -
                      c1 * unit - c2 * unit * unit;
    return std::array{mass_of(spec, c0), mass_of(spec, c1), mass_of(spec, c2)};
  };
  return {polynomial(s, Link::VA, Link::BCY), polynomial(1.0 / s, Link::VB, Link::ACX)};
}

}  // namespace kempe
