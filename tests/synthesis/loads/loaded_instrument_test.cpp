// Where a loaded instrument draws: every link is bent by the forces that its balance gives, arm by arm as a cantilever, and the loops of the
// bent links are closed numerically. No energy and no compliance of the library is used.
#include <gtest/gtest.h>

#include <functional>

#include "kinematics/instrument.hpp"
#include "synthesis/loads/hand_work.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "tests/samples.hpp"
#include "tests/synthesis/loads/free_links.hpp"

namespace kempe {
namespace {

using namespace free_links;

const LinkStyle style{.width = 15, .pin_diameter = 6, .thickness = 5};
const Material tool_steel{"steel", 200e3, 7850, 235};

/// A joint and the force there.
struct Pushed {
  Joint joint;
  Complex force;
};

/// Where three joints of a plate are when the arms from the middle one bend; that one stays.
std::array<Complex, 3> bent_joints(const std::array<Pushed, 3>& joints, const Pose& pose,
                                   std::size_t middle) {
  std::array<Complex, 3> places{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Complex at = as_complex(pose[joints[i].joint]), arm = at - as_complex(pose[joints[middle].joint]);
    places[i] = at;
    if (i == middle) continue;
    const double length = std::abs(arm);
    const Complex turned = joints[i].force * std::conj(arm) / length;
    const double along = turned.real() * length / (tool_steel.E * style.width * style.thickness),
                 across = turned.imag() * std::pow(length, 3) /
                          (3 * tool_steel.E * style.thickness * std::pow(style.width, 3) / 12);
    places[i] += Complex(along, across) * arm / length;
  }
  return places;
}

/// The corner of a bent plate (the first joint); of a straight one the joint between the others.
std::size_t middle_of(const std::array<Pushed, 3>& joints, const Pose& pose) {
  const Point a = pose[joints[1].joint] - pose[joints[0].joint],
              b = pose[joints[2].joint] - pose[joints[0].joint];
  if (std::abs(cross(a, b)) > 1e-6 * a.norm() * b.norm() || a.dot(b) < 0) return 0;
  return a.norm() < b.norm() ? 1 : 2;
}

double stretch(const Pose& pose, Joint from, Joint to, Complex force_at_end) {
  const Complex bar = as_complex(pose[to] - pose[from]);
  return (force_at_end * std::conj(bar)).real() / (tool_steel.E * style.width * style.thickness);
}

/// The measures of an instrument whose links are bent by a force on the pen.
Measures bent_measures(const CopyingLinkage& linkage, const Pose& pose, const Point& pen_force) {
  const FreeLinks links(linkage, pose, pen_force);
  const Balance balance = links.solve({});
  const auto force_on = [&](int link, Joint joint) {
    Complex sum = 0;
    for (std::size_t i = 0; i < links.pins.size(); ++i) {
      if (links.pins[i].joint != joint) continue;
      if (links.pins[i].link == link) sum += as_complex(balance.pins[i]);
      if (links.pins[i].other == link) sum -= as_complex(balance.pins[i]);
    }
    if (joint == linkage.tracer_joint() && link == link_with(joint)) sum += as_complex(balance.hand);
    if (joint == linkage.pen_joint() && link == link_with(joint)) sum += as_complex(pen_force);
    return sum;
  };
  const auto plate = [&](int link, Joint corner, Joint end) {
    const std::array<Pushed, 3> joints{
        {{corner, force_on(link, corner)}, {Joint::C, force_on(link, Joint::C)}, {end, force_on(link, end)}}};
    const std::size_t middle = middle_of(joints, pose);
    const auto places = bent_joints(joints, pose, middle);
    const Complex to_end = places[2] - places[1];
    return std::pair(std::abs(to_end), (places[0] - places[1]) * std::conj(to_end) / std::abs(to_end));
  };
  Measures measures = instrument_of(linkage).drawn;
  measures[index_of(Measure::VA)] += stretch(pose, Joint::V, Joint::A, force_on(VA, Joint::A));
  measures[index_of(Measure::VB)] += stretch(pose, Joint::V, Joint::B, force_on(VB, Joint::B));
  const auto [CX, A] = plate(ACX, Joint::A, Joint::X);
  measures[index_of(Measure::CX)] = CX;
  measures[index_of(Measure::AX)] = CX - A.real();
  measures[index_of(Measure::offset_A)] = A.imag();
  const auto [CY, B] = plate(BCY, Joint::B, Joint::Y);
  measures[index_of(Measure::CY)] = CY;
  measures[index_of(Measure::BC)] = B.real();
  measures[index_of(Measure::offset_B)] = B.imag();
  return measures;
}

/// A plate with its three lengths off: corner at `corner` seen from C, end on the axis at `end`.
std::pair<double, Complex> wrong_plate(double end, Complex corner, const std::function<double()>& error) {
  const double to_corner = std::abs(corner) + error(), between = std::abs(corner - end) + error();
  const double to_end = end + error();
  const double along = (to_corner * to_corner + to_end * to_end - between * between) / (2 * to_end);
  return {to_end, {along, std::copysign(std::sqrt(to_corner * to_corner - along * along), corner.imag())}};
}

/// All eight lengths off.
void make_wrong(Measures& measures, const std::function<double()>& error) {
  const auto at = [&](Measure measure) -> double& { return measures[index_of(measure)]; };
  at(Measure::VA) += error();
  at(Measure::VB) += error();
  const auto [CX, A] =
      wrong_plate(at(Measure::CX), {at(Measure::CX) - at(Measure::AX), at(Measure::offset_A)}, error);
  at(Measure::CX) = CX;
  at(Measure::AX) = CX - A.real();
  at(Measure::offset_A) = A.imag();
  const auto [CY, B] = wrong_plate(at(Measure::CY), {at(Measure::BC), at(Measure::offset_B)}, error);
  at(Measure::CY) = CY;
  at(Measure::BC) = B.real();
  at(Measure::offset_B) = B.imag();
}

struct PushedCase {
  CopyingLinkage linkage;
  double opening;
  Pose pose;
  Point heading;
};
PushedCase random_loaded(std::mt19937_64& random) {
  const CopyingLinkage linkage = random_linkage(random);
  const OpeningInterval openings = shrink(linkage.assembly_mode().openings, 0.3);
  const double opening = openings.lower + uniform(random, 0, 1) * openings.width();
  return {linkage, opening, linkage.pose_at(opening, uniform(random, -pi, pi)),
          as_point(std::polar(1.0, uniform(random, -pi, pi)))};
}

TEST(LoadedInstrument, GivesWayAsItsBentLinksClose) {
  std::mt19937_64 random(31);
  for (int i = 0; i < test::samples(300); ++i) {
    SCOPED_TRACE(i);
    const auto [linkage, opening, pose, heading] = random_loaded(random);
    const Load load{.pen_force = 0.1, .pen_mass = 0.02, .tilt = uniform(random, 0, 1.5)};
    const Material weightless{"", tool_steel.E, 0, 0};  // of the links' own weight: plane_weight_test.cpp
    const auto work = HandWork(linkage, style, {}, weightless, load).at(pose, heading);
    ASSERT_TRUE(work);
    const Point tracer = pose[linkage.tracer_joint()];
    const auto loaded =
        pose_of(instrument_of(linkage), bent_measures(linkage, pose, work->pen_force), tracer);
    ASSERT_TRUE(loaded);
    const Point moved = (*loaded)[linkage.pen_joint()] - pose[linkage.pen_joint()];
    EXPECT_LT((work->give - moved).norm(), 2e-3 * moved.norm() + 1e-9);
  }
}

/// What a pin's compliance adds: by virtual work each pin's give times its force under a unit force in the direction looked at. All forces
/// from the links drawn free.
TEST(LoadedInstrument, PinsGiveByTheForcesThatTheyBear) {
  std::mt19937_64 random(33);
  for (int i = 0; i < test::samples(100); ++i) {
    SCOPED_TRACE(i);
    const PushedCase one = random_loaded(random);
    const CopyingLinkage& linkage = one.linkage;
    const auto& pose = one.pose;
    const Point heading = one.heading;
    const PinCompliance pins{1e-3, 2e-3, 3e-3, 4e-3, 5e-3};
    const Load load{.pen_force = 10};
    const auto rigid = HandWork(linkage, style, {}, tool_steel, load).at(pose, heading);
    const auto soft = HandWork(linkage, style, {}, tool_steel, load, pins).at(pose, heading);
    ASSERT_TRUE(rigid && soft);
    const bool at_V = linkage.pole_joint() == Joint::V;
    const Balance loaded = FreeLinks(linkage, pose, rigid->pen_force).solve({});
    const auto give = [&](const Point& direction) {
      const Balance unit = FreeLinks(linkage, pose, direction).solve({});
      const auto of = [&](std::size_t pin) { return loaded.pins[pin].dot(unit.pins[pin]); };
      const Point post = at_V ? loaded.pins[3] + loaded.pins[4] : loaded.pins[4],
                  post_unit = at_V ? unit.pins[3] + unit.pins[4] : unit.pins[4];
      return pins.A * of(0) + pins.B * of(1) + pins.C * of(2) + pins.V * of(3) +
             pins.pole * post.dot(post_unit);
    };
    const Point more{give({1, 0}), give({0, 1})};
    EXPECT_LT((soft->give - rigid->give - more).norm(), 1e-9 * more.norm());
  }
}

TEST(LoadedInstrument, MadeAndLoadedItStaysWithinTheBudget) {
  std::mt19937_64 random(32);
  for (int i = 0; i < test::samples(300); ++i) {
    SCOPED_TRACE(i);
    const auto [linkage, opening, pose, heading] = random_loaded(random);
    if (is_flat(linkage.shape())) continue;  // a flat plate is toleranced by other lengths
    const double off = 0.01;
    const auto work = HandWork(linkage, style, {}, tool_steel, {.pen_force = 20}).at(pose, heading);
    ASSERT_TRUE(work);
    CopyTolerance tolerance;
    tolerance.length.fill(off);
    const double budget = copy_error_profile(linkage, tolerance).at(opening).worst +
                          LoadErrorProfile(linkage.k(), linkage.grounding(), style, tool_steel, 20)
                              .at({linkage.VA(), linkage.VB()}, opening)
                              .worst;
    Measures measures = bent_measures(linkage, pose, work->pen_force);
    make_wrong(measures, [&] { return uniform(random, -off, off); });
    const auto made = pose_of(instrument_of(linkage), measures, pose[linkage.tracer_joint()]);
    ASSERT_TRUE(made);
    EXPECT_LT(((*made)[linkage.pen_joint()] - pose[linkage.pen_joint()]).norm(), 1.02 * budget);
  }
}

}  // namespace
}  // namespace kempe
