#include "synthesis/loads/hand_work.hpp"

#include <cmath>
#include <utility>

#include "synthesis/loads/gravity.hpp"

namespace kempe {

HandWork::HandWork(const CopyingLinkage& linkage, const LinkStyle& style, const JointHardware& hardware,
                   const Material& material, const Load& load, const PinCompliance& pins,
                   std::optional<LayeredErrorProfile> layered)
    : linkage_(linkage), load_(load), friction_(load.friction, style, hardware),
      bending_(linkage.k(), linkage.grounding(), style, material, load.pen_force, pins),
      weight_(linkage.k(), linkage.grounding(), style, material, load.tilt, pins),
      layered_(std::move(layered)),
      masses_(mass_points(linkage, {style, material.density, load.pen_mass, load.tracer_mass})),
      moments_(mass_moments(linkage, masses_)) {}

PinLoads HandWork::loads_of(const PinPulls& pulls) const {
  const Complex pole = linkage_.pole_joint() == Joint::V ? pulls.VA_at_V : pulls.post;
  return {std::abs(pulls.A), std::abs(pulls.B), std::abs(pulls.C), std::abs(pulls.V), std::abs(pole)};
}

std::optional<HandWorkAt> HandWork::at(const Pose& pose, const Point& heading) const {
  const auto felt = mass_felt(linkage_, masses_, pose);
  const auto weight = hand_force_of_weight(linkage_, moments_, pose, load_.tilt);
  if (!felt || !weight) return std::nullopt;
  const Complex k = linkage_.k();
  const Point drag = -load_.pen_force * as_point(k / std::abs(k) * as_complex(heading));
  HandWorkAt result;
  result.pen_force = drag - Point(0, standard_gravity * std::sin(load_.tilt) * load_.pen_mass);
  load_links(pose, result);
  result.friction = friction_loss(linkage_, pose, loads_of(result.pins), heading, friction_);
  result.hand = hand_force_against(linkage_, drag) + *weight + result.friction * heading;
  result.mass = heading.dot(*felt * heading);
  return result;
}

/// What the pins bear, and how far the pen gives way.
void HandWork::load_links(const Pose& pose, HandWorkAt& result) const {
  const Complex p = as_complex(pose.A - pose.V), q = as_complex(pose.B - pose.V), along = p / std::abs(p);
  const BarLengths lengths{linkage_.VA(), linkage_.VB()};
  const double opening = std::arg(q / p);
  const Complex force = std::conj(along) * as_complex(result.pen_force),
                downhill = std::conj(along) * Complex(0, -1);
  const PinPulls pulls = weight_.pulls(lengths, opening, downhill, force);
  result.pins = {along * pulls.A, along * pulls.B,       along * pulls.C,
                 along * pulls.V, along * pulls.VA_at_V, along * pulls.post};
  if (layered_) {
    const Point give = layered_->give(lengths, opening, as_point(force)) +
                       layered_->give_by_weight(lengths, opening, as_point(downhill));
    result.counts_layers = give.allFinite();
    if (result.counts_layers) result.give = as_point(along * as_complex(give));
  }
  if (result.counts_layers) return;
  result.give = as_point(along * bending_.displacement(lengths, opening, force));
  if (weight_.weighs())
    result.give += as_point(along * as_complex(weight_.give(lengths, opening) * as_point(downhill)));
}

}  // namespace kempe
