#pragma once
// What a hand feels while it leads the tracer: the force that it needs, what the pins bear, the mass that it moves, and how far the pen
// gives way, from the load of a spec. The work drags at the pen against its motion; on a tilted table everything weighs too.

#include <optional>

#include "synthesis/loads/friction.hpp"
#include "synthesis/loads/layer_offsets.hpp"
#include "synthesis/loads/load_error.hpp"
#include "synthesis/loads/moving_masses.hpp"

namespace kempe {

/// At one pose, in one direction of motion. Forces in N, table frame.
struct HandWorkAt {
  Point pen_force = Point::Zero();  ///< on the pen: drag and the weight of what it carries
  Point hand = Point::Zero();       ///< of the hand on the tracer, friction included
  double friction = 0;              ///< N, what friction adds along the motion
  PinPulls pins{};                  ///< with the weight of the links
  double mass = 0;                  ///< kg felt along the motion
  Point give =
      Point::Zero();  ///< mm, how far the pen gives way in the plane under its force and the links' weight
  bool counts_layers = false;  ///< `give` has what the links' layers add
};

/// One linkage under one load. On a tilted table the weights of the links count in all of it. The table pushes points that rest on it, and never
/// pulls them. Quasi-static: no force of inertia is in it.
class HandWork {
 public:
  /// `pins`: what pins give beside the links. `layered`: links, pins and layers together, of which the pen's give is then; where its equations
  /// lose their digits, links and `pins` alone are counted.
  HandWork(const CopyingLinkage& linkage, const LinkStyle& style, const JointHardware& hardware,
           const Material& material, const Load& load, const PinCompliance& pins = {},
           std::optional<LayeredErrorProfile> layered = std::nullopt);

  /// The tracer moving along `heading`, a unit vector. Nothing at a dead point.
  std::optional<HandWorkAt> at(const Pose& pose, const Point& heading) const;

 private:
  void load_links(const Pose& pose, HandWorkAt& result) const;
  PinLoads loads_of(const PinPulls& pulls) const;

  CopyingLinkage linkage_;
  Load load_;
  PinFriction friction_;
  LoadErrorProfile bending_;
  PlaneWeight weight_;
  std::optional<LayeredErrorProfile> layered_;
  std::vector<MassPoint> masses_;
  MassMoments moments_;
};

}  // namespace kempe
