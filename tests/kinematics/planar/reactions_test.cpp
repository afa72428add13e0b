// Reactions against a textbook's equations for a four-bar, against the balance of every link and of all power, and their laws.
#include "kinematics/planar/reactions.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <complex>

#include "kinematics/overloaded.hpp"
#include "kinematics/planar/loads.hpp"
#include "kinematics/planar/path.hpp"
#include "kinematics/planar/rates.hpp"
#include "tests/kinematics/planar/random_linkages.hpp"
#include "tests/samples.hpp"

namespace kempe {
namespace {

using test::Random;

/// A linkage at one moment of its motion, with its loads and the reactions to them.
struct Moment {
  Moment(const PlanarLinkage& linkage, PlanarPath& path, const PlanarLoads& loads,
         const std::vector<double>& speeds, const std::vector<double>& accelerations)
      : position(path.position()), values(path.values()), rate(path.velocity(speeds)),
        second(path.acceleration(rate, speeds, accelerations)), applied(applied_forces(loads, position)),
        inertia(inertia_forces(loads, position, rate, second)) {
    ReactionSolver solver(linkage);
    reactions = solver.at(position, values, inertia - applied);
  }

  PlanarPosition position;
  std::vector<double> values;
  Eigen::VectorXd rate, second, applied, inertia;
  std::optional<std::vector<Reaction>> reactions;
};

/// F12, F32, F43, F14 (lb, by x and y) and T12 (lb in) of a four-bar by the nine equations of R. L. Norton, Design of Machinery, section
/// 11.4 (matrix method): for each moving link sum F = m a_G and sum M about its centre of mass = I alpha. Angles and rates of the links
/// are given; places and accelerations of the centres follow here from rigid bodies: G'' = (i alpha - omega^2) r.
Eigen::Vector<double, 9> by_nine_equations(const std::array<double, 3>& angle,
                                           const std::array<double, 3>& rate,
                                           const std::array<double, 3>& second) {
  using Complex = std::complex<double>;
  const Complex i(0, 1);
  const auto turned = [&](double r, double degrees_, std::size_t link) {
    return std::polar(r, radians(degrees_) + angle[link]);
  };
  const auto bends = [&](const Complex& r, std::size_t link) {
    return (i * second[link] - rate[link] * rate[link]) * r;
  };
  // Centres of mass and the joints seen from them: crank 2 from O2 to A, coupler 3 from A to B, rocker 4 from O4 to B.
  const std::array<Complex, 3> centre{turned(3, 30, 0), turned(9, 45, 1), turned(5, 0, 2)},
      whole{turned(5, 0, 0), turned(15, 0, 1), turned(10, 0, 2)};
  const std::array<Complex, 3> acceleration{bends(centre[0], 0), bends(whole[0], 0) + bends(centre[1], 1),
                                            bends(centre[2], 2)};
  constexpr std::array<double, 3> mass{0.004, 0.020, 0.015}, inertia{0.4, 1.5, 0.8};
  Eigen::Matrix<double, 9, 9> system = Eigen::Matrix<double, 9, 9>::Zero();
  Eigen::Vector<double, 9> right;
  // Force `column` acts on the link with this sign at `arm` from its centre.
  const auto act = [&](int link, int column, double sign, const Complex& arm) {
    system(3 * link, column) += sign;
    system(3 * link + 1, column + 1) += sign;
    system(3 * link + 2, column) -= sign * arm.imag();
    system(3 * link + 2, column + 1) += sign * arm.real();
  };
  act(0, 0, 1, -centre[0]);
  act(0, 2, 1, whole[0] - centre[0]);
  act(1, 2, -1, -centre[1]);
  act(1, 4, 1, whole[1] - centre[1]);
  act(2, 4, -1, whole[2] - centre[2]);
  act(2, 6, 1, -centre[2]);
  system(2, 8) = 1;
  for (int link = 0; link < 3; ++link) {
    const auto at = static_cast<std::size_t>(link);
    right.segment<3>(3 * link) << mass[at] * acceleration[at].real(), mass[at] * acceleration[at].imag(),
        inertia[at] * second[at];
  }
  const Complex push = std::polar(80.0, radians(330)), arm = turned(3, 100, 1);
  right.segment<3>(3) -= Eigen::Vector3d(push.real(), push.imag(), (std::conj(arm) * push).imag());
  right[8] -= 120;
  return system.partialPivLu().solve(right);
}

// The four-bar of R. L. Norton, Design of Machinery, example 11-3 and figure A-8: 19, 5, 15 and 10 in long, with masses, a force on its
// coupler and a moment on its rocker. In inches, pounds, seconds and blobs. The figures are those of the nine equations above; the
// book's own printed results were not at hand.
TEST(Reactions, GiveWhatNortonsMatrixMethodGives) {
  const PlanarLinkage linkage = test::four_bar(19, 5, 15, 10);
  PlanarPosition guess(4);
  const double turn = radians(60);
  guess[1].angle = turn;
  guess[2] = {Point(2.5, 4.3), radians(21)};
  guess[3] = {Point(19, 0), radians(104)};
  auto path = PlanarPath::from(linkage, guess, {turn});
  ASSERT_TRUE(path);
  constexpr double from_blob = 1000;  // the solver divides kg mm/s^2 by 1000
  const auto polar = [](double r, double degrees_) {
    return Point(r * std::cos(radians(degrees_)), r * std::sin(radians(degrees_)));
  };
  PlanarLoads loads;
  loads.masses = {{1, 0.004 * from_blob, polar(3, 30), 0.4 * from_blob},
                  {2, 0.020 * from_blob, polar(9, 45), 1.5 * from_blob},
                  {3, 0.015 * from_blob, polar(5, 0), 0.8 * from_blob}};
  loads.forces = {{{2, polar(9, 45) + polar(3, 100)}, polar(80, 330), PlanarLinkage::ground}};
  loads.moments = {{3, PlanarLinkage::ground, 120}};
  const Moment moment(linkage, *path, loads, {25}, {-40});
  EXPECT_NEAR(degrees(moment.position[2].angle), 20.92, 0.005);
  EXPECT_NEAR(degrees(moment.position[3].angle), 104.41, 0.005);
  EXPECT_NEAR(moment.rate[5], -5.87, 0.005);
  EXPECT_NEAR(moment.rate[8], 7.93, 0.005);
  EXPECT_NEAR(moment.second[5], 120.9, 0.05);
  EXPECT_NEAR(moment.second[8], 276.29, 0.005);
  ASSERT_TRUE(moment.reactions);
  const std::vector<Reaction>& r = *moment.reactions;
  const auto expect_force = [](const Point& force, double x, double y) {
    EXPECT_NEAR(force.x(), x, 0.01);
    EXPECT_NEAR(force.y(), y, 0.01);
  };
  expect_force(r[0].force, -117.65, -107.84);  // F12, on the crank
  expect_force(-r[1].force, 118.13, 100.34);   // F32, on the crank
  expect_force(-r[2].force, -1.34, 87.43);     // F43, on the coupler
  expect_force(-r[3].force, -20.23, 77.71);    // F14, on the rocker
  EXPECT_NEAR(r[4].along, 243.23, 0.01);       // T12
  const auto nine =
      by_nine_equations({turn, moment.position[2].angle, moment.position[3].angle},
                        {25, moment.rate[5], moment.rate[8]}, {-40, moment.second[5], moment.second[8]});
  Eigen::Vector<double, 9> found;
  found << r[0].force, -r[1].force, -r[2].force, -r[3].force, r[4].along;
  EXPECT_LT((found - nine).norm(), 1e-8 * nine.norm());
}

/// Adds what one constraint does to the forces and moments on all bodies, moments about the table's origin: written from the
/// meaning of a Reaction alone, without the equations.
class LinkBalance {
 public:
  LinkBalance(const PlanarLinkage& linkage, const PlanarPosition& position)
      : linkage_(linkage), position_(position), sums_(Eigen::VectorXd::Zero(3 * linkage.body_count())) {}

