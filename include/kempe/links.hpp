#pragma once
// What the links are made of and which lengths they may have.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "kempe/export.hpp"

namespace kempe {

/// How the material of a link with three joints runs between them.
enum class PlateStyle {
  bent,     ///< two arms: C-A-X with its corner at A, C-B-Y with its corner at B
  triangle  ///< the hull of the three joints
};

/// What the links are made of: all that decides their outlines.
struct LinkStyle {
  double width = 12;                    ///< mm, > 0; a bar is its segment grown by half of this
  double pin_diameter = 6;              ///< mm, > 0, <= width
  double thickness = 4;                 ///< mm, > 0
  PlateStyle plate = PlateStyle::bent;  ///< of the two links with three joints
  bool operator==(const LinkStyle&) const = default;
};

/// Stock lengths: those that a shop has, or that a part at hand gives.
struct KEMPE_EXPORT StockLengths {
  std::optional<double> grid;                   ///< mm: lengths are multiples of this
  std::vector<double> stock;                    ///< mm: lengths are from this list; empty: any
  std::array<std::optional<double>, 8> locked;  ///< mm, in the order of LinkLengths::names
  /// True if anything is dictated.
  bool any() const;
};

/// What to build of, and within which lengths.
struct LinkSpec {
  LinkStyle style;       ///< outlines
  int layers = 2;        ///< at most, >= 2
  double shortest = 15;  ///< mm, between joints of one link
  double longest = 400;  ///< mm
  /// mm, > 0, least wall between two holes of a link; absent: a tenth of the pin
  std::optional<double> wall{};
  StockLengths stock_lengths;  ///< any lengths unless given
  /// What every joint is made of, one of the names in docs/hardware.md, "M6 shoulder bolt"; its pin is style.pin_diameter
  /// then. Empty: plain pins of that diameter.
  std::string hardware{};
};

}  // namespace kempe
