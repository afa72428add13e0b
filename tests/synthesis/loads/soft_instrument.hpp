#pragma once
// Instruments that are made wrong, have play in their pins and give way under a force at the pen, closed and brought into balance by the
// general planar solver: its reactions bend every link and every pin, the loops of what they leave are closed again, until nothing moves. No
// sensitivity, no closed form of the forces and no strain energy of the library is used; the pins' compliance comes from outside.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "kinematics/planar/loads.hpp"
#include "kinematics/planar/reactions.hpp"
#include "kinematics/planar/solver.hpp"
#include "synthesis/loads/load_error.hpp"
#include "tests/synthesis/tolerance/wrong_instruments.hpp"

namespace kempe::soft_instrument {

/// What the instrument is made of.
struct Stuff {
  LinkStyle style;
  double E = 0;  ///< N/mm^2
  PinCompliance pins{};
};

/// How far a pin lies off its hole's middle in its play.
struct Play {
  double radius = 0;       ///< mm, half the play
  bool is_pressed = true;  ///< against the wall to which its force presses it; else as Flaws says
};

/// Order of the pins as in Flaws: pole, V, A, B, C.
class SoftInstrument {
 public:
  SoftInstrument(const CopyingLinkage& drawing, const Stuff& stuff, const wrong_instruments::Flaws& flaws,
                 const Play& play)
      : drawing_(drawing), stuff_(stuff), flaws_(flaws), play_(play) {}

  /// Where the pen is under this force on it with the tracer held; nothing if the loops do not close or no balance is found.
  std::optional<Point> pen(const Point& tracer, const Point& force) const {
    const Pose drawn = drawing_.pose_with_tracer_at(tracer).value();
    const Holes made = made_holes(drawn);
    State state = at_rest(drawn, made);
    std::optional<Point> last;
    for (int round = 0; round < 60; ++round) {
      const PlanarLinkage linkage = linkage_of(state);
      const std::vector<double> held{tracer.x(), tracer.y()};
      const auto closed = solve_from(linkage, state.position, held);
      if (!closed) return std::nullopt;
      state.position = closed->position;
      const Point pen = place(state.position, carrier(state, drawing_.pen_joint()));
      if (last && (pen - *last).norm() < 1e-9) return pen;
      last = pen;
      PlanarLoads loads;
      loads.forces.push_back({carrier(state, drawing_.pen_joint()), force});
      const auto reactions =
          ReactionSolver(linkage).at(state.position, held, -applied_forces(loads, state.position));
      if (!reactions) return std::nullopt;
      give_way(state, made, *reactions, force);
    }
    return std::nullopt;
  }

 private:
  enum { ground, VA, VB, ACX, BCY };
  using Holes =
      std::array<std::vector<Point>, 5>;  ///< of each body in its frame, in the order of the link's name
  struct State {
    PlanarPosition position;
    Holes holes;
    std::array<Point, 5> offset;  ///< of the second body's hole from the first's, in the table's frame
  };

  bool pole_is_at_V() const { return drawing_.grounding() == Grounding::pole; }

  Holes made_holes(const Pose& z) const {
    using namespace wrong_instruments;
    const LinkLengths l = drawing_.lengths();
    const auto& e = flaws_.length;
    const bool flat = is_flat(drawing_.shape());
    const auto turn = drawing_.assembly_mode().sides;
    const Point X = flat ? flat_hole(seen_from(z.A, z.C, z.X), l.AX + e[4], e[5])
                         : third_corner(l.AC + e[2], l.AX + e[4], l.CX + e[5], sign(turn.plate_ACX));
    const Point Y = flat ? flat_hole(seen_from(z.B, z.C, z.Y), l.BY + e[6], e[7])
                         : third_corner(l.BC + e[3], l.BY + e[6], l.CY + e[7], sign(turn.plate_BCY));
    const Point O = Point::Zero();
    return {{{},
             {O, {l.VA + e[0], 0}},
             {O, {l.VB + e[1], 0}},
             {O, {l.AC + e[2], 0}, X},
             {O, {l.BC + e[3], 0}, Y}}};
  }

  State at_rest(const Pose& z, const Holes& made) const {
    using wrong_instruments::heading;
    return {{{},
             {z.V, heading(z.V, z.A)},
             {z.V, heading(z.V, z.B)},
             {z.A, heading(z.A, z.C)},
             {z.B, heading(z.B, z.C)}},
            made,
            flaws_.pin};
  }

