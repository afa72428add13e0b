#pragma once
// A law: a claim that RapidCheck tries on random cases and shrinks to a small counterexample where it fails.
//
// The seed is fixed, so that every run tries the same cases; KEMPE_LAW_SEED sets another.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "kinematics/copying_linkage.hpp"
#include "tests/samples.hpp"
#include "workspace/parts.hpp"

namespace kempe::laws {

/// no: where a case takes seconds, and a smaller one would take minutes to find
enum class Shrink { yes, no };

/// Tries the claim, a function of nothing that draws its case with `*generator`, on so many cases.
template <class Claim>
void law(int cases, Claim claim, Shrink shrink = Shrink::yes) {
  rc::detail::TestParams params;
  const char* seed = std::getenv("KEMPE_LAW_SEED");
  params.seed = seed == nullptr ? 8 : std::strtoull(seed, nullptr, 10);
  params.maxSuccess = test::samples(cases);
  params.maxDiscardRatio = 50;
  params.disableShrinking = shrink == Shrink::no;
  const auto result = rc::detail::checkTestable(claim, rc::detail::TestMetadata{}, params);
  if (result.template is<rc::detail::SuccessResult>()) return;
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  FAIL() << message.str();
}

/// A number of [lower, upper], all equally likely (RapidCheck's own ranges begin small); shrinks towards lower.
inline rc::Gen<double> between(double lower, double upper) {
  constexpr int steps = 1 << 24;
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, steps + 1)),
                      [=](int step) { return lower + (upper - lower) * step / steps; });
}

/// A whole number of [lower, upper), all equally likely.
inline rc::Gen<int> whole(int lower, int upper) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(lower, upper));
}

inline rc::Gen<double> logarithmic(double lower, double upper) {
  return rc::gen::map(between(std::log(lower), std::log(upper)), [](double x) { return std::exp(x); });
}

/// Any angle; every other time one of the special ones.
inline rc::Gen<double> angle() {
  return rc::gen::oneOf(between(-pi, pi), rc::gen::element(0.0, pi / 2, pi, -pi / 2, pi / 4, -pi / 3));
}

inline rc::Gen<Point> point(double reach) {
  return rc::gen::apply([](double x, double y) { return Point(x, y); }, between(-reach, reach),
                        between(-reach, reach));
}

inline rc::Gen<PlateStyle> plate_style() { return rc::gen::element(PlateStyle::bent, PlateStyle::triangle); }

/// Any copying linkage: ratio 1:20 to 20:1 (or 1:`steep` to `steep`:1), any rotation, grounding and assembly mode, bars up to
/// `uneven` to 1.
inline CopyingLinkage draw_linkage(double uneven = 200, double steep = 20) {
  const Complex k = copy_ratio(*logarithmic(1 / steep, steep), *angle());
  RC_PRE(std::abs(k - 1.0) > 1e-3);
  const Grounding grounding =
      *rc::gen::elementOf(std::vector<Grounding>(all_groundings.begin(), all_groundings.end()));
  const auto count = static_cast<int>(assembly_modes(shape_of(k, grounding)).size());
  const double VA = *logarithmic(20, 400), VB = VA * *logarithmic(1 / uneven, uneven);
  const auto made = CopyingLinkage::make(k, grounding, VA, VB, *whole(0, count), *point(300));
  RC_ASSERT(made.has_value());
  return *made;
}

/// An opening inside the assembly mode, away from its ends by a share of its width.
inline double draw_opening(const CopyingLinkage& linkage, double margin = 0.02) {
  const OpeningInterval d = linkage.assembly_mode().openings;
  return d.lower + d.width() * *between(margin, 1 - margin);
}

inline LinkStyle draw_style() {
  const double width = *between(2, 20);
  return {width, width * *between(0.2, 1), 4, *plate_style()};
}

inline LayerAssignment draw_layers() { return *rc::gen::elementOf(layer_assignments(*whole(2, 5))); }

}  // namespace kempe::laws
