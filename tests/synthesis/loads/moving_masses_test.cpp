// Balance and felt mass against sums over many small masses along the drawn links, moved by poses alone.
#include "synthesis/loads/moving_masses.hpp"

#include <gtest/gtest.h>

#include "kinematics/links.hpp"
#include "tests/random.hpp"
#include "tests/samples.hpp"

namespace kempe {
namespace {

using test::uniform;

struct MassCase {
  CopyingLinkage linkage;
  MovingMasses masses;
};

MassCase random_masses(std::mt19937_64& random) {
  for (;;) {
    const double rotation = uniform(random, 0, 4) < 1 ? pi : uniform(random, -pi, pi);
    const Complex k = copy_ratio(std::exp(uniform(random, -1, 1)), rotation);
    if (std::abs(k - 1.0) < 0.2) continue;
    const Grounding grounding = all_groundings[static_cast<std::size_t>(uniform(random, 0, 3))];
    const auto modes = assembly_modes(shape_of(k, grounding));
    const auto mode = static_cast<int>(uniform(random, 0, static_cast<double>(modes.size())));
    if (modes[static_cast<std::size_t>(mode)].openings.width() < 0.5) continue;
    const auto linkage = CopyingLinkage::make(k, grounding, uniform(random, 60, 300),
                                              uniform(random, 60, 300), mode, {30, -20});
    MovingMasses masses{.style = {.width = uniform(random, 8, 20), .thickness = uniform(random, 2, 8)},
                        .density = uniform(random, 500, 8000),
                        .pen = uniform(random, 0, 3),
                        .tracer = uniform(random, 0, 1)};
    if (uniform(random, 0, 1) < 0.3) masses.style.plate = PlateStyle::triangle;
    return {*linkage, masses};
  }
}

Pose random_pose(const CopyingLinkage& linkage, std::mt19937_64& random) {
  const OpeningInterval& openings = linkage.assembly_mode().openings;
  const double opening = openings.lower + uniform(random, 0.15, 0.85) * openings.width();
  return linkage.pose_at(opening, uniform(random, -pi, pi));
}

/// Small masses all over the links in a pose: kg and place, always in the same order.
struct Grain {
  double mass;
  Point place;
};
class Grains {
 public:
  Grains(const MassCase& one, const Pose& pose) : one_(one), pose_(pose) {
    line(Joint::V, Joint::A);
    line(Joint::V, Joint::B);
    plate(Joint::A, Joint::X);
    plate(Joint::B, Joint::Y);
    for (const Joint end : {Joint::V, Joint::A, Joint::V, Joint::B}) disc(end, 0.5);
    all_.push_back({one.masses.pen, pose[one.linkage.pen_joint()]});
    all_.push_back({one.masses.tracer, pose[one.linkage.tracer_joint()]});
  }
  const std::vector<Grain>& all() const { return all_; }

 private:
  double each_mm2() const { return one_.masses.density * 1e-9 * one_.masses.style.thickness; }

  void line(Joint from, Joint to, double share_of_width = 1) {
    constexpr int pieces = 2000;
    const Point way = pose_[to] - pose_[from];
    for (int i = 0; i < pieces; ++i)
      all_.push_back({each_mm2() * share_of_width * one_.masses.style.width * way.norm() / pieces,
                      pose_[from] + (i + 0.5) / pieces * way});
  }
  void disc(Joint at, double share) {
    const double width = one_.masses.style.width;
    all_.push_back({each_mm2() * share * pi * width * width / 4, pose_[at]});
  }
  void plate(Joint corner, Joint end) {
    const Point a = pose_[Joint::C] - pose_[corner], b = pose_[end] - pose_[corner];
    const double inside = 0.5 * std::abs(cross(a, b));
    if (inside < 1e-6 * a.norm() * b.norm()) return straight({corner, Joint::C, end});
    if (one_.masses.style.plate == PlateStyle::triangle) return triangle(corner, end, inside);
    line(corner, Joint::C);
    line(corner, end);
    disc(Joint::C, 0.5);
    disc(end, 0.5);
  }
  void straight(std::vector<Joint> joints) {
    const Point along = pose_[joints[1]] - pose_[joints[0]];
    std::sort(joints.begin(), joints.end(),
              [&](Joint a, Joint b) { return along.dot(pose_[a]) < along.dot(pose_[b]); });
    line(joints[0], joints[2]);
    disc(joints[0], 0.5);
    disc(joints[2], 0.5);
  }
  void triangle(Joint corner, Joint end, double inside) {
    constexpr int n = 60;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j + i < n; ++j)
        for (const double third : {1.0 / 3, 2.0 / 3}) {
          if (third > 0.5 && i + j + 1 >= n) continue;
          const double u = (i + third) / n, v = (j + third) / n;
          all_.push_back(
              {each_mm2() * inside / (n * n),
               pose_[corner] + u * (pose_[Joint::C] - pose_[corner]) + v * (pose_[end] - pose_[corner])});
        }
    for (const auto& [from, to] : {std::pair(corner, Joint::C), {Joint::C, end}, {end, corner}}) {
      line(from, to, 0.5);
      disc(from, 1.0 / 3);
    }
  }