  void add_force(int body, const Point& at, const Point& force) {
    sums_.segment<2>(3 * body) += force;
    sums_[3 * body + 2] += cross(at, force);
  }
  void add_moment(int body, double moment) { sums_[3 * body + 2] += moment; }

  void add(int number, const Reaction& reaction) {
    std::visit(
        Overloaded{
            [&](const Revolute& c) { push(c.b.body, c.a.body, place(position_, c.b), reaction.force); },
            [&](const Coordinate& c) {
              push(c.point.body, c.origin.body, place(position_, c.point), reaction.force);
            },
            [&](const Distance& c) { push(c.a.body, c.b.body, place(position_, c.a), reaction.force); },
            [&](const RelativeAngle& c) {
              add_moment(c.body, reaction.along);
              add_moment(c.reference, -reaction.along);
            },
            [&](const GearPair& c) { push(c.first, c.second, pitch_point(c), reaction.force); },
            [&](const RackAndPinion& c) {
              const Point u = turned(position_, c.rack_origin.body, c.direction);
              push(c.centre.body, c.rack_origin.body, place(position_, c.centre) - c.radius * left_of(u),
                   reaction.force);
            }},
        linkage_.constraints()[static_cast<std::size_t>(number)].constraint);
  }

  const Eigen::VectorXd& sums() const { return sums_; }

