#pragma once
// Instruments at the limits of their tolerances, with their loops closed exactly.
//
// The worst case of copy_error.hpp is linear in the errors. Where tolerances are no longer small beside a link, a plate's height or the sine
// of the opening, instruments within them may do worse. Here some of the worst are closed, each plate from its three lengths and each pin in
// its hole. What they do is a lower bound on the true worst case. docs/tolerance.md.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/region_reach.hpp"
#include "kinematics/instrument.hpp"
#include "synthesis/tolerance/copy_error.hpp"

namespace kempe {

/// What is wrong with one instrument at one place, in the order of CopyTolerance.
struct InstrumentErrors {
  std::array<double, 8> length{};  ///< mm; of a flat plate the distance out of line in the place of CX or CY
  std::array<Complex, 5> pin{};    ///< mm; x runs from the pole to the tracer
};

/// The instruments that can be made of one drawing.
class MadeInstruments {
 public:
  explicit MadeInstruments(const CopyingLinkage& linkage);

  /// How far the pen is from the exact image of the tracer, which is held at a distance (mm, > 0) from the pole; mm, x from the pole to the
  /// tracer. Nothing if the instrument does not close there with its plates and dyads turned as the drawn one's are.
  std::optional<Complex> deviation(const InstrumentErrors& errors, double distance) const;

 private:
  Grounding grounding_;
  Complex k_, shape_;
  bool flat_;
  std::array<double, 8> lengths_;
  DyadSides sides_;
};

/// The worst instrument found.
struct CornerError {
  double worst = 0;    ///< mm: how far its pen is from the exact image; 0 if none was found to close
  double opening = 0;  ///< rad, where that is
  bool closes = true;  ///< every instrument that was tried closes where it was tried
};

/// Of the corner that the first order names as worst, its mirror and those of ten other directions, at seventeen openings of an interval and
/// about the worst of them; from the best of each opening every error is moved to its other limit as long as that makes the pen's deviation
/// longer. A few milliseconds.
CornerError corner_error(const CopyingLinkage& linkage, const CopyTolerance& tolerance,
                         const OpeningInterval& openings);

/// Over every distance that the region has from the pole. Nothing if a place of it is out of the linkage's reach.
tl::expected<CornerError, Unreachable> corner_error_over(const CopyingLinkage& linkage,
                                                         const CopyTolerance& tolerance,
                                                         const RegionReach& region);

/// Whether an instrument's error (mm) is so far above the worst case of the first order that the latter must not stand alone.
bool first_order_understates(double worst, double at_corner);

/// A plate that length tolerances may flatten.
struct PlateAtRisk {
  std::string_view plate;  ///< "ACX" or "BCY"
  double flat_from = 0;    ///< mm: its lengths, each off by this or more, may make no triangle
  double height_may_lose =
      0;  ///< share of its height over the line of its parallelogram's side; 1: there may be no triangle
};
/// The plates that may lose a tenth of their height or more; none of flat ones, which are not made by three lengths.
std::vector<PlateAtRisk> plates_at_risk(const CopyingLinkage& linkage, const CopyTolerance& tolerance);

}  // namespace kempe
