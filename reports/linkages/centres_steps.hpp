#pragma once
// The way to all instant centres of a linkage, one after another, each from what is known before it.

#include <map>
#include <string>
#include <vector>

#include "kinematics/planar/instant_centres.hpp"
#include "specs/linkages/model.hpp"

namespace kempe {

/// The links of some centres numbered from 1 in their order: what "2-3" speaks of.
std::map<int, int> link_numbers(const std::vector<InstantCentre>& centres);

/// "2-3": a pair of links by their numbers, the smaller first.
std::string centre_name(const std::map<int, int>& numbers, int first, int second);

/// How one centre is found.
struct CentreStep {
  const InstantCentre* centre = nullptr;
  std::string name;               ///< "2-4"
  std::vector<std::string> uses;  ///< the centres that its lines go through: "1-2", "1-4", ...
  /// "links 2, 1, 4: on the line through 1-2 and 1-4; links 2, 3, 4: on the line through 2-3 and 3-4", the joint, or what else
  /// gives it.
  std::string reason;
};

/// A step for every centre: first those that joints give, then as soon as the centres on both of its lines are known each of the others;
/// last, in their order, those that lines do not give. Points into `centres`.
std::vector<CentreStep> centre_steps(const LinkageModel& model, const std::vector<InstantCentre>& centres);

}  // namespace kempe