 private:
  void push(int body, int back, const Point& at, const Point& force) {
    add_force(body, at, force);
    add_force(back, at, -force);
  }
  /// On the line of the wheels' centres, which are the origins of their frames here.
  Point pitch_point(const GearPair& c) const {
    const Point first = position_[static_cast<std::size_t>(c.first)].at,
                second = position_[static_cast<std::size_t>(c.second)].at;
    return (c.second_radius * first + c.first_radius * second) / (c.first_radius + c.second_radius);
  }

  const PlanarLinkage& linkage_;
  const PlanarPosition& position_;
  Eigen::VectorXd sums_;
};

/// Random linkages that are closed at a random position: every constraint gets the value that it has there.
class RandomMachine {
 public:
  explicit RandomMachine(Random& random) : random_(random) {
    const int bodies = 2 + random.below(4);
    for (int i = 0; i < bodies; ++i) linkage.add_body("link");
    position = test::random_position(random, bodies + 1, 3);
    for (int body = 1; body <= bodies; ++body) hold(body, random.below(body));
    for (int i = random.below(3); i > 0; --i) hold_one(1 + random.below(bodies), 0);
    add_drivers();
  }

  PlanarLinkage linkage;
  PlanarPosition position;

  PlanarLoads loads() {
    PlanarLoads result;
    const int bodies = linkage.body_count() - 1;
    const auto some_body = [&] { return 1 + random_.below(bodies); };
    for (int i = 0; i < 2; ++i)
      result.forces.push_back(
          {{some_body(), random_.point(2)}, random_.point(50), random_.below(bodies + 1)});
    result.pairs = {{{some_body(), random_.point(2)}, {0, random_.point(3)}, random_.uniform(-30, 30)}};
    result.moments = {{some_body(), random_.below(bodies + 1), random_.uniform(-40, 40)}};
    for (int body = 1; body <= bodies; ++body)
      result.masses.push_back({body, random_.uniform(0, 900), random_.point(1), random_.uniform(0, 900)});
    result.gravity = random_.point(10);
    return result;
  }

 private:
  BodyPoint at(int body, const Point& table) const {
    if (body == 0) return {0, table};
    const BodyPlacement& here = position[static_cast<std::size_t>(body)];
    const Point d = table - here.at;
    const double c = std::cos(here.angle), s = std::sin(here.angle);
    return {body, Point(c * d.x() + s * d.y(), -s * d.x() + c * d.y())};
  }
  double angle(int body) const { return position[static_cast<std::size_t>(body)].angle; }

  void hold(int body, int other) {
    switch (random_.below(3)) {
      case 0: hold_one(body, other), hold_one(body, other); break;
      case 1: pin(body, other); break;
      default: wheel(body, other);
    }
  }

  void pin(int body, int other) {
    const Point here = position[static_cast<std::size_t>(body)].at + random_.point(1);
    linkage.add(Revolute{at(other, here), at(body, here)}, "pin");
  }

