#include "kinematics/mobility.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "kinematics/planar_equations.hpp"
#include "kinematics/planar_solver.hpp"

namespace kempe {
namespace {

constexpr double rank_threshold = 1e-6;  ///< of the largest singular value
constexpr double first_motion = 2e-2;    ///< sizes: away from singular positions
constexpr double second_motion = 1e-4;   ///< sizes: around the general position
constexpr double followed = 3e-2;        ///< share of the second motion that counts as finite

double uniform(std::mt19937_64& random) { return 2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1; }

/// The equations with every unknown and every row a length.
Eigen::MatrixXd scaled_jacobian(const PlanarLinkage& linkage, const Eigen::VectorXd& q) {
  PlanarEquations equations(linkage);
  Eigen::VectorXd f;
  Eigen::MatrixXd jacobian;
  equations.residual_and_jacobian(q, f, jacobian);
  for (Eigen::Index angle = 2; angle < q.size(); angle += 3) jacobian.col(angle) /= equations.size();
  return jacobian;
}

int rank_of(const Eigen::MatrixXd& matrix) {
  if (matrix.rows() == 0 || matrix.cols() == 0) return 0;
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix);
  svd.setThreshold(rank_threshold);
  return static_cast<int>(svd.rank());
}

/// A closed position near q, each unknown first moved by up to `way` sizes; q itself if none is found.
Eigen::VectorXd near(const PlanarLinkage& linkage, const Eigen::VectorXd& q, double way,
                     std::mt19937_64& random) {
  const double size = linkage.size();
  Eigen::VectorXd moved = q;
  for (Eigen::Index i = 0; i < q.size(); ++i) moved[i] += way * uniform(random) * (i % 3 == 2 ? 1 : size);
  const auto closed = solve_from(linkage, position_of(moved));
  return closed ? unknowns_of(closed->position) : q;
}

Eigen::VectorXd general_position(const PlanarLinkage& linkage, const Eigen::VectorXd& q,
                                 std::mt19937_64& random) {
  Eigen::VectorXd best = q;
  int best_rank = rank_of(scaled_jacobian(linkage, q));
  for (int i = 0; i < 6; ++i) {
    const Eigen::VectorXd candidate = near(linkage, q, first_motion, random);
    const int rank = rank_of(scaled_jacobian(linkage, candidate));
    if (rank > best_rank || (i == 0 && rank == best_rank)) {
      best = candidate;
      best_rank = rank;
    }
  }
  return best;
}

/// Dimension of the set of closed positions around q: directions in which positions near it really lie.
int finite_freedoms(const PlanarLinkage& linkage, const Eigen::VectorXd& q, int at_most,
                    std::mt19937_64& random) {
  if (at_most == 0) return 0;
  const int samples = 3 * at_most + 4;
  Eigen::MatrixXd ways(q.size(), samples);
  for (int i = 0; i < samples; ++i) {
    ways.col(i) = near(linkage, q, second_motion, random) - q;
    for (Eigen::Index unknown = 0; unknown < q.size(); ++unknown)
      if (unknown % 3 != 2) ways(unknown, i) /= linkage.size();
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(ways);
  const double least = followed * second_motion * std::sqrt(static_cast<double>(samples) / 3);
  int freedoms = 0;
  for (const double value : svd.singularValues()) freedoms += value > least ? 1 : 0;
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

/// The left null space in echelon form: each vector as the set of constraints that it combines. Later rows
/// are eliminated first, so that each set is small and ends with the constraint that closed it.
std::vector<std::vector<int>> dependent_sets(const Eigen::MatrixXd& jacobian,
                                             const std::vector<int>& constraint_of) {
  std::vector<std::vector<int>> result;
  std::vector<int> independent;
  for (int row = 0; row < jacobian.rows(); ++row) {
    std::vector<int> with = independent;
    with.push_back(row);
    if (rank_of(jacobian(with, Eigen::all)) == static_cast<int>(with.size())) {
      independent = with;
      continue;
    }
    const Eigen::MatrixXd columns = jacobian(independent, Eigen::all).transpose();
    const Eigen::VectorXd weights =
        independent.empty()
            ? Eigen::VectorXd()
            : Eigen::VectorXd(columns.colPivHouseholderQr().solve(jacobian.row(row).transpose()));
    std::set<int> constraints{constraint_of[static_cast<std::size_t>(row)]};
    for (Eigen::Index i = 0; i < weights.size(); ++i)
      if (std::abs(weights[i]) > 1e-5)
        constraints.insert(constraint_of[static_cast<std::size_t>(independent[static_cast<std::size_t>(i)])]);
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

}  // namespace

Mobility mobility_of(const PlanarLinkage& driven, const PlanarPosition& closed, std::uint64_t seed) {
  const PlanarLinkage linkage = driven.undriven();
  Mobility result;
  result.particles = linkage.particle_count();
  result.links = linkage.body_count() - result.particles;
  for (const auto& [name, constraint] : linkage.constraints())
    (equation_count(constraint) == 2 ? result.full_joints : result.half_joints) += 1;
  result.half_joints -= result.particles;
  result.unknowns = linkage.unknown_count() - result.particles;
  result.equations = linkage.equation_count() - result.particles;
  result.gruebler = result.unknowns - result.equations;
  std::mt19937_64 random(seed);
  const Eigen::VectorXd q = unknowns_of(closed);
  const Eigen::VectorXd general = general_position(linkage, q, random);
  const Eigen::MatrixXd here = scaled_jacobian(linkage, q), there = scaled_jacobian(linkage, general);
  result.rank_here = rank_of(here) - result.particles;
  result.rank = rank_of(there) - result.particles;
  result.mobility = finite_freedoms(linkage, general, result.unknowns - result.rank, random);
  result.redundant = dependent_sets(there, constraint_of_row(driven));
  if (result.singular_here()) result.dependent_here = dependent_sets(here, constraint_of_row(driven));
  return result;
}

NumberSynthesis number_synthesis(int links, int freedoms) {
  NumberSynthesis result;
  const int twice_joints = 3 * (links - 1) - freedoms;
  if (links < 2 || freedoms < 0 || twice_joints <= 0 || twice_joints % 2 != 0) return result;
  result.joints = twice_joints / 2;
  result.largest_link = links / 2;
  std::vector<LinkAssortment> all;
  const int excess = twice_joints - 2 * links;
  if (excess < 0) return result;
  std::vector<int> count(static_cast<std::size_t>(excess) + 1, 0);
  choose(excess + 2, links, excess, count, all);
  for (LinkAssortment& assortment : all) {
    while (assortment.count.size() > 1 && assortment.count.back() == 0) assortment.count.pop_back();
    const bool fits = static_cast<int>(assortment.count.size()) + 1 <= std::max(2, result.largest_link);
    (fits ? result.assortments : result.too_large).push_back(assortment);
  }
  return result;
}

}  // namespace kempe
