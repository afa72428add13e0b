// Pins' forces beside the middles of their links: the closed form against a frame in space that shares no formula with it
// (synthesis/verification/space_frame.hpp).
#include "synthesis/loads/layer_offsets.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cstdio>

#include "geometry/chance.hpp"
#include "synthesis/loads/hand_work.hpp"
#include "synthesis/loads/pin_compliance.hpp"
#include "synthesis/verification/space_frame.hpp"
#include "tests/samples.hpp"

namespace kempe {
namespace {

struct Instrument {
  CopyingLinkage linkage;
  SagConditions conditions;
};

/// Of any grounding, straight or bent, in three layers.
Instrument random_instrument(Chance& chance) {
  while (true) {
    const double rotation =
        chance.share() < 0.3 ? (chance.share() < 0.5 ? 0 : pi) : chance.uniform(radians(20), radians(160));
    const Complex k = copy_ratio(std::exp(chance.uniform(-1, 1)), rotation);
    if (std::abs(k - 1.0) < 0.3) continue;
    const Grounding grounding = all_groundings[static_cast<std::size_t>(3 * chance.share())];
    const auto modes = assembly_modes(shape_of(k, grounding));
    const auto& mode = modes[static_cast<std::size_t>(static_cast<double>(modes.size()) * chance.share())];
    if (mode.openings.width() < 1) continue;
    const auto linkage =
        CopyingLinkage::make(k, grounding, chance.uniform(60, 300), chance.uniform(60, 300), mode.number);
    if (!linkage) continue;
    const auto assignments = layer_assignments(3);
    SagConditions conditions{
        .layers =
            assignments[static_cast<std::size_t>(static_cast<double>(assignments.size()) * chance.share())],
        .E = std::exp(chance.uniform(std::log(3e3), std::log(200e3))),
        .density = 1000,
        .grip = 5};
    conditions.style.width = chance.uniform(10, 30);
    conditions.style.pin_diameter = chance.uniform(4, 9);
    conditions.style.thickness = chance.uniform(3, 10);
    conditions.G = conditions.E / chance.uniform(2, 3);
    conditions.tracer_rests = chance.share() < 0.3;
    conditions.pen_rests = chance.share() < 0.3;
    if (chance.share() < 0.3) conditions.hardware.at[static_cast<std::size_t>(Joint::A)] = "M4 bolt";
    return {*linkage, conditions};
  }
}

SpaceFrameParts parts_of(const Instrument& instrument) {
  const SagConditions& made = instrument.conditions;
  return {.straight = is_straight(instrument.linkage.shape()),
          .style = made.style,
          .hardware = made.hardware,
          .layers = made.layers,
          .E = made.E,
          .G = made.G};
}

TEST(LayerOffsets, AgreeWithAFrameInSpace) {
  Chance chance(61);
  double in_plane = 0, rise = 0, part = 0, drawn = 0;
  for (int i = 0; i < test::samples(60); ++i) {
    SCOPED_TRACE(i);
    const Instrument instrument = random_instrument(chance);
    const auto& [linkage, conditions] = instrument;
    const LinkStyle& style = conditions.style;
    const Complex k = linkage.k();
    const Grounding grounding = linkage.grounding();
    const OpeningInterval& openings = linkage.assembly_mode().openings;
    const double opening = chance.uniform(openings.lower + 0.4, openings.upper - 0.4), E = conditions.E;
    const LayeredErrorProfile profile(k, grounding, conditions, 1);
    const BarLengths lengths{linkage.VA(), linkage.VB()};
    const SagAt sag = SagProfile(k, grounding, conditions).at(lengths.VA, lengths.VB, opening);
    const Point VA = linkage.pose_at(opening, 0).A - linkage.pose_at(opening, 0).V;
    const auto frame =
        space_frame_response(linkage.pose_at(opening, -std::atan2(VA.y(), VA.x())), roles_of(grounding),
                             parts_of(instrument), sag.tracer_bears > 0, sag.pen_bears > 0);
    const Eigen::Matrix2d closed = profile.compliance(lengths, opening);
    in_plane = std::max(in_plane, (closed - frame.in_plane).norm() / frame.in_plane.norm());
    const LayeredErrorAt stated = profile.at(lengths, opening);
    EXPECT_NEAR(stated.in_plane, frame.give(), 1e-6 * frame.give());
    rise = std::max(rise, std::abs(stated.rise - frame.rise()) / std::max(frame.rise(), 1e-6 * frame.give()));
    const double links =
        LoadErrorProfile(k, grounding, style, {"", E, 1000, 0}, 1).at(lengths, opening).worst;
    part = std::max(part, profile.at(lengths, opening).in_plane / links - 1);
    // A pen that drags gives way as the frame does, whichever way the linkage lies.
    const Pose pose = linkage.pose_at(opening, chance.uniform(-pi, pi));
    const Point heading = as_point(std::polar(1.0, chance.uniform(-pi, pi)));
    const auto work = HandWork(linkage, style, {}, {"", E, 1000, 1}, {.pen_force = 1}, {},
                               LayeredErrorProfile(k, grounding, conditions, 1))
                          .at(pose, heading);
    ASSERT_TRUE(work);
    EXPECT_TRUE(work->counts_layers);
    const Point along = (pose.A - pose.V).normalized();
    Eigen::Matrix2d turn;
    turn << along.x(), -along.y(), along.y(), along.x();
    const Point seen = turn * frame.in_plane * turn.transpose() * work->pen_force;
    drawn = std::max(drawn, (work->give - seen).norm() / frame.in_plane.norm());
  }
  EXPECT_LT(in_plane, 1e-6);
  EXPECT_LT(rise, 1e-6);
  EXPECT_LT(drawn, 1e-6);
  EXPECT_GT(part, 0.05);
  std::printf(
      "largest relative differences: in the plane %.2g, rise %.2g; pins and layers add up to %.3g of the "
      "links\n",
      in_plane, rise, part);
}

/// Over a region's openings: also of instruments that the weights lift off the table at some of them.
TEST(LayerOffsets, AreTheMostThatTheFrameSeesOverOpenings) {
  Chance chance(62);
  double missed = 0;
  int lifted = 0;
  for (int i = 0; i < test::samples(30); ++i) {
    SCOPED_TRACE(i);
    Instrument instrument = random_instrument(chance);
    auto& [linkage, conditions] = instrument;
    conditions.tracer_rests = conditions.pen_rests = true;
    conditions.pen_mass = chance.uniform(0, 3);
    const OpeningInterval& all = linkage.assembly_mode().openings;
    const OpeningInterval openings{all.lower + 0.2, all.upper - 0.2};
    const BarLengths lengths{linkage.VA(), linkage.VB()};
    const auto stated =
        LayeredErrorProfile(linkage.k(), linkage.grounding(), conditions, 1).over(lengths, openings);
    ASSERT_TRUE(stated);
    const auto stretches =
        SagProfile(linkage.k(), linkage.grounding(), conditions).stretches(lengths.VA, lengths.VB, openings);
    if (stretches.size() > 1) ++lifted;
    LayeredFigures seen;
    for (const SupportedStretch& stretch : stretches)
      for (int j = 0; j <= 100; ++j) {
        const double opening = stretch.openings.lower + stretch.openings.width() * j / 100;
        const auto frame =
            space_frame_response(linkage.pose_at(opening, 0), roles_of(linkage.grounding()),
                                 parts_of(instrument), stretch.tracer_bears, stretch.pen_bears);
        seen.error_max = std::max(seen.error_max, frame.give());
        seen.rise_max = std::max(seen.rise_max, frame.rise());
      }
    missed = std::max({missed, std::abs(stated->error_max / seen.error_max - 1),
                       std::abs(stated->rise_max - seen.rise_max) / std::max(seen.rise_max, 1e-9)});
  }
  EXPECT_LT(missed, 1e-4);
  std::printf("largest relative difference %.2g; %d are lifted off the table somewhere\n", missed, lifted);
}

/// How much further two instruments of bricks give way once their plates may leave the plane (bench/solids.py, docs/loads.md), shear taken off.
TEST(LayerOffsets, AddWhatSolidElementsFind) {
  const auto more = [](Complex k, Grounding grounding, const BarLengths& lengths, double opening,
                       const LinkStyle& style, double E) {
    SagConditions conditions{.style = style, .E = E, .G = E / 2.6, .density = 1000, .grip = style.thickness};
    conditions.layers = {{1, 2, 2, 1}};
    const Eigen::Matrix2d all = LayeredErrorProfile(k, grounding, conditions, 1).compliance(lengths, opening);
    const LoadErrorAt links = LoadErrorProfile(k, grounding, style, {"", E, 1000, 1}, 1).at(lengths, opening);
    const Eigen::Vector2d ends = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(all).eigenvalues();
    return std::pair(ends[1] / links.worst - 1, ends[0] / links.least - 1);
  };
  const auto steel = more(0.4, Grounding::pen, {91.784, 76.542}, radians(90),
                          {.width = 15, .pin_diameter = 8, .thickness = 5}, 200e3);
  EXPECT_NEAR(steel.first, 0.097 - 0.014, 0.01);
  EXPECT_NEAR(steel.second, 0.185 - 0.042, 0.01);
  const auto PLA = more(-0.5, Grounding::pole, {150, 110}, radians(60),
                        {.width = 20, .pin_diameter = 8, .thickness = 8}, 3e3);
  EXPECT_NEAR(PLA.first, 0.080 - 0.014, 0.01);
  EXPECT_NEAR(PLA.second, 0.142 - 0.025, 0.01);
}

}  // namespace
}  // namespace kempe
