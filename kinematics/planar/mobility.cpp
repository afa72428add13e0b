#include "kinematics/planar/mobility.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "geometry/chance.hpp"
#include "geometry/decompositions.hpp"
#include "kinematics/planar/equations.hpp"
#include "kinematics/planar/slack.hpp"
#include "kinematics/planar/solver.hpp"

namespace kempe {
namespace {

/// The derivatives of the equations, without units.
Eigen::MatrixXd scaled_jacobian(const PlanarLinkage& linkage, const Eigen::VectorXd& q) {
  PlanarEquations equations(linkage);
  Eigen::VectorXd f;
  Eigen::MatrixXd jacobian;
  equations.residual_and_jacobian(q, f, jacobian);
  return equations.dimensionless(std::move(jacobian));
}

int rank_of(const Eigen::MatrixXd& matrix) {
  if (matrix.rows() == 0 || matrix.cols() == 0) return 0;
  const Eigen::VectorXd values = singular_values_of(matrix);
  return static_cast<int>((values.array() > slack::rank_threshold * values[0]).count());
}

/// A closed position near q, each unknown first moved by up to `way` sizes; q itself if none is found.
Eigen::VectorXd near(const PlanarLinkage& linkage, const Eigen::VectorXd& q, double way, Chance& chance) {
  const double size = linkage.size();
  Eigen::VectorXd moved = q;
  for (Eigen::Index i = 0; i < q.size(); ++i) moved[i] += way * chance.symmetric() * (i % 3 == 2 ? 1 : size);
  const auto closed = solve_from(linkage, position_of(moved));
  return closed ? unknowns_of(closed->position) : q;
}

Eigen::VectorXd general_position(const PlanarLinkage& linkage, const Eigen::VectorXd& q, Chance& chance) {
  Eigen::VectorXd best = q;
  int best_rank = rank_of(scaled_jacobian(linkage, q));
  for (int i = 0; i < 6; ++i) {
    const Eigen::VectorXd candidate = near(linkage, q, slack::first_motion, chance);
    const int rank = rank_of(scaled_jacobian(linkage, candidate));
    if (rank > best_rank || (i == 0 && rank == best_rank)) {
      best = candidate;
      best_rank = rank;
    }
  }
  return best;
}

/// Dimension of the set of closed positions around q: directions in which positions near it really lie.
int finite_freedoms(const PlanarLinkage& linkage, const Eigen::VectorXd& q, int at_most, Chance& chance) {
  if (at_most == 0) return 0;
  const int samples = 3 * at_most + 4;
  Eigen::MatrixXd ways(q.size(), samples);
  for (int i = 0; i < samples; ++i) {
    ways.col(i) = near(linkage, q, slack::second_motion, chance) - q;
    for (Eigen::Index unknown = 0; unknown < q.size(); ++unknown)
      if (unknown % 3 != 2) ways(unknown, i) /= linkage.size();
  }
  const double least = slack::followed * slack::second_motion * std::sqrt(static_cast<double>(samples) / 3);
  const auto freedoms = static_cast<int>((singular_values_of(ways).array() > least).count());
  return std::min(freedoms, at_most);
}

/// For each row of the undriven linkage, the number of its constraint in the driven one.
std::vector<int> constraint_of_row(const PlanarLinkage& driven) {
  std::vector<int> result;
  for (int i = 0; i < static_cast<int>(driven.constraints().size()); ++i)
    if (!driven.is_driver(i))
      result.insert(result.end(),
                    static_cast<std::size_t>(
                        equation_count(driven.constraints()[static_cast<std::size_t>(i)].constraint)),
                    i);
  return result;
}

/// Rows that no row before them implies: an orthonormal basis of them, and for a row that is implied the weights.
class IndependentRows {
 public:
  explicit IndependentRows(const Eigen::MatrixXd& rows)
      : basis_(rows.cols(), std::min(rows.rows(), rows.cols())), weights_(basis_.cols(), basis_.cols()) {}

  /// Takes the row in and returns nothing; or how the rows taken add up to it.
  std::optional<Eigen::VectorXd> take(const Eigen::VectorXd& row) {
    Eigen::VectorXd rest = row, along = Eigen::VectorXd::Zero(count_);
    for (int twice = 0; twice < 2 && count_ > 0; ++twice) {
      const Eigen::VectorXd more = basis_.leftCols(count_).transpose() * rest;
      rest -= basis_.leftCols(count_) * more;
      along += more;
    }
    if (count_ == basis_.cols() || rest.norm() <= slack::rank_threshold * row.norm())
      return weights_.topLeftCorner(count_, count_).triangularView<Eigen::Upper>().solve(along);
    basis_.col(count_) = rest.normalized();
    weights_.col(count_).head(count_) = along;
    weights_(count_, count_) = rest.norm();
    ++count_;
    return std::nullopt;
  }

