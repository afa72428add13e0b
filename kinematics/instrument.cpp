#include "kinematics/instrument.hpp"

#include <cmath>

#include "geometry/complex_vectors.hpp"
#include "kinematics/slack.hpp"

namespace kempe {
namespace {

/// A place (or a complex number of the plane) with its change by each measure.
struct Moved {
  Complex at{};
  Eigen::Matrix<Complex, 1, measure_count> by = Eigen::Matrix<Complex, 1, measure_count>::Zero();
};

/// A length with its change by each measure.
struct MovedLength {
  double value = 0;
  Eigen::Matrix<double, 1, measure_count> by = Eigen::Matrix<double, 1, measure_count>::Zero();
};

/// A joint on the line itself counts as left: a dyad's two closures meet there.
Side dyad_side(Complex from, Complex to, Complex point) {
  return cross(to - from, point - from) < 0 ? Side::right : Side::left;
}

Moved fixed(const Point& point) {
  Moved moved;
  moved.at = as_complex(point);
  return moved;
}

/// The measures as moved quantities.
class Own {
 public:
  explicit Own(const Measures& measures) : measures_(measures) {}
  MovedLength length(Measure measure) const {
    MovedLength length{measures_[index_of(measure)]};
    length.by[index_of(measure)] = 1;
    return length;
  }
  Moved place(Measure x, Measure y) const {
    Moved moved;
    moved.at = {measures_[index_of(x)], measures_[index_of(y)]};
    moved.by[index_of(x)] = 1;
    moved.by[index_of(y)] = Complex(0, 1);
    return moved;
  }

 private:
  const Measures& measures_;
};

/// A plate in its own frame: the joint of the parallelogram's corner C at the origin, the outer joint on the
/// axis.
struct Plate {
  Moved C, middle, outer;
};

Plate plate_1(const Own& own) {  // A and X
  Plate plate;
  plate.outer.at = own.length(Measure::CX).value;
  plate.outer.by[index_of(Measure::CX)] = 1;
  plate.middle = own.place(Measure::AX, Measure::offset_A);
  plate.middle.at = Complex(plate.outer.at.real() - plate.middle.at.real(), plate.middle.at.imag());
  plate.middle.by[index_of(Measure::AX)] = -1;
  plate.middle.by[index_of(Measure::CX)] = 1;
  return plate;
}

Plate plate_2(const Own& own) {  // B and Y
  Plate plate;
  plate.outer.at = own.length(Measure::CY).value;
  plate.outer.by[index_of(Measure::CY)] = 1;
  plate.middle = own.place(Measure::BC, Measure::offset_B);
  return plate;
}

MovedLength distance(const Moved& from, const Moved& to) {
  const Complex between = to.at - from.at;
  MovedLength length{std::abs(between)};
  for (int i = 0; i < measure_count; ++i) length.by[i] = dot(between, to.by[i] - from.by[i]) / length.value;
  return length;
}

using Closed = tl::expected<Moved, ClosureFault>;

/// The joint at distances a from `from` and b from `to`, on the given side.
///   |P - from| = a, |P - to| = b;   (P - from).dP = a da + (P - from).dfrom, and likewise at `to`
Closed dyad(const Moved& from, const Moved& to, const MovedLength& a, const MovedLength& b, Side side) {
  const Complex base = to.at - from.at;
  const double d = std::abs(base);
  if (!(d <= a.value + b.value)) return tl::unexpected(ClosureFault::too_far);
  if (!(d >= std::abs(a.value - b.value))) return tl::unexpected(ClosureFault::too_near);
  const double sixteen_areas_squared =
      (a.value + b.value - d) * (a.value + b.value + d) * (d - a.value + b.value) * (d + a.value - b.value);
  const double height = std::sqrt(std::max(0.0, sixteen_areas_squared)) / (2 * d);
  if (!(height > slack::flattest * (a.value + b.value))) return tl::unexpected(ClosureFault::flat);
  const double foot = (a.value * a.value - b.value * b.value + d * d) / (2 * d);
  Moved joint;
  joint.at = from.at + base / d * Complex(foot, sign(side) * height);
  const Complex u = joint.at - from.at, v = joint.at - to.at;
  const double determinant = cross(u, v);
  for (int i = 0; i < measure_count; ++i) {
    const double at_from = a.value * a.by[i] + dot(u, from.by[i]),
                 at_to = b.value * b.by[i] + dot(v, to.by[i]);
    joint.by[i] =
        Complex(v.imag() * at_from - u.imag() * at_to, u.real() * at_to - v.real() * at_from) / determinant;
  }
  return joint;
}

/// The third point of a plate that is laid with its points p and q on two places at their own distance.
///   third = at_p + (at_q - at_p) w,   w = (r - p) / (q - p)
Moved third_of_plate(const Moved& at_p, const Moved& at_q, const Moved& p, const Moved& q, const Moved& r) {
  const Complex between = q.at - p.at, w = (r.at - p.at) / between;
  Moved third;
  third.at = at_p.at + (at_q.at - at_p.at) * w;
  for (int i = 0; i < measure_count; ++i) {
    const Complex dw = (r.by[i] - p.by[i] - w * (q.by[i] - p.by[i])) / between;
    third.by[i] = at_p.by[i] + (at_q.by[i] - at_p.by[i]) * w + (at_q.at - at_p.at) * dw;
  }
  return third;
}

/// A moved place for each joint.
class MovedPose {
 public:
  Moved& operator[](Joint joint) { return places_[static_cast<std::size_t>(joint)]; }
  const Moved& operator[](Joint joint) const { return places_[static_cast<std::size_t>(joint)]; }

