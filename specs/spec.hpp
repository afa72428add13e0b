#pragma once
// What follows from a spec.

#include "geometry/region.hpp"
#include "kempe/spec.hpp"
#include "kinematics/copying_linkage.hpp"

namespace kempe {

/// Gives a link this cross-section.
inline void use_section(LinkStyle& style, const LinkSection& section) {
  style.width = section.width;
  style.thickness = section.thickness;
}

/// The least wall between two holes of a link, mm: `links.wall`, or what stands in for it.
double least_wall(const Spec& spec);
/// What a joint takes of its link, mm: the pin's diameter, or the hole's if that is wider.
double joint_width(const Spec& spec);
/// The distance of two joints of a link whose holes have no more than the least wall between them, mm.
double hole_distance(const Spec& spec);
/// The least distance of two joints of a link, mm: `links.shortest`, or hole_distance() if that is more. All eight lengths
/// of a linkage keep it: they are the distances of all pairs of joints that share a link.
double least_joint_distance(const Spec& spec);
/// The largest distance of two joints of a link, mm: `links.longest`, or what `limits.longest_strip` leaves between the two
/// half widths at a link's ends, if that is less; 0 or less if the strip is no longer than the links are wide.
double largest_joint_distance(const Spec& spec);
/// True if the strip leaves less than `links.longest`.
bool strip_is_shorter(const Spec& spec);
/// The thickest pin with which hole_distance() is `distance` (mm); 0 or less if there is none.
double pin_for_hole_distance(const Spec& spec, double distance);

}  // namespace kempe
