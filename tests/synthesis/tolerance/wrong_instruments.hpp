#pragma once
// Instruments that are built wrong, closed by the general planar solver: plates from three lengths by the law of cosines,
// holes displaced by the play. No formula of the library's sensitivities or of check_robust() is used.

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "geometry/complex_vectors.hpp"
#include "kinematics/planar/solver.hpp"
#include "synthesis/tolerance/copy_error.hpp"
#include "tests/random.hpp"

namespace kempe::wrong_instruments {

class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}
  double uniform(double lower, double upper) { return test::uniform(random_, lower, upper); }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  bool one_in(std::size_t n) { return below(n) == 0; }
  double sign() { return random_() & 1 ? 1 : -1; }
  Point on_circle(double radius) { return as_point(std::polar(radius, uniform(-pi, pi))); }
  Point in_disc(double radius) { return on_circle(radius * std::sqrt(uniform(0, 1))); }

 private:
  std::mt19937_64 random_;
};

/// What is wrong with one instrument.
struct Flaws {
  std::array<double, 8> length{};
  std::array<Point, 5> pin{Point::Zero(), Point::Zero(), Point::Zero(), Point::Zero(), Point::Zero()};
};

/// Holes of each link on the table, in the order of the link's name, and of the tracer.
struct MadePose {
  std::array<std::vector<Point>, 4> holes;
  Point tracer = Point::Zero(), pole = Point::Zero();
};

/// Third corner of a triangle on its first side along x; `side` +1 if it lies to the left.
inline Point third_corner(double first_side, double from_corner, double from_C, double side) {
  const double x = (first_side * first_side + from_corner * from_corner - from_C * from_C) / (2 * first_side);
  return {x, side * std::sqrt(from_corner * from_corner - x * x)};
}

/// A hole that a flat plate carries: `length` from the corner along its nominal direction, `out` across it.
inline Point flat_hole(const Point& nominal, double length, double out) {
  const Point along = nominal.normalized();
  return along * length + Point(-along.y(), along.x()) * out;
}

inline double heading(const Point& from, const Point& to) { return std::arg(as_complex(Point(to - from))); }

/// `to` seen in the frame at `from` whose x axis runs towards `ahead`.
inline Point seen_from(const Point& from, const Point& ahead, const Point& to) {
  return as_point(as_complex(Point(to - from)) * std::polar(1.0, -heading(from, ahead)));
}

