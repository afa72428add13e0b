#pragma once
// What the links are made of, which lengths they may have, and their material.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kempe/export.hpp"
#include "kempe/mechanism.hpp"

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

/// The cross-section of a link.
struct LinkSection {
  double width = 0;      ///< mm, > 0, in the plane
  double thickness = 0;  ///< mm, > 0
  bool operator==(const LinkSection&) const = default;
};

/// Stock lengths: those that a shop has, and lengths locked to those of a part at hand.
struct KEMPE_EXPORT StockLengths {
  std::optional<double> grid;                   ///< mm: lengths are multiples of this
  std::vector<double> stock;                    ///< mm: lengths are from this list; empty: any
  std::array<std::optional<double>, 8> locked;  ///< mm, in the order of LinkLengths::names
  /// True if grid, list or a locked length is given.
  bool any() const;
};

/// What the joints are made of: names in docs/hardware.md, "M6 shoulder bolt"; an empty name stands for plain pins.
struct JointHardware {
  std::string every{};              ///< of each joint that `at` leaves empty
  std::array<std::string, 6> at{};  ///< in the order of Joint: V, A, B, C, X, Y

  JointHardware() = default;
  /// The same at every joint.
  JointHardware(std::string name) : every(std::move(name)) {}
  /// The same, from a text in the program.
  JointHardware(const char* name) : every(name) {}

  /// The name at a joint.
  const std::string& operator[](Joint joint) const {
    const std::string& own = at[static_cast<std::size_t>(joint)];
    return own.empty() ? every : own;
  }
  /// True if every joint has a plain pin.
  bool none() const { return *this == JointHardware(); }
  /// True if some joints are named by themselves.
  bool differs() const { return at != std::array<std::string, 6>(); }
  bool operator==(const JointHardware&) const = default;
};

/// Most cross-sections that a spec may list: each is a search of its own.
inline constexpr std::size_t most_sections = 32;

/// What to build of, and within which lengths.
struct LinkSpec {
  LinkStyle style;       ///< outlines
  int layers = 2;        ///< at most, >= 2
  double shortest = 15;  ///< mm, between joints of one link
  double longest = 400;  ///< mm
  /// mm, > 0, least wall between two holes of a link; absent: a tenth of the pin
  std::optional<double> wall{};
  StockLengths stock_lengths;  ///< any lengths unless given
  /// What the joints are made of. style.pin_diameter is that of the thickest pin then, and of every plain one; contact and
  /// least distances take it for the pin of every joint.
  JointHardware hardware{};
  /// Sections to choose from, the same for all links: sorted by area, the lightest first, each once. `style` has the first of them; in the
  /// spec of a design that was found, the design's own. Empty: style.width and style.thickness.
  std::vector<LinkSection> sections{};
};

/// A material, taken as elastic and the same in every direction. docs/loads.md lists those that a spec can name, with sources.
struct Material {
  std::string name{};         ///< "steel", or what the spec calls it; for people
  double E = 0;               ///< MPa (N/mm^2), > 0: modulus of elasticity
  double density = 0;         ///< kg/m^3, > 0
  double strength = 0;        ///< MPa, > 0: what the largest stress in a link is compared with
  std::optional<double> G{};  ///< MPa, > 0: shear modulus; absent: E / 2.6, as of Poisson's ratio 0.3
  /// MPa
  double shear_modulus() const { return G.value_or(E / 2.6); }
  bool operator==(const Material&) const = default;
};

}  // namespace kempe
