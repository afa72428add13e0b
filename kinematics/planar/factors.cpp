#include "kinematics/planar/factors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kempe {
namespace {

using Index = Eigen::Index;

Index at(std::size_t i) { return static_cast<Index>(i); }

/// The joints of the square part as edges, and how far each body's place is from being eliminated.
struct Tree {
  std::vector<bool> reached;
  std::vector<PlanarEquations::Joint> edges;  ///< from a reached body `a` to a new body `b`, in order
};

Tree tree_of(const PlanarEquations& equations) {
  const auto bodies = static_cast<std::size_t>(equations.unknown_count()) / 3 + 1;
  Tree tree{std::vector<bool>(bodies, false), {}};
  const auto joints = equations.joints();
  const auto grow = [&] {
    for (bool grew = true; grew;) {
      grew = false;
      for (PlanarEquations::Joint joint : joints) {
        if (tree.reached[static_cast<std::size_t>(joint.b)]) std::swap(joint.a, joint.b);
        if (!tree.reached[static_cast<std::size_t>(joint.a)] ||
            tree.reached[static_cast<std::size_t>(joint.b)])
          continue;
        tree.reached[static_cast<std::size_t>(joint.b)] = grew = true;
        tree.edges.push_back(joint);
      }
    }
  };
  // What no joint holds to the ground grows from a body of its own, whose place stays an unknown.
  for (std::size_t root = 0; root < bodies; ++root) {
    if (tree.reached[root]) continue;
    tree.reached[root] = true;
    grow();
  }
  return tree;
}

}  // namespace

PlanarFactors::PlanarFactors(const PlanarEquations& equations) {
  choose_order(equations);
  pivot_.resize(at(pivots_.size()));
  place_.resize(at(pivots_.size()));
  left_.resize(at(kept_.size()));
  exchanged_.resize(kept_.size());
  eliminated_.resize(at(pivots_.size()), at(kept_.size()));
  reduced_.resize(at(kept_.size()), at(kept_.size()));
  for (const Row& row : pivots_) below_pivot_.emplace_back(row.earlier.size());
  for (const Row& row : others_) below_.emplace_back(row.earlier.size());
}

void PlanarFactors::choose_order(const PlanarEquations& equations) {
  const auto square = static_cast<std::size_t>(equations.unknown_count());
  std::vector<int>& number = number_;
  number.assign(square, -1);
  std::vector<bool> used(square, false);
  const auto add_pivot = [&](int row, int column, int parent) {
    Row pivot{row, column, {}};
    if (parent >= 0 && number[static_cast<std::size_t>(parent)] >= 0)
      pivot.earlier.push_back(number[static_cast<std::size_t>(parent)]);
    number[static_cast<std::size_t>(column)] = static_cast<int>(pivots_.size());
    used[static_cast<std::size_t>(row)] = true;
    pivots_.push_back(std::move(pivot));
  };
  for (const auto& edge : tree_of(equations).edges) {
    add_pivot(edge.row, 3 * edge.b - 3, 3 * edge.a - 3);
    add_pivot(edge.second_row, 3 * edge.b - 2, 3 * edge.a - 2);
  }
  for (std::size_t column = 0; column < square; ++column)
    if (number[column] < 0) {
      number[column] = -1 - static_cast<int>(kept_.size());
      kept_.push_back(static_cast<int>(column));
    }
  const auto columns = equations.columns_by_row();
  for (std::size_t row = 0; row < square; ++row) {
    if (used[row]) continue;
    Row other{static_cast<int>(row), -1, {}};
    for (const int column : columns[row])
      if (number[static_cast<std::size_t>(column)] >= 0)
        other.earlier.push_back(number[static_cast<std::size_t>(column)]);
    others_.push_back(std::move(other));
  }
}

void PlanarFactors::compute(const Eigen::MatrixXd& jacobian) {
  const auto take_row = [&](const Row& row, std::vector<double>& values, auto&& target) {
    for (Index j = 0; j < target.size(); ++j)
      target[j] = jacobian(row.row, kept_[static_cast<std::size_t>(j)]);
    for (std::size_t i = 0; i < row.earlier.size(); ++i) {
      values[i] = jacobian(row.row, pivots_[static_cast<std::size_t>(row.earlier[i])].column);
      target -= values[i] * eliminated_.row(row.earlier[i]);
    }
  };
  for (std::size_t k = 0; k < pivots_.size(); ++k) {
    pivot_[at(k)] = jacobian(pivots_[k].row, pivots_[k].column);
    take_row(pivots_[k], below_pivot_[k], eliminated_.row(at(k)));
    eliminated_.row(at(k)) *= pivot_[at(k)];  // its own inverse
  }
  for (std::size_t j = 0; j < others_.size(); ++j) take_row(others_[j], below_[j], reduced_.row(at(j)));
  factor_reduced();
}

