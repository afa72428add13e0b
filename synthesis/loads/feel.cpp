#include "synthesis/loads/feel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "kinematics/links.hpp"
#include "synthesis/loads/hand_work.hpp"
#include "synthesis/loads/top_over.hpp"

namespace kempe {
namespace {

struct MassRange {
  double most = 0, least = 0;
};

/// The eigenvalues of the mass that the hand feels.
MassRange masses_at(const CopyingLinkage& linkage, const std::vector<MassPoint>& points, double opening) {
  const auto felt = mass_felt(linkage, points, linkage.pose_at(opening, 0));
  if (!felt) return {infinity, 0};
  const double middle = 0.5 * felt->trace(),
               half = std::hypot(0.5 * ((*felt)(0, 0) - (*felt)(1, 1)), (*felt)(0, 1));
  return {middle + half, std::max(0.0, middle - half)};
}

/// The most that the hand holds of the weight, over all bearings; sampled.
double weight_at(const CopyingLinkage& linkage, const MassMoments& moments, double opening, double tilt) {
  constexpr int bearings = 90;
  double most = 0;
  for (int i = 0; i < bearings; ++i) {
    const auto force =
        hand_force_of_weight(linkage, moments, linkage.pose_at(opening, 2 * pi * i / bearings), tilt);
    most = std::max(most, force ? force->norm() : infinity);
  }
  return most;
}

/// The most that the hand pushes with at an opening, over bearings and directions of motion. Against a large weight it pushes most where it
/// moves that way, which is tried in every bearing; where friction counts more, it is one of the even ones.
double hand_at(const CopyingLinkage& linkage, const HandWork& work, const MassMoments& moments,
               double opening, double tilt) {
  const bool tilted = tilt > 0;  // on a level table all bearings are alike
  const int bearings = tilted ? 36 : 1, headings = tilted ? 12 : 90;
  double most = 0;
  for (int i = 0; i < bearings; ++i) {
    const Pose pose = linkage.pose_at(opening, 2 * pi * i / bearings);
    const auto try_heading = [&](const Point& heading) {
      const auto here = work.at(pose, heading);
      most = std::max(most, here ? here->hand.norm() : infinity);
    };
    for (int j = 0; j < headings; ++j) try_heading(as_point(std::polar(1.0, 2 * pi * j / headings)));
    const auto weight = hand_force_of_weight(linkage, moments, pose, tilt);
    if (weight && weight->norm() > 0) try_heading(weight->normalized());
  }
  return most;
}

/// "along the bar", "against the bar", or the angle from it.
std::string direction_words(Complex direction) {
  const double angle = degrees(std::arg(direction));
  if (std::abs(angle) < 0.05) return "in its direction";
  if (std::abs(angle) > 179.95) return "against its direction";
  return fmt::format("{:.1f} degrees {} of its direction", std::abs(angle), angle > 0 ? "left" : "right");
}

std::string_view way_of(Link link) { return is_along_p(link) ? "V to A" : "V to B"; }

}  // namespace

Feel feel_over(const CopyingLinkage& linkage, const LinkStyle& style, const JointHardware& hardware,
               const Material& material, const Load& load, const OpeningInterval& openings) {
  const PinFriction friction(load.friction, style, hardware);
  const auto points = mass_points(linkage, {style, material.density, load.pen_mass, load.tracer_mass});
  const MassMoments moments = mass_moments(linkage, points);
  const auto share = [&](double opening) { return friction_share(linkage, opening, friction); };
  const auto most = [&](double opening) { return masses_at(linkage, points, opening).most; };
  const auto least = [&](double opening) { return -masses_at(linkage, points, opening).least; };
  const auto weight = [&](double opening) { return weight_at(linkage, moments, opening, load.tilt); };
  const HandWork work(linkage, style, hardware, material, load);
  const auto hand = [&](double opening) { return hand_at(linkage, work, moments, opening, load.tilt); };
  const double most_friction = top_over(openings, share), most_weight = top_over(openings, weight);
  Feel feel{.friction_share = share(most_friction),
            .without_lock = openings_without_lock(linkage, openings, friction),
            .mass_most = most(top_over(openings, most)),
            .mass_least = -least(top_over(openings, least)),
            .counterweights = counterweights(linkage, moments)};
  for (const double opening : std::set{most_friction, most_weight, openings.lower, openings.upper})
    feel.hand_most = std::max(feel.hand_most, hand(opening));
  if (!(load.tilt > 0)) return feel;
  feel.weight_most = weight(most_weight);
  feel.springs = balance_springs(linkage, moments, load.tilt);
  return feel;
}

std::string words(const Counterweight& weight) {
  return fmt::format("{:.3g} kg on {}, {:.4g} mm from {}, {} ({})", weight.mass, name(weight.link),
                     weight.arm, letter(weight.joint), direction_words(weight.direction),
                     way_of(weight.link));
}

std::string words(const BalanceSpring& spring) {
  return fmt::format("{:.3g} N/mm from {:.4g} mm uphill of the pole to {}, {:.4g} mm from the pole, {} ({})",
                     spring.rate, spring.height, name(spring.link), spring.arm,
                     direction_words(spring.direction), way_of(spring.link));
}

}  // namespace kempe
