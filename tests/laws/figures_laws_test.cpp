// Laws of every figure in design.json: what a turn, a shift, an enlargement or a mirror does to the task, it does to each
// figure as the unit in the figure's name says.
#include <nlohmann/json.hpp>

#include "reports/data/design_json.hpp"
#include "synthesis/design/assemble.hpp"
#include "synthesis/verification/verification.hpp"
#include "tests/laws/law.hpp"
#include "tests/laws/movement.hpp"
#include "workspace/reach.hpp"

namespace kempe::laws {
namespace {

using Json = nlohmann::json;

Ring rectangle(const Point& centre, double width, double height) {
  const Point across(width / 2, 0), up(0, height / 2);
  return {centre - across - up, centre + across - up, centre + across + up, centre - across + up};
}

/// A given mechanism with a small region somewhere in its reach, half the time with an obstacle not far away.
Spec draw_task() {
  const CopyingLinkage linkage = draw_linkage(5, 5);
  RC_PRE(std::abs(linkage.k() - 1.0) > 0.2);
  RC_PRE(linkage.assembly_mode().openings.width() > 0.3);
  Spec spec;
  spec.copy = Copy::of(linkage.k());
  spec.pole.place = linkage.pole();
  const double opening = draw_opening(linkage, 0.25);
  const Point centre = linkage.tracer_at(opening, *angle());
  const double room =
      0.2 * std::abs(linkage.radius_slope_at(opening)) * linkage.assembly_mode().openings.width();
  RC_PRE(room > 1);
  spec.region.polygons.push_back({rectangle(centre, room * *between(0.2, 1), room * *between(0.2, 1)), {}});
  spec.links.style = draw_style();
  spec.limits.clearance = *between(0, 2);
  spec.limits.transmission = radians(*between(0, 25));
  spec.tolerance = Tolerance{*between(0.01, 0.1), *between(0, 0.05)};
  if (*rc::gen::arbitrary<bool>()) {
    const double size = 0.2 * linkage.size();
    const Point at = linkage.pole() + *point(linkage.size());
    spec.obstacles.push_back({{rectangle(at, size, size / 3), {}}, 1, 2, "post"});
  }
  spec.mechanism = MechanismSpec{linkage.grounding(), linkage.VA(), linkage.VB(),
                                 linkage.assembly_mode().number, draw_layers().of};
  return spec;
}

Design design_of(const Spec& spec) {
  const MechanismSpec& given = *spec.mechanism;
  const auto linkage = CopyingLinkage::make(spec.copy.k(), given.grounding, given.VA, given.VB,
                                            given.assembly_mode, std::get<Point>(spec.pole.place));
  RC_ASSERT(linkage.has_value());
  Design design = assemble_given(spec, *linkage, {});
  design.verification = verify(verification_task(design), {.outline_samples = 60, .hatch_lines = 2});
  return design;
}

bool ends_with(const std::string& text, const std::string& end) { return text.ends_with(end); }

/// Compares two designs' files figure by figure.
class Comparison {
 public:
  Comparison(const Movement& movement, const Design& before, const Design& after)
      : movement_(movement), before_(Json::parse(design_json(before))),
        after_(Json::parse(design_json(after))) {
    size_ = before.quality.size;
  }

  void all_figures_follow() {
    lengths_and_areas("quality", before_["quality"], after_["quality"]);
    lengths_and_areas("mechanism", before_["mechanism"], after_["mechanism"]);
    lengths_and_areas("limits", before_["limits"], after_["limits"]);
    lengths_and_areas("tolerance", before_["tolerance"], after_["tolerance"]);
    mechanism();
    workspace();
    RC_ASSERT(before_["verification"]["certified"] == after_["verification"]["certified"]);
    RC_ASSERT(before_["verification"]["flips"] == after_["verification"]["flips"]);
    if (before_["verification"]["certified"])  // else the check ended where it first failed
      near("verification.scale", before_["verification"]["scale"], after_["verification"]["scale"], 1e-9);
    RC_ASSERT(before_["copy"]["scale"] == after_["copy"]["scale"]);
    angle_follows(before_["copy"]["rotation_deg"], after_["copy"]["rotation_deg"]);
  }

 private:
  static void near(const std::string& what, double wanted, double found, double tolerance) {
    if (std::abs(wanted - found) <= tolerance) return;
    std::ostringstream message;
    message.precision(17);
    message << what << ": wanted " << wanted << ", found " << found << ", allowed " << tolerance;
    RC_FAIL(message.str());
  }

  /// How far a figure may be off: rounding, or the figure's own stated accuracy.
  double accuracy(const std::string& path, double value) const {
    const double share = [&] {
      if (path == "quality.footprint_mm2") return 0.02;  // rings and bins of a grid about the pole
      // The similarity is fitted to places on a lattice along the longest edge: of equal ones, the first, which is another in a mirror.
      if (path == "quality.distortion_worst_mm") return movement_.mirror ? 0.1 : 1e-6;
      return 1e-7;
    }();
    // The gap to an obstacle is certified to 0.01 mm.
    const double own = path == "quality.clearance_min_mm" ? 0.011 * (1 + movement_.scale) : 0;
    return share * std::abs(value) + own + 1e-10 * size_ * movement_.scale;
  }