 private:
  std::array<Moved, 6> places_{};
};

/// Closes the loops from two known joints of V, X, Y, each loop one dyad; returns the fault or nothing.
class Closure {
 public:
  Closure(const Instrument& instrument, const Measures& measures)
      : own_(measures), one_(plate_1(own_)), two_(plate_2(own_)), sides_(instrument.sides) {}

  tl::expected<MovedPose, ClosureFault> from(Joint unknown, const MovedPose& known) {
    pose_ = known;
    const bool closed = unknown == Joint::V ? from_XY() : unknown == Joint::Y ? from_VX() : from_VY();
    if (!closed) return tl::unexpected(fault_);
    return pose_;
  }

 private:
  bool from_XY() {
    if (!put(pose_[Joint::C], dyad(pose_[Joint::X], pose_[Joint::Y], own_.length(Measure::CX),
                                   own_.length(Measure::CY), sides_.C_of_XY)))
      return false;
    pose_[Joint::A] = third_of_plate(pose_[Joint::C], pose_[Joint::X], one_.C, one_.outer, one_.middle);
    pose_[Joint::B] = third_of_plate(pose_[Joint::C], pose_[Joint::Y], two_.C, two_.outer, two_.middle);
    return put(pose_[Joint::V], dyad(pose_[Joint::A], pose_[Joint::B], VA(), VB(), sides_.V_of_AB));
  }
  bool from_VX() {
    if (!put(pose_[Joint::A],
             dyad(pose_[Joint::V], pose_[Joint::X], VA(), distance(one_.middle, one_.outer), sides_.A_of_VX)))
      return false;
    pose_[Joint::C] = third_of_plate(pose_[Joint::A], pose_[Joint::X], one_.middle, one_.outer, one_.C);
    if (!put(pose_[Joint::B],
             dyad(pose_[Joint::V], pose_[Joint::C], VB(), distance(two_.C, two_.middle), sides_.B_of_VC)))
      return false;
    pose_[Joint::Y] = third_of_plate(pose_[Joint::C], pose_[Joint::B], two_.C, two_.middle, two_.outer);
    return true;
  }
  bool from_VY() {
    if (!put(pose_[Joint::B],
             dyad(pose_[Joint::V], pose_[Joint::Y], VB(), distance(two_.middle, two_.outer), sides_.B_of_VY)))
      return false;
    pose_[Joint::C] = third_of_plate(pose_[Joint::B], pose_[Joint::Y], two_.middle, two_.outer, two_.C);
    if (!put(pose_[Joint::A],
             dyad(pose_[Joint::V], pose_[Joint::C], VA(), distance(one_.C, one_.middle), sides_.A_of_VC)))
      return false;
    pose_[Joint::X] = third_of_plate(pose_[Joint::C], pose_[Joint::A], one_.C, one_.middle, one_.outer);
    return true;
  }
  bool put(Moved& joint, const Closed& closed) {
    if (closed) {
      joint = *closed;
    } else {
      fault_ = closed.error();
    }
    return closed.has_value();
  }
  MovedLength VA() const { return own_.length(Measure::VA); }
  MovedLength VB() const { return own_.length(Measure::VB); }

