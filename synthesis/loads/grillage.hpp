#pragma once
// A grillage: slender beams in a plane that is loaded at right angles to it, joined by pins that let links turn in the plane and
// hold them out of it.
//
// Its unknowns are the rise of every joint and the slopes (by x and by y) of every link at every joint that it has. A beam bends as
// Euler and Bernoulli have it and twists as Saint-Venant has it. A pin gives all its links one rise and resists a difference of their
// slopes: so many N mm a radian in every direction of tilt.

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/point.hpp"

namespace kempe {

class Elimination;

/// A straight piece of a link between two of its nodes.
struct GrillageBeam {
  int from = 0, to = 0;  ///< nodes at different places
  double bending = 0;    ///< E I, N mm^2, > 0: of bending out of the plane
  double torsion = 0;    ///< G J, N mm^2, > 0
  double weight = 0;     ///< N/mm, spread evenly, downwards
};

/// What joins two links out of the plane, or a link and the ground.
struct GrillagePin {
  int node = 0;
  std::optional<int>
      other{};  ///< a node of the same joint; absent: the ground, which also holds the joint's height
  double stiffness = 0;  ///< N mm/rad, > 0
  /// The pin, by its number, as which this one goes on beyond `node`, which is that one's `other`. The link there then bears what the two pass
  /// on between them.
  std::optional<int> goes_on{};
};

/// The structure and its loads.
struct GrillagePlan {
  std::vector<Complex> joints;  ///< where, mm
  std::vector<double> weights;  ///< N at each joint, downwards
  std::vector<int>
      nodes;  ///< a link at one of its joints, for every link and joint of it: the joint's number
  std::vector<GrillageBeam> beams;  ///< that make up the links
  std::vector<GrillagePin> pins;    ///< enough of them to hold everything

  /// Where a node is, mm.
  Complex place(int node) const { return joints[static_cast<std::size_t>(joint(node))]; }
  /// Its joint.
  int joint(int node) const { return nodes[static_cast<std::size_t>(node)]; }
};

/// How a grillage stands under its loads.
struct GrillageState {
  Eigen::VectorXd rises;      ///< mm at each joint, upwards
  Eigen::VectorXd reactions;  ///< N at each joint, upwards; 0 where nothing stands under it
  Eigen::VectorXd slopes;     ///< of the nodes, by x and by y: two rows a node
};

/// A grillage with its equations factored, for any load. A value.
class Grillage {
 public:
  /// `props`: joints that stand on something which holds their height, from below and from above. Where rounding leaves less than six
  /// digits of the movements under a load, as with arms far shorter than the others, every figure of that load is NaN.
  Grillage(const GrillagePlan& plan, const std::vector<int>& props);

  /// Under its weights and `extra`, N at each joint, downwards; empty: none.
  GrillageState loaded(const std::vector<double>& extra = {}) const;
  /// For each pin the moment between it and the link of its `node` where a joint is pushed down by 1 N, N mm. By reciprocity that is how far the
  /// joint drops, mm, if that link may tilt on the pin by 1 rad in the worst direction.
  std::vector<double> drop_by_tilt(int joint) const;
  /// How it stands under couples alone, as GrillageState: one column for each load.
  struct Tilted {
    Eigen::MatrixXd rises, reactions, slopes;
  };
  /// `couples`: two rows a node, N mm, that do work on its slopes by x and by y; one column for each load. Slopes in the same rows.
  Tilted tilted_by(const Eigen::MatrixXd& couples) const;

 private:
  friend class NearbyDrop;
  struct ScaledBeam;
  ScaledBeam scaled(const GrillagePlan& plan, const GrillageBeam& beam) const;
  /// test . (weight of the forces - K moved) of another plan, without its pins: what is out of balance there, and does work on `test`.
  double imbalance(const GrillagePlan& plan, const Eigen::VectorXd& test, const Eigen::VectorXd& moved,
                   bool weighs) const;
  int slope(int node, int axis) const { return joints_ + 2 * node + axis; }
  void add_beam(const GrillagePlan& plan, const GrillageBeam& beam);
  void add_pin(const GrillagePlan& plan, const GrillagePin& pin, int number);
  /// The moment between a pin, by its number, and the link of its node, in units of the equations.
  Eigen::Vector2d borne(const Eigen::VectorXd& moved, std::size_t pin) const;
  Eigen::Index moment(int pin) const { return first_moment_ + 2 * Eigen::Index{pin}; }
  Eigen::VectorXd moved_by(Eigen::VectorXd forces) const;
  /// What holds the joints up, N upwards; 0 where nothing does.
  Eigen::VectorXd reactions(const Eigen::VectorXd& moved, const Eigen::VectorXd& forces) const;

  int joints_ = 0, first_moment_ = 0;  ///< unknowns: rises, slopes, then the pins' moments
  double scale_ =
      1;  ///< mm; slopes are counted in rises over this length, so that all unknowns are of one size
  double unit_ = 1;  ///< N/mm; moments are counted in this times scale_
  std::vector<bool> held_;
  std::vector<std::optional<int>> goes_on_;     ///< of each pin
  Eigen::MatrixXd balance_, free_;              ///< the equations, without and with held joints
  std::shared_ptr<const Elimination> factors_;  ///< of `free_`
  Eigen::VectorXd weights_;
};

/// What bends and twists the beams of a plan that stands so, N mm; for each column of `rises` (a row a joint) and `slopes` (two a node) one,
/// three rows a beam: bending at `from` and at `to`, E I times the curvature of the rise, positive where it is bent upwards, and twist.
/// Between the ends bending is a straight line, and where it `weighs` (it moved by its weight, q a mm) q L^2 x (1 - x) / 2 more at x of its
/// length L. A column that rounding leaves less than six digits of its largest moment is NaN.
Eigen::MatrixXd beam_moments(const GrillagePlan& plan, const Eigen::MatrixXd& rises,
                             const Eigen::MatrixXd& slopes, bool weighs);

/// How far a joint of a grillage drops, by weight and by a tilt of every pin the worst way, in grillages that differ a little from this one:
/// the same links, pins and props at slightly other places. Exact to first order (adjoint method): one solution gives the slopes by
/// every variable.
class NearbyDrop {
 public:
  /// `tilt`: rad, of every pin. Refers to the grillage.
  NearbyDrop(const Grillage& grillage, int joint, double tilt);
  /// mm, to first order, but for a constant.
  double estimate(const GrillagePlan& plan) const;

 private:
  const Grillage& grillage_;
  Eigen::VectorXd pushed_, moved_, tilted_;  ///< by 1 N on the joint; by the weights; by the pins' tilts
};

/// The grillage on props that can push but not pull.
struct StandingGrillage {
  Grillage grillage;
  GrillageState state;
  std::vector<int> props;  ///< that bear; from the others the joint is lifted off
};
/// `props`: joints that stand on something, from which they may be lifted off. The props that bear are those that all push, with no other
/// joint below its prop; where rounding leaves no such set, the least wrong one. Figures may be NaN, as those of Grillage.
StandingGrillage standing(const GrillagePlan& plan, const std::vector<int>& props);

}  // namespace kempe