  /// A wheel on a carrier, which meshes with an earlier one on the same, if there is one.
  void wheel(int body, int carrier) {
    const Point centre = position[static_cast<std::size_t>(body)].at;
    linkage.add(Revolute{at(carrier, centre), {body, Point::Zero()}}, "axle");
    for (const auto& [other, same] : wheels_)
      if (same == carrier) {
        const double a = random_.uniform(0.5, 2), b = random_.uniform(0.5, 2) * (random_.below(2) ? 1 : -3);
        linkage.add(GearPair{body, other, carrier, a, b,
                             a * (angle(body) - angle(carrier)) + b * (angle(other) - angle(carrier))},
                    "gears");
        break;
      }
    wheels_.emplace_back(body, carrier);
  }

  /// One equation between two bodies.
  void hold_one(int body, int other) {
    const BodyPoint point{body, random_.point(2)}, origin{other, random_.point(2)};
    const double way = random_.uniform(-pi, pi);
    const Point u(std::cos(way), std::sin(way)), between = place(position, point) - place(position, origin);
    const double along = turned(position, other, u).dot(between), turn = angle(body) - angle(other);
    switch (random_.below(4)) {
      case 0: linkage.add(Coordinate{point, origin, u, along}, "slot"); break;
      case 1: linkage.add(Distance{point, origin, between.norm()}, "bar"); break;
      case 2: linkage.add(RelativeAngle{body, other, turn}, "angle"); break;
      default: {
        const double radius = random_.uniform(0.3, 2) * (random_.below(2) ? 1 : -1);
        linkage.add(
            RackAndPinion{{body, Point::Zero()},
                          origin,
                          u,
                          radius,
                          turned(position, other, u)
                                  .dot(place(position, {body, Point::Zero()}) - place(position, origin)) +
                              radius * turn},
            "rack");
      }
    }
  }

  void add_drivers() {
    const int freedoms = linkage.unknown_count() - linkage.equation_count();
    for (int i = 0; i < freedoms; ++i) {
      const int body = 1 + random_.below(linkage.body_count() - 1);
      const BodyPoint point{body, random_.point(2)};
      if (random_.below(2))
        linkage.drive(RelativeAngle{body, 0, angle(body)}, "motor");
      else
        linkage.drive(Coordinate{point, {}, Point(1, 0), place(position, point).x()}, "cylinder");
    }
  }