  BodyPoint hole(const State& state, int body, std::size_t number) const {
    return {body, state.holes[static_cast<std::size_t>(body)][number]};
  }
  /// A tool at V sits fast in VA.
  BodyPoint carrier(const State& state, Joint joint) const {
    return joint == Joint::V ? hole(state, VA, 0) : hole(state, joint == Joint::X ? ACX : BCY, 2);
  }
  /// A point of a body, moved by so much in the table's frame.
  BodyPoint moved(const State& state, BodyPoint point, const Point& offset) const {
    const double angle = state.position[static_cast<std::size_t>(point.body)].angle;
    point.local += as_point(as_complex(offset) * std::polar(1.0, -angle));
    return point;
  }

  PlanarLinkage linkage_of(const State& state) const {
    PlanarLinkage linkage;
    for (const char* name : {"VA", "VB", "ACX", "BCY"}) linkage.add_body(name);
    const BodyPoint pole{ground, drawing_.pole()};
    const auto join = [&](const BodyPoint& first, std::size_t pin, const BodyPoint& second) {
      linkage.add(Revolute{moved(state, first, state.offset[pin]), second});
    };
    join(pole, 0, pole_is_at_V() ? hole(state, VA, 0) : hole(state, ACX, 2));
    join(pole_is_at_V() ? pole : hole(state, VA, 0), 1, hole(state, VB, 0));
    join(hole(state, VA, 1), 2, hole(state, ACX, 0));
    join(hole(state, VB, 1), 3, hole(state, BCY, 0));
    join(hole(state, ACX, 1), 4, hole(state, BCY, 1));
    linkage.drive_point(carrier(state, drawing_.tracer_joint()));
    return linkage;
  }

  /// The joint at which a link's arms meet: between the others in a straight link, else the first.
  static std::size_t middle_of(const std::vector<Point>& holes) {
    if (holes.size() == 2) return 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point a = holes[(i + 1) % 3] - holes[i], b = holes[(i + 2) % 3] - holes[i];
      if (a.dot(b) < -0.9999 * a.norm() * b.norm()) return i;
    }
    return 0;
  }

  /// Links and pins as these forces bend them.
  void give_way(State& state, const Holes& made, const std::vector<Reaction>& by,
                const Point& pen_force) const {
    // On the second body of each pin; on the tracer.
    std::array<Point, 5> on_pin;
    for (std::size_t i = 0; i < 5; ++i) on_pin[i] = by[i].force;
    const Point hand = by[5].force + by[6].force;
    const auto tool = [&](Joint joint) -> Point {
      Point sum = Point::Zero();
      if (joint == drawing_.tracer_joint()) sum += hand;
      if (joint == drawing_.pen_joint()) sum += pen_force;
      if (joint == drawing_.pole_joint()) sum += on_pin[0];
      return sum;
    };
    const Point none = Point::Zero();
    const Holes forces{{{},
                        {none, -on_pin[2]},
                        {none, -on_pin[3]},
                        {on_pin[2], -on_pin[4], tool(Joint::X)},
                        {on_pin[3], on_pin[4], tool(Joint::Y)}}};
    const double area = stuff_.style.width * stuff_.style.thickness,
                 inertia = stuff_.style.thickness * std::pow(stuff_.style.width, 3) / 12;
    for (std::size_t body = VA; body <= BCY; ++body) {
      const std::size_t middle = middle_of(made[body]);
      const Complex unturn = std::polar(1.0, -state.position[body].angle);
      for (std::size_t i = 0; i < made[body].size(); ++i) {
        state.holes[body][i] = made[body][i];
        if (i == middle) continue;
        const Complex arm = as_complex(made[body][i] - made[body][middle]);
        const double length = std::abs(arm);
        const Complex way = arm / length, force = as_complex(forces[body][i]) * unturn * std::conj(way);
        const Complex bent{force.real() * length / (stuff_.E * area),
                           force.imag() * std::pow(length, 3) / (3 * stuff_.E * inertia)};
        state.holes[body][i] += as_point(bent * way);
      }
    }
    const PinCompliance& soft = stuff_.pins;
    const Point post = -soft.pole * (pole_is_at_V() ? Point(on_pin[0] + on_pin[1]) : on_pin[0]);
    const std::array<double, 5> gives{0, soft.V, soft.A, soft.B, soft.C};
    for (std::size_t i = 0; i < 5; ++i) {
      const double force = on_pin[i].norm();
      state.offset[i] = -gives[i] * on_pin[i];
      if (!play_.is_pressed)
        state.offset[i] += flaws_.pin[i];
      else  // one that bears next to nothing lies nearer the middle, else it would leap from wall to wall
        state.offset[i] -= play_.radius / (force + 1e-3 * pen_force.norm()) * on_pin[i];
      if (i == 0 || (i == 1 && pole_is_at_V())) state.offset[i] += post;
    }
  }

  CopyingLinkage drawing_;
  Stuff stuff_;
  wrong_instruments::Flaws flaws_;
  Play play_;
};

}  // namespace kempe::soft_instrument