  Own own_;
  Plate one_, two_;
  DyadSides sides_;
  MovedPose pose_{};
  ClosureFault fault_ = ClosureFault::flat;
};

tl::expected<MovedPose, ClosureFault> closed_pose(const Instrument& instrument, const Measures& measures,
                                                  const Point& input) {
  MovedPose known;
  known[instrument.mounting.pole] = Own(measures).place(Measure::pole_x, Measure::pole_y);
  known[instrument.mounting.input] = fixed(input);
  return Closure(instrument, measures).from(instrument.mounting.output, known);
}

/// Place on the table to place in the reading frame.
Output read_in_frame(const Moved& output, const Measures& measures) {
  const Complex origin{measures[index_of(Measure::origin_x)], measures[index_of(Measure::origin_y)]};
  const Complex back = std::polar(1.0, -measures[index_of(Measure::turn)]);
  const Complex at = back * (output.at - origin);
  Eigen::Matrix<Complex, 1, measure_count> by = back * output.by;
  by[index_of(Measure::origin_x)] -= back;
  by[index_of(Measure::origin_y)] -= back * Complex(0, 1);
  by[index_of(Measure::turn)] -= Complex(0, 1) * at;
  Output read;
  read.at = as_point(at);
  read.by.row(0) = by.real();
  read.by.row(1) = by.imag();
  return read;
}

DyadSides sides_of(const Pose& pose) {
  const auto side = [&](Joint from, Joint to, Joint point) {
    return dyad_side(as_complex(pose[from]), as_complex(pose[to]), as_complex(pose[point]));
  };
  return {.C_of_XY = side(Joint::X, Joint::Y, Joint::C),
          .V_of_AB = side(Joint::A, Joint::B, Joint::V),
          .A_of_VX = side(Joint::V, Joint::X, Joint::A),
          .B_of_VC = side(Joint::V, Joint::C, Joint::B),
          .B_of_VY = side(Joint::V, Joint::Y, Joint::B),
          .A_of_VC = side(Joint::V, Joint::C, Joint::A)};
}

/// The place of `point` along and across the line from `from` to `to`.
Complex along(Complex from, Complex to, Complex point) {
  return (point - from) / ((to - from) / std::abs(to - from));
}

}  // namespace

std::string_view name(Measure measure) {
  static constexpr std::array<std::string_view, measure_count> names{
      "VA",       "VB",     "AX",     "CX",       "offset_A", "BC",  "CY",
      "offset_B", "pole_x", "pole_y", "origin_x", "origin_y", "turn"};
  return names[static_cast<std::size_t>(measure)];
}

std::string_view name(ClosureFault fault) {
  switch (fault) {
    case ClosureFault::too_far: return "beyond the reach of the links";
    case ClosureFault::too_near: return "nearer than the links can fold";
    case ClosureFault::flat: break;
  }
  return "at a dead point or the change point";
}

Instrument Instrument::mounted(const Mounting& other) const {
  Instrument instrument = *this;
  instrument.mounting = other;
  // With pole O, input T and output P:  z_P - z_O = k (z_T - z_O). V, X, Y are at 0, 1, s of their triangle.
  const Complex place_of_output = ratio;
  const auto place = [&](Joint joint) {
    return joint == mounting.pole ? Complex(0) : joint == mounting.input ? Complex(1) : place_of_output;
  };
  instrument.ratio = (place(other.output) - place(other.pole)) / (place(other.input) - place(other.pole));
  return instrument;
}

Instrument Instrument::exchanged() const {
  return mounted({.pole = mounting.pole, .input = mounting.output, .output = mounting.input});
}

Instrument instrument_of(const CopyingLinkage& linkage) {
  Instrument instrument;
  instrument.mounting = {linkage.pole_joint(), linkage.tracer_joint(), linkage.pen_joint()};
  instrument.ratio = linkage.k();
  const Pose pose = linkage.pose_at(linkage.assembly_mode().openings.middle(), 0);
  instrument.sides = sides_of(pose);
  const Complex A = along(as_complex(pose.X), as_complex(pose.C), as_complex(pose.A));
  const Complex B = along(as_complex(pose.C), as_complex(pose.Y), as_complex(pose.B));
  const LinkLengths lengths = linkage.lengths();
  // The frame of plate 1 runs from C to X: seen from there the offset of A changes its sign, as does its
  // direction.
  instrument.drawn << lengths.VA, lengths.VB, A.real(), lengths.CX, -A.imag(), B.real(), lengths.CY, B.imag(),
      linkage.pole().x(), linkage.pole().y(), 0, 0, 0;
  if (is_straight(linkage.shape())) instrument.drawn[index_of(Measure::offset_A)] = 0;
  if (is_straight(linkage.shape())) instrument.drawn[index_of(Measure::offset_B)] = 0;
  return instrument;
}

Instrument variable_ratio_instrument(double arm, double ratio) {
  Instrument instrument;
  instrument.mounting = {.pole = Joint::X, .input = Joint::Y, .output = Joint::V};
  instrument.ratio = ratio;
  instrument.drawn << ratio * arm, (1 - ratio) * arm, ratio * arm, arm, 0, ratio * arm, arm, 0, 0, 0, 0, 0, 0;
  const Complex X = 0, C = std::polar(arm, pi / 4), Y = 2 * C.real();
  const Complex A = ratio * C, B = C + ratio * (Y - C), V = ratio * Y;
  instrument.sides = sides_of({as_point(V), as_point(A), as_point(B), as_point(C), as_point(X), as_point(Y)});
  return instrument;
}

tl::expected<Output, ClosureFault> output_at(const Instrument& instrument, const Measures& measures,
                                             const Point& input) {
  const auto pose = closed_pose(instrument, measures, input);
  if (!pose) return tl::unexpected(pose.error());
  return read_in_frame((*pose)[instrument.mounting.output], measures);
}

Point wanted_output(const Instrument& instrument, const Point& input) {
  const Measures& drawn = instrument.drawn;
  const Complex pole{drawn[index_of(Measure::pole_x)], drawn[index_of(Measure::pole_y)]};
  Moved output;
  output.at = pole + instrument.ratio * (as_complex(input) - pole);
  return read_in_frame(output, drawn).at;
}

tl::expected<Pose, ClosureFault> pose_of(const Instrument& instrument, const Measures& measures,
                                         const Point& input) {
  const auto closed = closed_pose(instrument, measures, input);
  if (!closed) return tl::unexpected(closed.error());
  Pose pose;
  for (const Joint joint : all_joints) pose[joint] = as_point((*closed)[joint].at);
  return pose;
}

MeasuredLengths lengths_of(const Measures& measures) {
  const Own own(measures);
  const Plate one = plate_1(own), two = plate_2(own);
  const std::array<MovedLength, 8> all{own.length(Measure::VA),         own.length(Measure::VB),
                                       distance(one.C, one.middle),     distance(two.C, two.middle),
                                       distance(one.middle, one.outer), own.length(Measure::CX),
                                       distance(two.middle, two.outer), own.length(Measure::CY)};
  MeasuredLengths lengths;
  for (int i = 0; i < 8; ++i) {
    lengths.values[i] = all[static_cast<std::size_t>(i)].value;
    lengths.by.row(i) = all[static_cast<std::size_t>(i)].by;
  }
  return lengths;
}

bool is_straight(const Instrument& instrument) {
  return instrument.drawn[index_of(Measure::offset_A)] == 0 &&
         instrument.drawn[index_of(Measure::offset_B)] == 0;
}

}  // namespace kempe
