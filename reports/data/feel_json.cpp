#include "reports/data/feel_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "geometry/complex_vectors.hpp"
#include "geometry/fixed_text.hpp"
#include "kinematics/grounding.hpp"
#include "synthesis/loads/feel.hpp"
#include "workspace/reach.hpp"

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;

Json figure(double value) { return std::isfinite(value) ? Json(with_digits(value, 9)) : Json(); }
Json direction(Complex way) { return figure(degrees(std::arg(way)) + 0.0); }  // + 0: no minus before zero

}  // namespace

std::optional<Json> feel_values(const Design& design) {
  const auto openings = openings_over(design.linkage, design.region);
  if (!design.material || !design.load || !openings) return std::nullopt;
  const Feel feel =
      feel_over(design.linkage, design.style, design.hardware, *design.material, *design.load, *openings);
  Json weights = Json::array(), springs;
  for (const Counterweight& one : feel.counterweights)
    weights.push_back({{"link", name(one.link)},
                       {"from", std::string(1, letter(one.joint))},
                       {"arm_mm", figure(one.arm)},
                       {"mass_kg", figure(one.mass)},
                       {"direction_deg", direction(one.direction)}});
  if (feel.springs)
    for (const BalanceSpring& one : *feel.springs)
      springs.push_back({{"link", name(one.link)},
                         {"arm_mm", figure(one.arm)},
                         {"height_mm", figure(one.height)},
                         {"rate_N_mm", figure(one.rate)},
                         {"direction_deg", direction(one.direction)}});
  return Json{{"mass_min_kg", figure(feel.mass_least)},
              {"mass_max_kg", figure(feel.mass_most)},
              {"friction_share", figure(feel.friction_share)},
              {"hand_max_N", figure(feel.hand_most)},
              {"weight_max_N", figure(feel.weight_most)},
              {"counterweights", std::move(weights)},
              {"springs", std::move(springs)}};
}

}  // namespace kempe
