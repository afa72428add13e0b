#pragma once
// Instant centres of all pairs of links: from the joints, by the theorem of Aronhold and Kennedy, and checked
// against the velocities.
//
// The centre of links i and j is the point where both move alike. A revolute joint is one; a slider's lies at
// infinity, square to its line; two wheels' is their pitch point. The centres of any three links lie on one
// line, so two such lines through known centres give an unknown one.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "kinematics/planar/linkage.hpp"

namespace kempe {

/// A straight line on which a centre lies, and where it comes from.
struct CentreLine {
  enum class From {
    kennedy,    ///< through the centres (i, via) and (via, j)
    slider,     ///< square to the line of a pin in a slot, through the pin
    no_turning  ///< the line at infinity: the two links do not turn against each other
  };
  From from = From::kennedy;
  std::optional<int> via{};         ///< the third link, for kennedy
  std::optional<int> constraint{};  ///< the constraint, else
  Point direction = Point::Zero();  ///< unit vector along it; zero for the line at infinity
};

struct InstantCentre {
  enum class Kind { finite, at_infinity, undetermined };
  enum class Source {
    primary,  ///< a joint, a sliding pair or a pitch point
    lines,    ///< two lines meet there
    rates,    ///< from the velocities alone: lines do not give it (two freedoms, or an indeterminate chain)
    none      ///< the two links do not move against each other
  };
  int first = 0, second = 1;  ///< links (bodies), first < second
  Kind kind = Kind::undetermined;
  Point at = Point::Zero();  ///< mm; finite only
  /// Unit vector towards it; at_infinity only. The links translate square to it
  Point direction = Point(1, 0);
  Source source = Source::none;
  std::optional<int> constraint;  ///< the primary's joint
  std::optional<std::array<CentreLine, 2>> lines;
  /// How unlike the two links move at it, relative: |v_i - v_j| / (speed of the pair)
  double velocity_error = 0;
};

/// All n (n - 1) / 2 centres at a closed position, `rate` being the rates of all unknowns there
/// (PlanarPath::velocity). Bodies that cannot turn (particles) are no links and are left out.
std::vector<InstantCentre> instant_centres(const PlanarLinkage& linkage, const PlanarPosition& position,
                                           const Eigen::VectorXd& rate);

}  // namespace kempe
