#pragma once
// The bill of materials: what to cut and what to buy.

#include <string>
#include <vector>

#include "synthesis/design/design.hpp"

namespace kempe {

/// One line of the bill. Lengths mm; 0 where a figure means nothing.
struct BomItem {
  std::string item;  ///< "link", "pin", "post", "spacer", "washer"
  std::string name;  ///< "VA", "pin A", "pole post V"
  int quantity = 1;
  double diameter = 0;  ///< of a pin or post; the bore of a spacer or washer
  double length = 0;    ///< of a link: between its farthest joints and over the ends; of a pin: what it grips
  double width = 0;     ///< of a link; a spacer's outer diameter
  double thickness = 0;  ///< of a link
  std::string remark;
};

/// Four links; a pin for each of A, B and C and a post for the pole, the tracer and the pen, long enough for
/// the layers that they pass (layer n lies between (n-1) and n thicknesses above the table; heads and threads
/// are extra); a spacer wherever a pin or post passes an empty layer; two washers a pin.
std::vector<BomItem> bill_of_materials(const Design& design);

/// bom.csv: item, name, quantity, diameter_mm, length_mm, width_mm, thickness_mm, remark (RFC 4180, LF).
std::string bom_csv(const Design& design);

}  // namespace kempe