  Random& random_;
  std::vector<std::pair<int, int>> wheels_;
};

double largest(const Moment& moment) {
  double most = moment.applied.lpNorm<Eigen::Infinity>() + moment.inertia.lpNorm<Eigen::Infinity>();
  for (const Reaction& reaction : *moment.reactions) most = std::max(most, reaction.force.norm());
  return most;
}

/// Calls a law for random machines that have a regular position, with a random motion.
template <class Law>
int each_machine(std::uint64_t seed, int samples, const Law& law) {
  Random random(seed);
  int seen = 0;
  for (int i = 0; i < samples; ++i) {
    RandomMachine machine(random);
    auto path = PlanarPath::from(machine.linkage, machine.position, machine.linkage.driver_values());
    if (!path) continue;  // drivers that are not independent, or none left
    std::vector<double> speeds, accelerations;
    for (std::size_t driver = 0; driver < machine.linkage.drivers().size(); ++driver) {
      speeds.push_back(random.uniform(-1, 1));
      accelerations.push_back(random.uniform(-1, 1));
    }
    const PlanarLoads loads = machine.loads();
    const Moment moment(machine.linkage, *path, loads, speeds, accelerations);
    if (!moment.reactions || largest(moment) > 1e6) continue;  // next to a dead point
    law(machine.linkage, loads, moment, speeds);
    ++seen;
  }
  return seen;
}

TEST(Reactions, BalanceEveryLink) {
  const int seen = each_machine(
      61, test::samples(3000),
      [](const PlanarLinkage& linkage, const PlanarLoads& loads, const Moment& moment,
         const std::vector<double>&) {
        LinkBalance balance(linkage, moment.position);
        for (int i = 0; i < static_cast<int>(moment.reactions->size()); ++i)
          balance.add(i, (*moment.reactions)[static_cast<std::size_t>(i)]);
        for (const PointForce& force : loads.forces)
          balance.add_force(force.at.body, place(moment.position, force.at),
                            turned(moment.position, force.turns_with, force.newton));
        for (const PairForce& pair : loads.pairs) {
          const Point a = place(moment.position, pair.a), b = place(moment.position, pair.b);
          balance.add_force(pair.a.body, a, pair.newton / (a - b).norm() * (a - b));
          balance.add_force(pair.b.body, b, pair.newton / (a - b).norm() * (b - a));
        }
        for (const BodyMoment& each : loads.moments) {
          balance.add_moment(each.body, each.moment);
          balance.add_moment(each.against, -each.moment);
        }
        for (const BodyMass& mass : loads.masses) {
          const BodyPoint centre{mass.body, mass.centre};
          const Point a = acceleration_of(moment.position, moment.rate, moment.second, centre) / 1000;
          balance.add_force(mass.body, place(moment.position, centre), mass.kg * (loads.gravity - a));
          balance.add_moment(mass.body, -mass.inertia * spin_of(moment.second, mass.body) / 1000);
        }
        EXPECT_LT(balance.sums().tail(balance.sums().size() - 3).lpNorm<Eigen::Infinity>(),
                  1e-9 * largest(moment));
      });
  EXPECT_GT(seen, test::samples(3000) / 5);
}

TEST(Reactions, DriversBringInThePowerThatLoadsAndMassesTake) {
  const int seen =
      each_machine(62, test::samples(3000),
                   [](const PlanarLinkage& linkage, const PlanarLoads&, const Moment& moment,
                      const std::vector<double>& speeds) {
                     double power = (moment.applied - moment.inertia).dot(moment.rate), all = std::abs(power);
                     for (std::size_t driver = 0; driver < speeds.size(); ++driver) {
                       const auto number = static_cast<std::size_t>(linkage.drivers()[driver]);
                       const double brought = (*moment.reactions)[number].along * speeds[driver];
                       power += brought;
                       all += std::abs(brought);
                     }
                     EXPECT_LE(std::abs(power), 1e-9 * (all + largest(moment) * moment.rate.norm()));
                   });
  EXPECT_GT(seen, test::samples(3000) / 5);
}

/// Kinetic energy and that of height, N mm.
double energy_of(const PlanarLoads& loads, const PlanarPosition& position, const Eigen::VectorXd& rate) {
  double energy = 0;
  for (const BodyMass& mass : loads.masses) {
    const BodyPoint centre{mass.body, mass.centre};
    energy += 0.5e-3 * mass.kg * velocity_of(position, rate, centre).squaredNorm() +
              0.5e-3 * mass.inertia * std::pow(spin_of(rate, mass.body), 2) -
              mass.kg * loads.gravity.dot(place(position, centre));
  }
  return energy;
}

TEST(Reactions, ADriversPowerIsTheGrowthOfTheEnergy) {
  Random random(63);
  for (int i = 0; i < test::samples(200); ++i) {
    const PlanarLinkage linkage = test::four_bar(3, 1, random.uniform(2.6, 3.2), random.uniform(2, 3));
    const double turn = random.uniform(-pi, pi), speed = random.uniform(-3, 3);
    auto path = PlanarPath::from(linkage, test::random_position(random, 4, 3), {turn});
    if (!path) continue;
    PlanarLoads loads;
    for (const int body : {1, 2, 3})
      loads.masses.push_back({body, random.uniform(1, 9), random.point(2), random.uniform(1, 9)});
    loads.gravity = random.point(10);
    const Moment moment(linkage, *path, loads, {speed}, {0});
    ASSERT_TRUE(moment.reactions);
    constexpr double step = 1e-4;  // s
    double energy[2];
    for (const int side : {0, 1}) {
      PlanarPath moved = *path;
      ASSERT_TRUE(moved.advance({turn + speed * step * (side ? 0.5 : -0.5)}));
      energy[side] = energy_of(loads, moved.position(), moved.velocity({speed}));
    }
    const double power = moment.reactions->back().along * speed;
    EXPECT_NEAR((energy[1] - energy[0]) / step, power, 1e-5 * (1 + std::abs(power)));
  }
}

/// A parallelogram with `cranks` cranks from (2 i, 0), and a dyad from its bar to the ground at (9, 3).
PlanarLinkage cranks_and_dyad(int cranks) {
  PlanarLinkage linkage;
  const int bar = linkage.add_body("bar"), arm = linkage.add_body("arm"), foot = linkage.add_body("foot");
  for (int i = 0; i < cranks; ++i) {
    const int crank = linkage.add_body("crank");
    linkage.add(Revolute{{0, Point(2.0 * i, 0)}, {crank, Point(0, 0)}}, "foot");
    linkage.add(Revolute{{crank, Point(1, 0)}, {bar, Point(2.0 * i, 0)}}, "head");
  }
  linkage.add(Revolute{{bar, Point(5, 1)}, {arm, Point(0, 0)}}, "K");
  linkage.add(Revolute{{arm, Point(3, 0)}, {foot, Point(0, 0)}}, "L");
  linkage.add(Revolute{{foot, Point(3, 0)}, {0, Point(9, 3)}}, "M");
  linkage.drive(RelativeAngle{4, 0, 0}, "crank");
  return linkage;
}

std::optional<std::vector<Reaction>> cranks_and_dyad_reactions(int cranks) {
  const PlanarLinkage linkage = cranks_and_dyad(cranks);
  PlanarPosition guess(static_cast<std::size_t>(4 + cranks));
  guess[1] = {Point(0.5, 0.8), 0};
  guess[2] = {Point(5.5, 1.8), 0.8};
  guess[3] = {Point(8, 5), -1};
  for (int i = 0; i < cranks; ++i) guess[static_cast<std::size_t>(4 + i)] = {Point(2.0 * i, 0), 1.05};
  auto path = PlanarPath::from(linkage, guess, {1.05});
  if (!path) return std::nullopt;
  PlanarLoads loads;
  loads.forces = {{{1, Point(3, 2)}, Point(7, -30), 0}, {{2, Point(1, 0)}, Point(4, 11), 0}};
  ReactionSolver solver(linkage);
  return solver.at(path->position(), path->values(), -applied_forces(loads, path->position()));
}

TEST(Reactions, OfRedundantCranksAreNotDeterminedAndAllOthersAre) {
  const auto two = cranks_and_dyad_reactions(2), three = cranks_and_dyad_reactions(3);
  ASSERT_TRUE(two && three);
  for (const Reaction& reaction : *two) EXPECT_TRUE(reaction.determined);
  ASSERT_EQ(three->size(), two->size() + 2);
  // The dyad and the driver feel nothing of the third crank. It shares what the others bear along the cranks.
  for (int last = 1; last <= 4; ++last) {
    const Reaction& a = (*two)[two->size() - static_cast<std::size_t>(last)];
    const Reaction& b = (*three)[three->size() - static_cast<std::size_t>(last)];
    EXPECT_TRUE(b.determined);
    EXPECT_NEAR((a.force - b.force).norm() + std::abs(a.along - b.along), 0, 1e-10);
  }
  for (std::size_t joint = 0; joint < 6; ++joint) EXPECT_FALSE((*three)[joint].determined) << joint;
}

TEST(Reactions, AreNoneAtADeadPoint) {
  // Crank and coupler of a slider-crank in line, driven by the slider.
  PlanarLinkage linkage;
  const int crank = linkage.add_body("crank"), rod = linkage.add_body("rod");
  linkage.add(Revolute{{0, Point(0, 0)}, {crank, Point(0, 0)}}, "A");
  linkage.add(Revolute{{crank, Point(1, 0)}, {rod, Point(0, 0)}}, "B");
  linkage.add(Coordinate{{rod, Point(2, 0)}, {}, Point(0, 1), 0}, "C");
  linkage.drive(Coordinate{{rod, Point(2, 0)}, {}, Point(1, 0), 3}, "C");
  PlanarPosition position(3);
  position[2].at = {1, 0};
  ReactionSolver solver(linkage);
  EXPECT_FALSE(solver.at(position, {3}, Eigen::VectorXd::Zero(6)));
}

TEST(Reactions, AreNoneWhereAForceHasNoDirection) {
  PlanarLinkage linkage;
  const int crank = linkage.add_body("crank");
  linkage.add(Revolute{{0, Point(0, 0)}, {crank, Point(0, 0)}}, "A");
  linkage.drive(RelativeAngle{crank, 0, 0}, "crank");
  ReactionSolver solver(linkage);
  for (const double turn : {0.0, 0.5}) {
    PlanarPosition position(2);
    position[1].angle = turn;
    PlanarLoads loads;
    loads.pairs = {{{crank, Point(40, 0)}, {0, Point(40, 0)}, 12}};  // of a spring whose ends meet at 0
    EXPECT_EQ(solver.at(position, {turn}, -applied_forces(loads, position)).has_value(), turn > 0) << turn;
  }
  linkage.add(Distance{{crank, Point(40, 0)}, {0, Point(40, 0)}, 0}, "spare");
  EXPECT_FALSE(ReactionSolver(linkage).at(PlanarPosition(2), {0}, Eigen::VectorXd::Zero(3)));
}

TEST(Reactions, OfALinkageDrawnLargerAreTheSameForces) {
  Random random(64);
  for (int i = 0; i < test::samples(200); ++i) {
    const double b = random.uniform(2.6, 3.2), c = random.uniform(2, 3), turn = random.uniform(-pi, pi);
    const PlanarPosition guess = test::random_position(random, 4, 3);
    const Point at = random.point(2), newton = random.point(50);
    const double torque = random.uniform(-9, 9);
    std::vector<std::vector<Reaction>> found;
    for (const double scale : {1.0, 1024.0}) {
      const PlanarLinkage linkage = test::four_bar(3 * scale, scale, b * scale, c * scale);
      PlanarPosition larger = guess;
      for (BodyPlacement& body : larger) body.at *= scale;
      auto path = PlanarPath::from(linkage, larger, {turn});
      if (!path) break;
      PlanarLoads loads;
      loads.forces = {{{2, scale * at}, newton, 3}};
      loads.moments = {{3, 0, scale * torque}};
      ReactionSolver solver(linkage);
      found.push_back(*solver.at(path->position(), path->values(), -applied_forces(loads, path->position())));
    }
    if (found.size() < 2) continue;
    for (std::size_t joint = 0; joint < 5; ++joint) {
      EXPECT_EQ(found[0][joint].force, found[1][joint].force);
      EXPECT_EQ(1024 * found[0][joint].along, found[1][joint].along);
    }
  }
}

TEST(Reactions, OfGearsWithoutBearingsAreNotDeterminedButTheDriversAre) {
  PlanarLinkage linkage;
  const int first = linkage.add_body("first"), second = linkage.add_body("second");
  for (const int body : {first, second}) {
    linkage.add(Coordinate{{body, Point::Zero()}, {}, Point(1, 0), body == first ? 0.0 : 3.0}, "x");
    linkage.add(Coordinate{{body, Point::Zero()}, {}, Point(0, 1), 0}, "y");
  }
  linkage.add(GearPair{first, second, 0, 1, 2, 0}, "gears");
  linkage.drive(RelativeAngle{first, 0, 0}, "motor");
  PlanarPosition position(3);
  position[2].at = {3, 0};
  PlanarLoads loads;
  loads.moments = {{second, 0, 10}};
  ReactionSolver solver(linkage);
  EXPECT_TRUE(solver.has_gears_without_bearings());
  const auto reactions = solver.at(position, {0}, -applied_forces(loads, position));
  ASSERT_TRUE(reactions);
  EXPECT_FALSE(reactions->front().determined);
  EXPECT_TRUE(reactions->back().determined);
  EXPECT_NEAR(reactions->back().along, 5, 1e-12);
}

}  // namespace
}  // namespace kempe
