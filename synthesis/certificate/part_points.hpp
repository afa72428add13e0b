#pragma once
// Parts as a proof log names them: who fills which layer, and points of their axes.

#include <array>
#include <vector>

#include "synthesis/bound/contact.hpp"
#include "synthesis/certificate/proof_log.hpp"

namespace kempe::certificate {

inline constexpr std::uint8_t part_count = 11;

PartName name_of(const Part& part);
Part part_of(PartName name);  ///< without its layers

/// The layers that every part fills in one assignment.
class FilledLayers {
 public:
  FilledLayers(const CopyingLinkage& any, const LayerAssignment& layers);
  bool share(PartName one, PartName other) const;
  /// With what takes these layers.
  bool share(PartName part, int lowest, int highest) const;

 private:
  std::array<int, part_count> lowest_, highest_;  // highest < lowest: none
};

/// The point of the part at, or very near to, a material point of its axis.
PartPoint part_point(PartName part, const bounding::MaterialPoint& at, Complex shape, PlateStyle plate);

/// The material point of a part's point.
bounding::MaterialPoint material_point(const PartPoint& point, Complex shape);

/// The bars of a part's axis, each from one point to another: a link's or plate's, none of a pin or post.
std::vector<std::array<PartPoint, 2>> sides_of(PartName part, PlateStyle plate);

/// True of V, X and Y, which the copy puts at their places whatever the lengths are.
bool is_copied(const PartPoint& point);

/// Which of the three it is, of a copied point.
Joint copied_joint(const PartPoint& point);

/// The point at a share of the way along a side.
PartPoint on_side(const std::array<PartPoint, 2>& side, double share);

/// Points spread along the part's axis.
std::vector<PartPoint> points_along(PartName part, PlateStyle plate);

}  // namespace kempe::certificate