  void lengths_and_areas(const std::string& path, const Json& before, const Json& after) {
    if (before.is_object()) {
      RC_ASSERT(after.is_object() && before.size() == after.size());
      for (const auto& [key, value] : before.items())
        lengths_and_areas(path + "." + key, value, after.at(key));
      return;
    }
    RC_ASSERT(before.is_null() == after.is_null());
    if (!before.is_number()) return;
    const double value = before;
    if (path.find("lengths_mm.") != std::string::npos || ends_with(path, "_mm"))
      near(path, movement_.scale * value, after, accuracy(path, movement_.scale * value));
    else if (ends_with(path, "_mm2"))
      near(path, movement_.scale * movement_.scale * value, after,
           accuracy(path, movement_.scale * movement_.scale * value));
    else if (ends_with(path, "_min_deg") || path == "limits.transmission_deg")
      near(path, value, after, 1e-6);
  }

  void angle_follows(double before, double after) const {
    const double off = std::remainder((movement_.mirror ? -before : before) - after, 360);
    near("rotation", 0, off, 1e-9);
  }

  void mechanism() const {
    const Json &before = before_["mechanism"], &after = after_["mechanism"];
    for (const char* key : {"vertex", "pole", "tracer", "pen"}) RC_ASSERT(before[key] == after[key]);
    const Point stood(before["pole_position_mm"][0].get<double>(),
                      before["pole_position_mm"][1].get<double>());
    const Point pole = movement_(stood);
    near("pole x", pole.x(), after["pole_position_mm"][0], 1e-9 * (size_ + pole.norm()));
    near("pole y", pole.y(), after["pole_position_mm"][1], 1e-9 * (size_ + pole.norm()));
    const double hand = movement_.mirror ? -1 : 1;
    near("shape, real", before["shape"][0], after["shape"][0],
         1e-12 * (1 + std::abs(before["shape"][0].get<double>())));
    near("shape, imaginary", hand * before["shape"][1].get<double>(), after["shape"][1],
         1e-12 * (1 + std::abs(before["shape"][1].get<double>())));
    for (const auto& [key, sign] : before["orientation"].items())
      RC_ASSERT(static_cast<int>(hand) * sign.get<int>() == after["orientation"][key].get<int>());
    RC_ASSERT(before["opening_deg"].size() == after["opening_deg"].size());
    if (before["opening_deg"].size() != 2) return;
    const double lower = before["opening_deg"][0], upper = before["opening_deg"][1];
    if (lower > upper) return;  // empty
    near("opening, lower", movement_.mirror ? -upper : lower, after["opening_deg"][0], 1e-5);
    near("opening, upper", movement_.mirror ? -lower : upper, after["opening_deg"][1], 1e-5);
    RC_ASSERT(before["links"].size() == after["links"].size());
    for (std::size_t i = 0; i < before["links"].size(); ++i)
      RC_ASSERT(before["links"][i] == after["links"][i]);
  }

  void workspace() const {
    const Json &before = before_["workspace"], &after = after_["workspace"];
    const double square = movement_.scale * movement_.scale;
    for (const char* key : {"reachable_mm2", "usable_mm2"}) {
      const double wanted = square * before[key].get<double>();
      near(key, wanted, after[key], 1e-7 * wanted + 1e-9);
    }
    const double uncertain =
        square * before["uncertain_mm2"].get<double>() + after["uncertain_mm2"].get<double>();
    const double wanted = square * before["collision_free_mm2"].get<double>();
    near("collision_free_mm2", wanted, after["collision_free_mm2"], uncertain + 1e-7 * wanted + 1e-9);
  }

  Movement movement_;
  Json before_, after_;
  double size_;
};

void follows(const Movement& movement) {
  const Spec spec = draw_task();
  const Design before = design_of(spec), after = design_of(movement(spec));
  Comparison(movement, before, after).all_figures_follow();
  if (!before.map.coverage.uncertain && !after.map.coverage.uncertain)
    RC_ASSERT(before.map.coverage.covered == after.map.coverage.covered);
}

TEST(FigureLaws, AShiftLeavesEveryFigure) {
  law(
      40, [] { follows({.shift = *point(1000)}); }, Shrink::no);
}

TEST(FigureLaws, ATurnLeavesEveryFigure) {
  law(
      40, [] { follows({.turn = *angle(), .shift = *point(100)}); }, Shrink::no);
}

TEST(FigureLaws, AnEnlargementScalesEveryFigureByItsUnit) {
  law(
      40, [] { follows({.scale = *logarithmic(0.2, 5)}); }, Shrink::no);
}

TEST(FigureLaws, AMirrorLeavesEveryFigureAndTurnsEverySign) {
  law(
      40, [] { follows({.mirror = true}); }, Shrink::no);
}

}  // namespace
}  // namespace kempe::laws