  const MassCase& one_;
  const Pose& pose_;
  std::vector<Grain> all_;
};

/// kg mm: sum of mass times height.
double height_moment(const MassCase& one, const Pose& pose) {
  double sum = 0;
  const Grains grains(one, pose);
  for (const Grain& grain : grains.all()) sum += grain.mass * grain.place.y();
  return sum;
}

TEST(MovingMasses, TheHandHoldsTheSlopeOfThePotential) {
  std::mt19937_64 random(11);
  for (int i = 0; i < test::samples(40); ++i) {
    SCOPED_TRACE(i);
    const MassCase one = random_masses(random);
    const Pose pose = random_pose(one.linkage, random);
    const double tilt = uniform(random, 0.1, pi / 2), step = 1e-3;
    const auto moments = mass_moments(one.linkage, mass_points(one.linkage, one.masses));
    const auto force = hand_force_of_weight(one.linkage, moments, pose, tilt);
    ASSERT_TRUE(force);
    const Point tracer = pose[one.linkage.tracer_joint()];
    for (const Point& way : {Point(1, 0), Point(0, 1)}) {
      const auto up = one.linkage.pose_with_tracer_at(tracer + step * way),
                 down = one.linkage.pose_with_tracer_at(tracer - step * way);
      ASSERT_TRUE(up && down);
      const double slope = (height_moment(one, *up) - height_moment(one, *down)) / (2 * step);
      EXPECT_NEAR(force->dot(way), 9.80665 * std::sin(tilt) * slope, 1e-4 * (1 + force->norm()));
    }
  }
}

TEST(MovingMasses, CounterweightsBalanceEveryPose) {
  std::mt19937_64 random(12);
  for (int i = 0; i < test::samples(40); ++i) {
    SCOPED_TRACE(i);
    const MassCase one = random_masses(random);
    const auto weights =
        counterweights(one.linkage, mass_moments(one.linkage, mass_points(one.linkage, one.masses)));
    EXPECT_GT(weights[0].mass + weights[1].mass, 0);
    std::vector<double> heights;
    for (int j = 0; j < 6; ++j) {
      const Pose pose = random_pose(one.linkage, random);
      double height = height_moment(one, pose);
      for (const Counterweight& weight : weights) {
        const Complex side = as_complex(is_along_p(weight.link) ? pose.A - pose.V : pose.B - pose.V);
        const Complex place =
            as_complex(pose[weight.joint]) + weight.arm * weight.direction * side / std::abs(side);
        height += weight.mass * place.imag();
      }
      heights.push_back(height);
    }
    for (const double height : heights) EXPECT_NEAR(height, heights[0], 1e-6 * (1 + std::abs(heights[0])));
  }
}

TEST(MovingMasses, SpringsBalanceALinkageWithItsPoleAtTheVertex) {
  std::mt19937_64 random(13);
  int found = 0;
  for (int i = 0; i < test::samples(60); ++i) {
    const MassCase one = random_masses(random);
    const double tilt = uniform(random, 0.1, pi / 2);
    const auto springs =
        balance_springs(one.linkage, mass_moments(one.linkage, mass_points(one.linkage, one.masses)), tilt);
    EXPECT_EQ(springs.has_value(), one.linkage.grounding() == Grounding::pole);
    if (!springs) continue;
    ++found;
    std::vector<double> energies;
    for (int j = 0; j < 5; ++j) {
      const Pose pose = random_pose(one.linkage, random);
      double energy = 9.80665 * std::sin(tilt) * height_moment(one, pose);
      for (const BalanceSpring& spring : *springs) {
        const Complex side = as_complex(spring.link == Link::VA ? pose.A - pose.V : pose.B - pose.V);
        const Point end =
            one.linkage.pole() + as_point(spring.arm * spring.direction * side / std::abs(side));
        energy += 0.5 * spring.rate * (end - one.linkage.pole() - Point(0, spring.height)).squaredNorm();
      }
      energies.push_back(energy);
    }
    for (const double energy : energies) EXPECT_NEAR(energy, energies[0], 1e-6 * (1 + std::abs(energies[0])));
  }
  EXPECT_GT(found, test::expected(8));
}

TEST(MovingMasses, TheMassFeltIsThatOfTheKineticEnergy) {
  std::mt19937_64 random(14);
  for (int i = 0; i < test::samples(30); ++i) {
    SCOPED_TRACE(i);
    const MassCase one = random_masses(random);
    const Pose pose = random_pose(one.linkage, random);
    const auto felt = mass_felt(one.linkage, mass_points(one.linkage, one.masses), pose);
    ASSERT_TRUE(felt);
    const Point way = as_point(std::polar(1.0, uniform(random, -pi, pi)));
    const double step = 1e-3;
    const Point tracer = pose[one.linkage.tracer_joint()];
    const auto on = one.linkage.pose_with_tracer_at(tracer + step * way),
               back = one.linkage.pose_with_tracer_at(tracer - step * way);
    ASSERT_TRUE(on && back);
    const Grains after(one, *on), before(one, *back);
    double twice_energy = 0;
    for (std::size_t j = 0; j < after.all().size(); ++j)
      twice_energy +=
          after.all()[j].mass * ((after.all()[j].place - before.all()[j].place) / (2 * step)).squaredNorm();
    EXPECT_NEAR(way.dot(*felt * way), twice_energy, 1e-4 * twice_energy);
  }
}

}  // namespace
}  // namespace kempe
