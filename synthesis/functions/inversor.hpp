#pragma once
// Inversors for a lens: linkages that keep x x' = f^2, so that object and image stay in focus at every
// magnification.
//
// With p and q the distances of object and image from the lens, x = p - f, x' = q - f and m = q/p:
//   1/p + 1/q = 1/f   <=>   x x' = f^2,    x = f/m,    x' = f m
// (source: Gannett, Explanation of a rack-and-pinion inversor).

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.hpp"

namespace kempe {

enum class InversorKind {
  peaucellier,  ///< two arms L and a rhombus of sides l: x x' = L^2 - l^2, both on one side of the pivot
  hart,  ///< antiparallelogram of bars a > b, points at the share u of their bars: u (1-u) (a^2 - b^2), both
         ///< sides
  right_angle  ///< a right angle turning at distance f from the scale line cuts it on both sides of its foot
};
inline constexpr std::array<InversorKind, 3> all_inversors{InversorKind::peaucellier, InversorKind::hart,
                                                           InversorKind::right_angle};
std::string_view name(InversorKind kind);

/// What is asked for. Lengths mm, angles rad.
struct InversorTask {
  double focal_length = 0;                                  ///< > 0
  double magnification_lower = 0, magnification_upper = 0;  ///< 0 < lower < upper
  double transmission = 0;                                  ///< limit over the range
  double shortest = 0, longest = infinity;                  ///< of every link
};

/// A length of the inversor and what an error in it does.
struct InversorLength {
  std::string name;    ///< "arm L", "side l", "long bar a", ...
  int count;           ///< so many equal links
  double value;        ///< mm
  double sensitivity;  ///< largest |d x' / d value| over the range at a given x, all equal links changed
                       ///< together
};

struct InversorDesign {
  InversorKind kind;
  std::vector<InversorLength> lengths;
  double point_share = 0;       ///< u of Hart's inversor, else 0
  double size = 0;              ///< mm: sum of all link lengths
  double travel_object = 0;     ///< mm: f/m_lower - f/m_upper
  double travel_image = 0;      ///< mm: f (m_upper - m_lower)
  double transmission_min = 0;  ///< rad, over the range
};

/// The smallest inversor of a kind that keeps the limits, or the sentence why there is none.
struct InversorAnswer {
  InversorKind kind;
  std::optional<InversorDesign> design;
  std::string why_not;
};
InversorAnswer design_inversor(InversorKind kind, const InversorTask& task);

/// All three kinds, in the order of all_inversors.
std::vector<InversorAnswer> design_inversors(const InversorTask& task);

/// The smallest of the answers' designs; nothing if none exists.
std::optional<InversorDesign> smallest(const std::vector<InversorAnswer>& answers);

/// Transmission angle of a Peaucellier inversor of side l (arms sqrt(f^2 + l^2)) at a magnification, rad: the
/// smallest angle between two jointed links or between one and the other's extension. 0 where it cannot
/// stand.
double peaucellier_transmission(double focal_length, double side, double magnification);

/// The same for Hart's inversor of short bar b and share u (long bar from u (1-u) (a^2 - b^2) = f^2).
double hart_transmission(double focal_length, double short_bar, double share, double magnification);

/// The same for the right-angle inversor: the angle between an arm and the scale line.
double right_angle_transmission(double magnification);

}  // namespace kempe
