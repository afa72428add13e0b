#pragma once
// A spec as a person writes it: what stands in the TOML file, before any reader has looked at it.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "specs/spec.hpp"

namespace kempe::metamorphic {

struct TaskObstacle {
  std::vector<Ring> rings;
  std::optional<std::array<int, 2>> layers{};
};

/// mm and degrees. Everything that has a length is stated, so that enlarging changes nothing else.
struct Task {
  double scale = 1, rotation_deg = 0;
  std::vector<Ring> region, region_holes{};
  Point pole = Point::Zero();
  std::vector<Ring> pole_area{};  ///< not empty: instead of the place
  double width = 12, pin_diameter = 6;
  bool triangle_plates = false;
  int layers = 2;
  double shortest = 15, longest = 400;
  std::optional<double> grid{};
  std::vector<double> stock{};
  std::map<std::string, double> locked{};  ///< by key, "VA_mm"
  double clearance = 0.5, transmission_deg = 30;
  std::optional<double> copy_gap{}, copy_error{};
  std::optional<double> length_tolerance{}, play{};
  std::vector<TaskObstacle> obstacles{};
  std::string objective = "size";
  std::vector<std::string> groundings{"pole", "tracer", "pen"};
};

std::string toml_of(const Task& task);

/// The file with a mechanism at its end, for `kempe workspace`.
std::string toml_of(const Task& task, const MechanismSpec& mechanism);

/// By way of the file; aborts with the file and the reader's complaint if it is refused.
Spec read(const Task& task);

}  // namespace kempe::metamorphic
