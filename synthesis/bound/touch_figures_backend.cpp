#include "kinematics/grounding.hpp"
#include "synthesis/bound/contact.hpp"
#include "synthesis/bound/touch_figures.hpp"

namespace kempe::bounding {
namespace {

// Seen from V, with p along x, a point stands at of_a a + of_b b e^{i psi}, a^2 = w / 2t, b^2 = w t / 2, 2 a b = w.
std::optional<FirstOrder> contact_figure_at(const BoxMiddle& middle, const ContactTouch& touch,
                                            const FirstOrder& cosine, const PsiThere& psi) {
  if (psi.sines.inf() <= 0) return std::nullopt;
  const IntervalComplex of_a = widened(touch.first.of_a) - widened(touch.second.of_a),
                        of_b = widened(touch.first.of_b) - widened(touch.second.of_b);
  const IntervalComplex turn = IntervalComplex{of_a.re, -of_a.im} * of_b;
  const FirstOrder t = middle.t_itself();
  const FirstOrder per_t = function_of(Interval(-1) * middle.log_t(), 1.0 / t.middle, 1.0 / t.middle,
                                       1.0 / whole(middle.box.lengths.t));
  const FirstOrder w =
      function_of(middle.log_w(), Interval(middle.w), Interval(middle.w), whole(middle.box.lengths.w));
  const FirstOrder square = w * (Interval(0.5) * (squared_length(of_a) * per_t + squared_length(of_b) * t) +
                                 turn.re * cosine - (middle.mode.bend * turn.im) * sine_of(cosine, psi));
  return constant(Interval(1)) - 1.0 / CGAL::square(Interval(touch.needed)) * square;
}

/// Where the joints of the designs stand in the table's frame with the tracer at a place: Z = O + (T - O) M(rho), as in joint_moves.hpp.
class JointsThere {
 public:
  /// The sines of psi must be above 0.
  JointsThere(const BoxMiddle& middle, const Point& place, const ReachedPlace& reached, const PsiThere& psi)
      : mode_(middle.mode), roles_(roles_of(middle.mode.grounding)) {
    const FirstOrder t = middle.t_itself();
    rho_ = t * FirstOrderComplex{reached.cosine, Interval(mode_.bend) * sine_of(reached.cosine, psi)};
    pole_ = constant(exactly(as_complex(middle.pole))) + FirstOrderComplex{middle.pole_x(), middle.pole_y()};
    arm_ = constant(exactly(as_complex(place))) - pole_;
    // |D|^2 = r^2 / a^2 = 2 t r^2 / w
    const Interval twice_per_c2 = 2.0 / CGAL::square(widened(mode_.chain));
    const FirstOrder log = middle.log_t() + reached.log_square;
    const Interval value = 1.0 / (twice_per_c2 * t.middle * reached.square),
                   values = 1.0 / (twice_per_c2 * whole(middle.box.lengths.t) * reached.squares);
    FirstOrder from_middle = log;
    from_middle.middle = Interval(0);
    per_D_ = function_of(from_middle, value, -value, values) * conjugate(from_pole(roles_.tracer));
  }

  FirstOrderComplex operator[](Joint joint) const { return pole_ + arm_ * (from_pole(joint) * per_D_); }

 private:
  FirstOrderComplex from_pole(Joint joint) const {
    const MaterialPoint at = material_point(joint, mode_.s), ground = material_point(roles_.pole, mode_.s);
    return constant(widened(at.of_a) - widened(ground.of_a)) +
           (widened(at.of_b) - widened(ground.of_b)) * rho_;
  }

  const ModeFacts& mode_;
  JointRoles roles_;
  FirstOrderComplex rho_, pole_, arm_, per_D_;
};

FirstOrder dot(const FirstOrderComplex& u, const FirstOrderComplex& v) { return u.re * v.re + u.im * v.im; }
FirstOrder cross(const FirstOrderComplex& u, const FirstOrderComplex& v) { return u.re * v.im - u.im * v.re; }

/// A corner from an edge, on its side of the edge's line. Nothing where in some design the foot of the corner may lie beyond the edge's ends.
std::optional<FirstOrder> height_over(const FirstOrderComplex& edge, const FirstOrderComplex& corner,
                                      double side) {
  const FirstOrder square = dot(edge, edge);
  const Interval foot = dot(edge, corner).all(), length = square.all();
  if (length.inf() <= 0 || foot.inf() < 0 || foot.sup() > length.inf()) return std::nullopt;
  return Interval(side) * (cross(edge, corner) * inverse_root(square));
}

std::optional<FirstOrder> distance_between(const FirstOrderComplex& one, const FirstOrderComplex& other) {
  const FirstOrderComplex apart = one - other;
  const FirstOrder square = dot(apart, apart);
  return square.all().inf() > 0 ? std::optional(root(square)) : std::nullopt;
}

std::optional<FirstOrder> distance_of(const ObstacleTouch& touch, const JointsThere& joints) {
  const auto of_part = [&](std::size_t i) {
    return touch.seen_from ? joints[touch.joints[i]] - joints[*touch.seen_from] : joints[touch.joints[i]];
  };
  const auto fixed = [&](std::size_t i) { return constant(exactly(touch.fixed[i])); };
  if (!touch.is_edge) return distance_between(of_part(0), fixed(0));
  if (touch.corner_is_of_part) return height_over(fixed(1) - fixed(0), of_part(0) - fixed(0), touch.side);
  const FirstOrderComplex from = of_part(0);
  return height_over(of_part(1) - from, fixed(0) - from, touch.side);
}

}  // namespace

std::optional<FirstOrder> contact_figure(const BoxMiddle& middle, const ContactTouch& touch,
                                         const Point& near, const Point& far) {
  if (touch.at == ContactTouch::At::psi)
    return contact_figure_at(middle, touch, constant(cosine(Interval(touch.psi))),
                             PsiThere::about({touch.psi, touch.psi}, touch.psi));
  const auto there = reached(middle, touch.at == ContactTouch::At::near ? near : far);
  const auto psi = there ? psi_at(middle, *there) : std::nullopt;
  return psi ? contact_figure_at(middle, touch, there->cosine, *psi) : std::nullopt;
}

// The corner may also lie a little behind the edge: while it is nearer to it than `needed`, it is too near all the same.
std::optional<FirstOrder> obstacle_figure(const BoxMiddle& middle, const ObstacleTouch& touch) {
  const auto there = reached(middle, touch.place);
  const auto psi = there ? psi_at(middle, *there) : std::nullopt;
  if (!psi || psi->sines.inf() <= 0) return std::nullopt;
  const auto distance = distance_of(touch, JointsThere(middle, touch.place, *there, *psi));
  if (!distance || distance->all().inf() <= -touch.needed) return std::nullopt;
  return constant(Interval(1)) - 1.0 / Interval(touch.needed) * *distance;
}

}  // namespace kempe::bounding