/// An instrument with these flaws, its tracer held at a place; nothing if it does not close there.
inline std::optional<MadePose> made_pose(const CopyingLinkage& drawing, const Flaws& flaws,
                                         const Point& tracer) {
  const Pose z = drawing.pose_with_tracer_at(tracer).value();
  const LinkLengths l = drawing.lengths();
  const auto& e = flaws.length;
  const bool flat = is_flat(drawing.shape());
  const auto turn = drawing.assembly_mode().sides;
  const Point X = flat ? flat_hole(seen_from(z.A, z.C, z.X), l.AX + e[4], e[5])
                       : third_corner(l.AC + e[2], l.AX + e[4], l.CX + e[5], sign(turn.plate_ACX));
  const Point Y = flat ? flat_hole(seen_from(z.B, z.C, z.Y), l.BY + e[6], e[7])
                       : third_corner(l.BC + e[3], l.BY + e[6], l.CY + e[7], sign(turn.plate_BCY));
  PlanarLinkage linkage;
  const int VA = linkage.add_body("VA"), VB = linkage.add_body("VB"), ACX = linkage.add_body("ACX"),
            BCY = linkage.add_body("BCY");
  const auto& pin = flaws.pin;
  const bool pole_at_V = drawing.grounding() == Grounding::pole;
  const BodyPoint V{VA, Point::Zero()}, X_hole{ACX, X}, Y_hole{BCY, Y};
  linkage.add(Revolute{pole_at_V ? V : X_hole, {0, drawing.pole() + pin[0]}});
  linkage.add(Revolute{{VB, Point::Zero()},
                       pole_at_V ? BodyPoint{0, drawing.pole() + pin[1]} : BodyPoint{VA, pin[1]}});
  linkage.add(Revolute{{ACX, Point::Zero()}, {VA, Point(l.VA + e[0], 0) + pin[2]}});
  linkage.add(Revolute{{BCY, Point::Zero()}, {VB, Point(l.VB + e[1], 0) + pin[3]}});
  linkage.add(Revolute{{ACX, Point(l.AC + e[2], 0) + pin[4]}, {BCY, Point(l.BC + e[3], 0)}});
  const auto carried = [&](Joint joint) {
    return joint == Joint::V ? V : joint == Joint::X ? X_hole : Y_hole;
  };
  linkage.drive_point(carried(drawing.tracer_joint()));
  const PlanarPosition guess{{},
                             {z.V, heading(z.V, z.A)},
                             {z.V, heading(z.V, z.B)},
                             {z.A, heading(z.A, z.C)},
                             {z.B, heading(z.B, z.C)}};
  const auto closed = solve_from(linkage, guess, {tracer.x(), tracer.y()});
  if (!closed) return std::nullopt;
  const auto at = [&](int body, const Point& local) {
    return place(closed->position, BodyPoint{body, local});
  };
  return MadePose{{{{at(VA, Point::Zero()), at(VA, {l.VA + e[0], 0})},
                    {at(VB, Point::Zero()), at(VB, {l.VB + e[1], 0})},
                    {at(ACX, Point::Zero()), at(ACX, {l.AC + e[2], 0}), at(ACX, X)},
                    {at(BCY, Point::Zero()), at(BCY, {l.BC + e[3], 0}), at(BCY, Y)}}},
                  tracer,
                  drawing.pole()};
}

inline Point true_pen(const CopyingLinkage& linkage, const Point& tracer) {
  return linkage.pole() + as_point(linkage.k() * as_complex(tracer - linkage.pole()));
}

struct Case {
  CopyingLinkage linkage;
  Point tracer;
};

/// Height over the longest side of a plate, as a share of its shortest side.
inline double flatness(Complex shape) {
  const double a = 1, b = std::abs(shape), c = std::abs(shape - 1.0);
  return std::abs(shape.imag()) / std::max({a, b, c}) / std::min({a, b, c});
}

/// Ratios and groundings of every kind, one in four with straight plates; well away from dead and change
/// points. Plates between flat and `slimmest` are left out: there 0.05 mm are no longer small beside the
/// plate's height.
inline Case random_case(Chance& chance, double slimmest = 0.3) {
  constexpr std::array<double, 2> straight{0, pi};
  for (;;) {
    const double rotation = chance.below(4) == 0 ? straight[chance.below(2)] : chance.uniform(-pi, pi);
    const Complex k = copy_ratio(std::exp(chance.uniform(-1.4, 1.4)), rotation);
    if (std::abs(k - 1.0) < 0.2) continue;
    const Grounding grounding = all_groundings[chance.below(3)];
    const double slim = flatness(shape_of(k, grounding));
    if (!is_flat(shape_of(k, grounding)) && slim < slimmest) continue;
    const auto modes = assembly_modes(shape_of(k, grounding));
    const std::size_t assembly_mode = chance.below(modes.size());
    if (modes[assembly_mode].openings.width() < radians(60)) continue;
    const auto linkage = CopyingLinkage::make(k, grounding, chance.uniform(60, 200), chance.uniform(60, 200),
                                              static_cast<int>(assembly_mode),
                                              {chance.uniform(-50, 50), chance.uniform(-50, 50)});
    const double opening = modes[assembly_mode].openings.lower +
                           chance.uniform(radians(25), modes[assembly_mode].openings.width() - radians(25));
    return {*linkage, linkage->tracer_at(opening, chance.uniform(-pi, pi))};
  }
}

inline Region square_about(const Point& centre, double half) {
  return {{{{centre + Point(-half, -half), centre + Point(half, -half), centre + Point(half, half),
             centre + Point(-half, half)},
            {}}}};
}

}  // namespace kempe::wrong_instruments
