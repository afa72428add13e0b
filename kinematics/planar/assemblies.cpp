#include "kinematics/planar/assemblies.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/chance.hpp"
#include "kinematics/planar/slack.hpp"

namespace kempe {
namespace {

/// Work of a search, in iterations times the cube of the unknowns: some seconds.
constexpr double most_work = 4e9;

/// Where the linkage can be expected: about its ground points.
struct Surroundings {
  Point centre = Point::Zero();
  double reach = 1;
};

Surroundings surroundings_of(const PlanarLinkage& linkage) {
  Surroundings result;
  std::vector<Point> fixed;
  for (const auto& [name, constraint] : linkage.constraints())
    for (const BodyPoint& point : points_of(constraint))
      if (point.body == PlanarLinkage::ground) fixed.push_back(point.local);
  for (const Point& point : fixed) result.centre += point / static_cast<double>(fixed.size());
  result.reach = 1.5 * linkage.size();
  for (const Point& point : fixed) result.reach = std::max(result.reach, (point - result.centre).norm());
  return result;
}

PlanarPosition random_position(int bodies, const Surroundings& about, Chance& chance) {
  PlanarPosition position(static_cast<std::size_t>(bodies));
  for (std::size_t body = 1; body < position.size(); ++body) {
    const double y = chance.uniform(-about.reach, about.reach), x = chance.uniform(-about.reach, about.reach);
    position[body] = {about.centre + Point(x, y), chance.uniform(-pi, pi)};
  }
  return position;
}

/// Bodies whose angle is in no equation but those of turning points: whole turns may be dropped.
std::vector<bool> free_of_turns(const PlanarLinkage& linkage) {
  std::vector<bool> free(static_cast<std::size_t>(linkage.body_count()), true);
  for (const auto& [name, constraint] : linkage.constraints())
    if (std::holds_alternative<RelativeAngle>(constraint) || std::holds_alternative<GearPair>(constraint) ||
        std::holds_alternative<RackAndPinion>(constraint))
      for (const int body : bodies_of(constraint)) free[static_cast<std::size_t>(body)] = false;
  return free;
}

}  // namespace

bool same_assembly_mode(const PlanarLinkage& linkage, const PlanarPosition& a, const PlanarPosition& b) {
  const double near = slack::same_position * linkage.size();
  for (const auto& [name, constraint] : linkage.constraints()) {
    for (const BodyPoint& point : points_of(constraint))
      if ((place(a, point) - place(b, point)).norm() > near) return false;
    for (const int body : bodies_of(constraint)) {
      const double turn = a[static_cast<std::size_t>(body)].angle - b[static_cast<std::size_t>(body)].angle;
      if (std::abs(std::remainder(turn, 2 * pi)) > slack::same_position) return false;
    }
  }
  return true;
}

std::vector<PlanarPosition> find_assembly_modes(const PlanarLinkage& linkage, const PlanarPosition& guess,
                                                const std::vector<double>& driver_values,
                                                const AssemblySearch& search) {
  return search_assembly_modes(linkage, guess, driver_values, search).assembly_modes;
}

AssembliesFound search_assembly_modes(const PlanarLinkage& linkage, const PlanarPosition& guess,
                                      const std::vector<double>& driver_values,
                                      const AssemblySearch& search) {
  const Surroundings about = surroundings_of(linkage);
  const std::vector<bool> turns_dropped = free_of_turns(linkage);
  Chance chance(search.seed);
  AssembliesFound result;
  std::vector<PlanarPosition>& found = result.assembly_modes;
  const double work_a_step = std::pow(linkage.unknown_count(), 3);
  double work = 0;
  bool has_wanted = !search.wanted;
  const auto are_enough = [&] { return has_wanted && static_cast<int>(found.size()) >= search.enough; };
  for (int start = 0; start <= search.starts && !are_enough(); ++start) {
    if (work > most_work || (search.stop && search.stop())) break;
    auto closed = solve_from(
        linkage, start == 0 ? guess : random_position(linkage.body_count(), about, chance), driver_values);
    work += work_a_step * (closed ? closed->iterations : closed.error().iterations);
    if (!closed) {
      if (!result.nearest || closed.error().closure_error < result.nearest->closure_error)
        result.nearest = std::move(closed.error());
      continue;
    }
    for (std::size_t body = 1; body < closed->position.size(); ++body)
      if (turns_dropped[body])
        closed->position[body].angle = std::remainder(closed->position[body].angle, 2 * pi);
    const bool known = std::any_of(found.begin(), found.end(), [&](const PlanarPosition& other) {
      return same_assembly_mode(linkage, closed->position, other);
    });
    if (known) continue;
    has_wanted = has_wanted || search.wanted(closed->position);
    found.push_back(std::move(closed->position));
  }
  return result;
}

}  // namespace kempe