/// Gaussian elimination with the largest pivot of each column. Written out: for some ten unknowns a general
/// library's blocks cost more than the work.
void PlanarFactors::factor_reduced() {
  const Index n = reduced_.rows();
  sign_ = 1;
  for (Index k = 0; k < n; ++k) {
    Index best = k;
    for (Index i = k + 1; i < n; ++i)
      if (std::abs(reduced_(i, k)) > std::abs(reduced_(best, k))) best = i;
    exchanged_[static_cast<std::size_t>(k)] = best;
    double* pivot_row = &reduced_(k, 0);
    if (best != k) {
      std::swap_ranges(pivot_row, pivot_row + n, &reduced_(best, 0));
      sign_ = -sign_;
    }
    const double pivot = pivot_row[k];
    if (pivot == 0 || !std::isfinite(pivot)) sign_ = 0;
    if (pivot < 0) sign_ = -sign_;
    pivot_row[k] = 1 / pivot;
    for (Index i = k + 1; i < n; ++i) {
      double* row = &reduced_(i, 0);
      if (row[k] == 0) continue;
      row[k] *= pivot_row[k];
      for (Index j = k + 1; j < n; ++j) row[j] -= row[k] * pivot_row[j];
    }
  }
}

/// x = S'^-1 x.
void PlanarFactors::solve_reduced(Eigen::VectorXd& x) const {
  const Index n = reduced_.rows();
  for (Index k = 0; k < n; ++k) std::swap(x[k], x[exchanged_[static_cast<std::size_t>(k)]]);
  for (Index i = 1; i < n; ++i)
    for (Index j = 0; j < i; ++j) x[i] -= reduced_(i, j) * x[j];
  for (Index i = n - 1; i >= 0; --i) {
    for (Index j = i + 1; j < n; ++j) x[i] -= reduced_(i, j) * x[j];
    x[i] *= reduced_(i, i);
  }
}

/// x = S'^-T x.
void PlanarFactors::solve_reduced_transposed(Eigen::VectorXd& x) const {
  const Index n = reduced_.rows();
  for (Index i = 0; i < n; ++i) {
    x[i] *= reduced_(i, i);
    for (Index j = i + 1; j < n; ++j) x[j] -= reduced_(i, j) * x[i];
  }
  for (Index i = n - 1; i > 0; --i)
    for (Index j = 0; j < i; ++j) x[j] -= reduced_(i, j) * x[i];
  for (Index k = n - 1; k >= 0; --k) std::swap(x[k], x[exchanged_[static_cast<std::size_t>(k)]]);
}

void PlanarFactors::solve(const Eigen::VectorXd& right, Eigen::VectorXd& result) {
  const auto remainder = [&](const Row& row, const std::vector<double>& values) {
    double rest = right[row.row];
    for (std::size_t i = 0; i < row.earlier.size(); ++i) rest -= values[i] * place_[row.earlier[i]];
    return rest;
  };
  for (std::size_t k = 0; k < pivots_.size(); ++k)
    place_[at(k)] = pivot_[at(k)] * remainder(pivots_[k], below_pivot_[k]);
  for (std::size_t j = 0; j < others_.size(); ++j) left_[at(j)] = remainder(others_[j], below_[j]);
  solve_reduced(left_);
  result.resize(at(number_.size()));
  for (std::size_t k = 0; k < pivots_.size(); ++k) {
    double place = place_[at(k)];
    for (Index j = 0; j < left_.size(); ++j) place -= eliminated_(at(k), j) * left_[j];
    result[pivots_[k].column] = place;
  }
  for (std::size_t j = 0; j < kept_.size(); ++j) result[kept_[j]] = left_[at(j)];
}

void PlanarFactors::inverse_row(Index unknown, Eigen::VectorXd& result) {
  const int number = number_[static_cast<std::size_t>(unknown)];
  place_.setZero();
  left_.setZero();
  if (number >= 0) {
    place_[number] = 1;
    left_ = -eliminated_.row(number);
  } else {
    left_[-1 - number] = 1;
  }
  solve_reduced_transposed(left_);
  result.resize(at(number_.size()));
  for (std::size_t j = 0; j < others_.size(); ++j) {
    result[others_[j].row] = left_[at(j)];
    for (std::size_t i = 0; i < others_[j].earlier.size(); ++i)
      place_[others_[j].earlier[i]] -= below_[j][i] * left_[at(j)];
  }
  for (std::size_t k = pivots_.size(); k-- > 0;) {
    const double value = pivot_[at(k)] * place_[at(k)];
    result[pivots_[k].row] = value;
    for (std::size_t i = 0; i < pivots_[k].earlier.size(); ++i)
      place_[pivots_[k].earlier[i]] -= below_pivot_[k][i] * value;
  }
}

}  // namespace kempe