 private:
  Eigen::MatrixXd basis_, weights_;  ///< row k taken = basis * column k of weights
  Eigen::Index count_ = 0;
};

/// The left null space in echelon form: each vector as the set of constraints that it combines. Each set is small
/// and ends with the constraint that closed it.
std::vector<std::vector<int>> dependent_sets(const Eigen::MatrixXd& jacobian,
                                             const std::vector<int>& constraint_of) {
  std::vector<std::vector<int>> result;
  std::vector<int> taken;  // constraint of each independent row
  IndependentRows independent(jacobian);
  for (Eigen::Index row = 0; row < jacobian.rows(); ++row) {
    const int constraint = constraint_of[static_cast<std::size_t>(row)];
    const auto weights = independent.take(jacobian.row(row).transpose());
    if (!weights) {
      taken.push_back(constraint);
      continue;
    }
    std::set<int> constraints{constraint};
    for (Eigen::Index i = 0; i < weights->size(); ++i)
      if (std::abs((*weights)[i]) > slack::part_of_dependence)
        constraints.insert(taken[static_cast<std::size_t>(i)]);
    result.emplace_back(constraints.begin(), constraints.end());
  }
  return result;
}

/// Appends all ways to share out `excess` joint ends beyond two a link, to links with at most `order` joints.
void choose(int order, int links, int excess, std::vector<int>& count, std::vector<LinkAssortment>& result) {
  if (order == 2) {
    if (excess != 0) return;
    count[0] = links;
    result.push_back({count});
    return;
  }
  const int beyond = order - 2;
  for (int n = order == 3 ? excess : 0; n <= links && n * beyond <= excess; ++n) {
    count[static_cast<std::size_t>(beyond)] = n;
    choose(order - 1, links - n, excess - n * beyond, count, result);
  }
  count[static_cast<std::size_t>(beyond)] = 0;
}

/// True if some chain of these links has no stiff part. With F > 0 that is so whenever no link is too large. A stiff
/// chain (F = 0) falls into at most 3 (k - 1) pieces without its k largest links, which therefore have no more than
/// L + 4 (k - 1) joints together.
bool stays_movable(const LinkAssortment& assortment, int loops, int freedoms) {
  if (freedoms > 0) return true;
  int links = 0, joints = 0;
  for (int i = static_cast<int>(assortment.count.size()) - 1; i > 0; --i)
    for (int each = 0; each < assortment.count[static_cast<std::size_t>(i)]; ++each) {
      joints += i + 2;
      ++links;
      if (links > 1 && joints > loops + 4 * (links - 1)) return false;
    }
  return true;
}

/// Links that slide along a line of another without turning against it: a slot and a fixed angle of one pair of bodies.
int sliding_pairs_of(const PlanarLinkage& linkage) {
  std::multiset<std::set<int>> slots;
  for (const auto& [name, constraint] : linkage.constraints())
    if (const auto* slot = std::get_if<Coordinate>(&constraint))
      slots.insert({slot->point.body, slot->origin.body});
  int count = 0;
  for (const auto& [name, constraint] : linkage.constraints()) {
    const auto* angle = std::get_if<RelativeAngle>(&constraint);
    if (angle == nullptr || linkage.is_particle(angle->body)) continue;
    const auto found = slots.find({angle->body, angle->reference});
    if (found == slots.end()) continue;
    slots.erase(found);
    ++count;
  }
  return count;
}

}  // namespace

Mobility mobility_of(const PlanarLinkage& driven, const PlanarPosition& closed, std::uint64_t seed) {
  const PlanarLinkage linkage = driven.undriven();
  Mobility result;
  result.particles = linkage.particle_count();
  result.links = linkage.body_count() - result.particles;
  for (const auto& [name, constraint] : linkage.constraints())
    (equation_count(constraint) == 2 ? result.full_joints : result.half_joints) += 1;
  result.sliding_pairs = sliding_pairs_of(linkage);
  result.full_joints += result.sliding_pairs;
  result.half_joints -= result.particles + 2 * result.sliding_pairs;
  result.unknowns = linkage.unknown_count() - result.particles;
  result.equations = linkage.equation_count() - result.particles;
  result.gruebler = result.unknowns - result.equations;
  Chance chance(seed);
  const Eigen::VectorXd q = unknowns_of(closed);
  const Eigen::VectorXd general = general_position(linkage, q, chance);
  const Eigen::MatrixXd here = scaled_jacobian(linkage, q), there = scaled_jacobian(linkage, general);
  result.rank_here = rank_of(here) - result.particles;
  result.rank = rank_of(there) - result.particles;
  result.mobility = finite_freedoms(linkage, general, result.unknowns - result.rank, chance);
  result.redundant = dependent_sets(there, constraint_of_row(driven));
  if (result.singular_here()) result.dependent_here = dependent_sets(here, constraint_of_row(driven));
  return result;
}

NumberSynthesis number_synthesis(int links, int freedoms) {
  NumberSynthesis result;
  const int twice_joints = 3 * (links - 1) - freedoms;
  if (links < 2 || freedoms < 0 || twice_joints <= 0 || twice_joints % 2 != 0) return result;
  result.joints = twice_joints / 2;
  if (result.joints < links) return result;
  result.loops = result.joints - links + 1;
  result.largest_link = result.loops + std::min(result.loops, std::max(1, freedoms));
  std::vector<LinkAssortment> all;
  const int excess = twice_joints - 2 * links;
  std::vector<int> count(static_cast<std::size_t>(excess) + 1, 0);
  choose(excess + 2, links, excess, count, all);
  for (LinkAssortment& assortment : all) {
    while (assortment.count.size() > 1 && assortment.count.back() == 0) assortment.count.pop_back();
    if (static_cast<int>(assortment.count.size()) + 1 > result.largest_link)
      result.too_large.push_back(assortment);
    else
      (stays_movable(assortment, result.loops, freedoms) ? result.assortments : result.stiff)
          .push_back(assortment);
  }
  return result;
}

}  // namespace kempe
