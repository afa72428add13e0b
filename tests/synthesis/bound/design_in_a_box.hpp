#pragma once
// Boxes round random designs under load, and what their designs have, for the tests of the bound.

#include <cmath>
#include <optional>
#include <vector>

#include "synthesis/bound/load_trade.hpp"
#include "synthesis/loads/load_error.hpp"
#include "tests/synthesis/bound/loaded_branch.hpp"

namespace kempe::test {

/// A design of a branch, two places that it reaches, and a box of designs round it.
struct DesignInABox {
  /// `wide`: of the box, as a share of lengths and distances.
  DesignInABox(const LoadedBranch& one, const DesignAtDistances& design, double wide, SpecDice& dice)
      : linkage(*design.linkage) {
    const auto round = [&](double value, double width) {
      const double below = width * dice.uniform(0, 1);
      return bounding::Range{value - below, value + width - below};
    };
    const auto ratio = [&](double value) {
      const double below = dice.uniform(0, 1);
      return bounding::Range{value / (1 + wide * below), value * (1 + wide * (1 - below))};
    };
    pole = Point(dice.uniform(-100, 100), dice.uniform(-100, 100));
    linkage = bounding::linkage_of(one.spec, one.branch, linkage.VA(), design.t * linkage.VA(), pole).value();
    const auto place = [&](double distance) {
      return Point(pole + as_point(std::polar(distance, dice.uniform(-pi, pi))));
    };
    const double farthest = design.distances.farthest_at_least;
    places = {place(design.distances.nearest_at_most), place(farthest), 1e-12 * (100 + farthest)};
    const double width = dice.one_in(3) ? 0 : wide * design.distances.nearest_at_most;
    box = {{ratio(design.t), ratio(design.w)}, round(pole.x(), width), round(pole.y(), width)};
    profile = load_error_profile(one.spec, one.spec.copy.k(), one.branch.mode.grounding);
  }

  CopyingLinkage linkage;
  Point pole;
  bounding::ReachedPlaces places;
  bounding::DesignRange box;
  std::optional<LoadErrorProfile> profile{};
};

/// What a design has with the tracer between two places: load error (mm), least transmission angle (rad); nothing if it does not reach them.
struct Given {
  double load, transmission, size;
};
inline std::optional<Given> given(const LoadErrorProfile& profile, const CopyingLinkage& linkage,
                                  const Point& pole, const bounding::ReachedPlaces& places) {
  const auto near = linkage.opening_at((places.near - pole).norm()),
             far = linkage.opening_at((places.far - pole).norm());
  if (!near || !far) return std::nullopt;
  Given least{0, HUGE_VAL, linkage.size()};
  for (const double opening : {*near, *far}) {
    least.load = std::max(least.load, profile.at({linkage.VA(), linkage.VB()}, opening).worst);
    least.transmission = std::min(least.transmission, linkage.transmission_angle(opening));
  }
  return least;
}

/// What is asked of the designs of a box.
struct Wanted {
  double load, transmission;
  std::optional<double> size;
  /// With `room`, a factor, designs that miss it by so much are better too.
  bool is_kept_by(const Given& has, double room = 1) const {
    return has.load <= load * room && has.transmission > transmission / room &&
           (!size || has.size < *size * room);
  }
};

/// A design of a box and what it has.
struct DesignInside {
  CopyingLinkage linkage;
  Given has;
};
inline std::vector<DesignInside> designs_in(const LoadedBranch& one, const DesignInABox& in, int count,
                                            SpecDice& dice) {
  std::vector<DesignInside> designs;
  const auto of = [&](const bounding::Range& range) { return dice.uniform(range.lower, range.upper); };
  for (int i = 0; i < count; ++i) {
    const double t = of(in.box.lengths.t), w = of(in.box.lengths.w);
    const Point pole(of(in.box.x), of(in.box.y));
    const auto linkage =
        bounding::linkage_of(one.spec, one.branch, std::sqrt(w / t / 2), std::sqrt(w * t / 2), pole);
    if (!linkage) continue;
    if (const auto has = given(*in.profile, *linkage, pole, in.places)) designs.push_back({*linkage, *has});
  }
  return designs;
}

}  // namespace kempe::test
