#pragma once
// The bill of materials: what to cut and what to buy.

#include <string>
#include <vector>

#include "synthesis/design/design.hpp"

namespace kempe {

/// One line of the bill. Lengths mm; 0 where a figure means nothing.
struct BomItem {
  std::string
      item{};  ///< "link", "strip", "pin", "post", "spacer", "washer"; "screw", "nut", "bearing", "shim ring", "bush", "dowel"
  std::string name{};  ///< "VA", "pin A", "pole post V"
  int quantity = 1;
  double diameter = 0;  ///< of a pin or post; the bore of a spacer, washer or shim ring
  double length =
      0;  ///< of a link: its farthest joints and over the ends; of a strip: in all; of a pin: what it grips
  double width =
      0;  ///< of a link's arms, of a strip; a spacer's outer diameter, turned down where it must be
  double thickness = 0;                      ///< of a link or strip
  double blank_length = 0, blank_width = 0;  ///< of a link: blank_of()
  std::string remark{};
};

/// Four links; the strip that the straight ones are sawn off; a pin for each of A, B and C and a post for the pole, the
/// tracer and the pen, long enough for the layers that they pass (heads and threads are extra), with the spacers of
/// joint_stack.hpp; then what to buy: two washers a pin, or all that the design's hardware consists of, each thing once with its
/// number and commercial length.
std::vector<BomItem> bill_of_materials(const Design& design);

/// bom.csv: item, name, quantity, diameter_mm, length_mm, width_mm, thickness_mm, blank_length_mm, blank_width_mm, remark
/// (RFC 4180, LF).
std::string bom_csv(const Design& design);

}  // namespace kempe
