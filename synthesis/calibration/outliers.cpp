// Readings that stand out: what is left at a reading, judged by a fit that it has no part in.
//
// All is linear about a fit: residuals r (weighted) and slopes J. A set C of readings alone asks for the step
// d = -(J_C^T J_C)^-1 J_C^T r_C, and then of a reading i outside C
//   q_i = e^T (1 + J_i (J_C^T J_C)^-1 J_i^T)^-1 e,   e = r_i + J_i d,
// is chi-squared with 2 degrees of freedom in units of the noise if reading i is like the rest.
//   1. several wrong readings hide each other and inflate every yardstick taken from all: so the search begins at the set
//      of readings that agree best (least trimmed squares: many small subsets, each concentrated);
//   2. from there the others are admitted, nearest first, while they could be like the rest;
//   3. those that chance would keep out less than once in a thousand fits stay out: they are named.
// The yardstick is the stated noise; only where those that agree best already contradict it, or where none is stated, it is
// what they leave themselves (then q_i / 2 over their mean square has Fisher's distribution).

#include "synthesis/calibration/outliers.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "synthesis/calibration/slack.hpp"
#include "synthesis/calibration/statistics.hpp"

namespace kempe::calibration_detail {
namespace {

using Rows = std::vector<std::size_t>;
using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, measure_count, measure_count>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, measure_count, 1>;
using Pair = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, measure_count>;

/// The linear model about a fit, of all readings and lengths.
class Linear {
 public:
  Linear(const Eigen::VectorXd& residuals, const Eigen::MatrixXd& slopes, std::size_t readings)
      : residuals_(residuals), slopes_(slopes), readings_(readings) {}

  std::size_t readings() const { return readings_; }
  Eigen::Index unknowns() const { return slopes_.cols(); }
  /// Degrees of freedom that a number of readings leave.
  int freedom(std::size_t readings) const {
    return static_cast<int>(residuals_.size()) - static_cast<int>(2 * (readings_ - readings)) -
           static_cast<int>(slopes_.cols());
  }
  Eigen::Vector2d residual(std::size_t i) const { return residuals_.segment<2>(row(i)); }
  Pair slope(std::size_t i) const { return slopes_.middleRows<2>(row(i)); }

  /// What the readings of a set, with all lengths, ask for.
  struct Agreed {
    SmallVector step;
    Small spread;  ///< (J_C^T J_C)^-1
    double square_sum = 0;
  };
  Agreed agreed(const Rows& set) const {
    const Eigen::Index p = slopes_.cols(), first_length = static_cast<Eigen::Index>(2 * readings_);
    const Eigen::Index lengths = residuals_.size() - first_length;
    Agreed result;
    if (p == 0) {
      result.square_sum = residuals_.tail(lengths).squaredNorm();
      for (const std::size_t i : set) result.square_sum += residual(i).squaredNorm();
      return result;
    }
    Small normal = slopes_.bottomRows(lengths).transpose() * slopes_.bottomRows(lengths);
    SmallVector right = slopes_.bottomRows(lengths).transpose() * residuals_.tail(lengths);
    double sum = residuals_.tail(lengths).squaredNorm();
    for (const std::size_t i : set) {
      const Pair own = slope(i);
      normal += own.transpose().lazyProduct(own);
      right += own.transpose().lazyProduct(residual(i));
      sum += residual(i).squaredNorm();
    }
    // A few readings alone need not tell all: a trace of the drawn instrument keeps the rest near it.
    const double most = normal.diagonal().maxCoeff();
    normal.diagonal().array() += slack::trace_of_drawn * (most > 0 ? most : 1);
    const Eigen::LDLT<Small> solver(normal);
    result.step = -solver.solve(right);
    result.spread = solver.solve(Small::Identity(p, p));
    result.square_sum = std::max(0.0, sum + right.dot(result.step));
    return result;
  }

  /// What is left at a reading by a fit.
  Eigen::Vector2d left(const Agreed& fit, std::size_t i) const {
    return slopes_.cols() == 0 ? residual(i) : Eigen::Vector2d(residual(i) + slope(i) * fit.step);
  }
  /// q_i of a reading that has no part in the fit.
  double beyond(const Agreed& fit, std::size_t i) const {
    const Eigen::Vector2d e = left(fit, i);
    const Eigen::Matrix2d spread = Eigen::Matrix2d::Identity() + own_spread(fit, i);
    return e.dot(spread.inverse() * e);
  }
  /// J_i (J_C^T J_C)^-1 J_i^T.
  Eigen::Matrix2d own_spread(const Agreed& fit, std::size_t i) const {
    if (slopes_.cols() == 0) return Eigen::Matrix2d::Zero();
    const Pair own = slope(i);
    const Pair spread = own.lazyProduct(fit.spread);
    return spread.lazyProduct(own.transpose());
  }

 private:
  static Eigen::Index row(std::size_t i) { return static_cast<Eigen::Index>(2 * i); }
  const Eigen::VectorXd& residuals_;
  const Eigen::MatrixXd& slopes_;
  std::size_t readings_;
};

Rows all_of(std::size_t count) {
  Rows all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

Rows without(const Rows& all, const Rows& set) {
  Rows rest;
  std::set_difference(all.begin(), all.end(), set.begin(), set.end(), std::back_inserter(rest));
  return rest;
}

/// Chance that a set of readings lies as far off as it does.
class Judge {
 public:
  Judge(bool noise_is_known, double floor) : known_(noise_is_known), floor_(floor) {}

  /// What others are measured by: a mean square, and its degrees of freedom, 0 for the stated noise. Absent: there is nothing
  /// to measure by.
  struct Yardstick {
    double mean_square;
    int freedom;
  };
  /// Of a set that agrees: its sum of squares and degrees of freedom. Takes as long as there are readings: one a set.
  std::optional<Yardstick> yardstick(double square_sum, int freedom) const {
    if (known_ && (freedom < 1 || !contradicts_stated(square_sum, freedom)))
      return Yardstick{std::max(1.0, floor_), 0};
    if (freedom < 1) return std::nullopt;
    return Yardstick{std::max(square_sum / freedom, floor_), freedom};
  }
  /// q summed over `readings` others.
  static double chance(double q, std::size_t readings, const std::optional<Yardstick>& by) {
    const auto pairs = static_cast<int>(readings);
    return by ? fisher_upper_probability(q / (2.0 * pairs) / by->mean_square, pairs, by->freedom) : 1;
  }

  double mean_square(double square_sum, int freedom) const {
    const double own = freedom < 1 ? 0 : square_sum / freedom;
    return std::max({known_ ? 1.0 : 0.0, own, floor_});
  }

 private:
  static bool contradicts_stated(double square_sum, int freedom) {
    constexpr double hardly = 0.05;
    return chi_squared_upper_probability(square_sum, freedom) < hardly;
  }
  bool known_;
  double floor_;
};

/// Numbers that are the same on every machine.
class Shuffle {
 public:
  std::size_t below(std::size_t count) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>((state_ >> 33) % count);
  }

 private:
  std::uint64_t state_ = 1;
};

class Search {
 public:
  Search(const Linear& linear, const Judge& judge)
      : linear_(linear), judge_(judge), count_(linear.readings()), all_(all_of(count_)) {}

  /// The readings that agree best, as many as are never left out.
  Rows core() const { return most_outliers() == 0 ? all_ : agreeing(count_ - most_outliers()); }

  Rows outliers() const {
    Rows inside = core();
    const double single = slack::named_by_chance / static_cast<double>(count_);
    while (inside.size() < count_) {
      const auto fit = linear_.agreed(inside);
      Rows outside = without(all_, inside);
      const auto by = judge_.yardstick(fit.square_sum, linear_.freedom(inside.size()));
      Rows admitted;
      std::vector<Candidate> apart;
      for (const std::size_t i : outside) {
        const double q = linear_.beyond(fit, i), chance = Judge::chance(q, 1, by);
        constexpr double surely_like_the_rest = 0.05;
        if (chance > surely_like_the_rest)
          admitted.push_back(i);
        else
          apart.push_back({q, chance, i});
      }
      if (admitted.empty()) {
        admitted = nearest_of(apart, single);
        if (admitted.empty()) {
          if (beyond_chance(outside, inside) && is_told(outside, inside)) return outside;
          admitted = {std::min_element(apart.begin(), apart.end())->reading};
        }
      }
      const auto middle = static_cast<std::ptrdiff_t>(inside.size());
      inside.insert(inside.end(), admitted.begin(), admitted.end());
      std::inplace_merge(inside.begin(), inside.begin() + middle, inside.end());
    }
    return {};
  }

 private:
  /// A reading outside the set that agrees.
  struct Candidate {
    double q, chance;
    std::size_t reading;
    bool operator<(const Candidate& other) const {
      return q != other.q ? q < other.q : reading < other.reading;
    }
  };
  /// The nearest of those that one in a thousand fits has as far off: one, of very many a tenth, so that their number of rounds
  /// grows slowly. Rising.
  static Rows nearest_of(std::vector<Candidate>& apart, double single) {
    const std::size_t share = std::max<std::size_t>(1, apart.size() / 10);
    std::partial_sort(apart.begin(), apart.begin() + static_cast<std::ptrdiff_t>(share), apart.end());
    Rows nearest;
    for (std::size_t i = 0; i < share && !(apart[i].chance < single); ++i)
      nearest.push_back(apart[i].reading);
    std::sort(nearest.begin(), nearest.end());
    return nearest;
  }

  /// At most a third, and so few that the rest is judged by at least two degrees of freedom of its own.
  std::size_t most_outliers() const {
    std::size_t most = count_ / 3;
    while (most > 0 && linear_.freedom(count_ - most) < 2) --most;
    return most;
  }

  double trimmed_sum(const Linear::Agreed& fit, std::size_t kept, Rows& nearest) const {
    std::vector<std::pair<double, std::size_t>> order;
    order.reserve(count_);
    for (std::size_t i = 0; i < count_; ++i) order.emplace_back(linear_.left(fit, i).squaredNorm(), i);
    std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept - 1), order.end());
    nearest.clear();
    double sum = 0;
    for (std::size_t i = 0; i < kept; ++i) {
      nearest.push_back(order[i].second);
      sum += order[i].first;
    }
    std::sort(nearest.begin(), nearest.end());
    return sum;
  }

  /// The `kept` readings that agree best: from all, and from many subsets that just tell the unknowns, each drawn to the
  /// readings nearest to its fit (concentration steps, Rousseeuw and Van Driessen 1999).
  Rows agreeing(std::size_t kept) const {
    const auto unknowns = static_cast<std::size_t>(linear_.unknowns());
    const std::size_t subset = std::min(kept, unknowns / 2 + 1);
    constexpr double work = 4e6;
    const double one = static_cast<double>(2 * count_ * (unknowns + 1) * (unknowns + 1));
    const auto starts = static_cast<int>(std::clamp(work / one, 3.0, 80.0));
    Shuffle shuffle;
    Rows best;
    double least = std::numeric_limits<double>::infinity();
    for (int start = 0; start <= starts; ++start) {
      Rows set = all_;
      if (start > 0) {
        for (std::size_t i = 0; i < subset; ++i) std::swap(set[i], set[i + shuffle.below(count_ - i)]);
        set.resize(subset);
      }
      double sum = std::numeric_limits<double>::infinity();
      constexpr int steps = 4;
      for (int step = 0; step < steps; ++step) {
        const double now = trimmed_sum(linear_.agreed(set), kept, set);
        if (!(now < sum)) break;
        sum = now;
      }
      if (!(sum < least)) continue;
      least = sum;
      best = set;
    }
    return best;
  }

  double square_sum_of(const Rows& set) const { return linear_.agreed(set).square_sum; }

  /// All sets of as many readings could have been picked: together they must be less likely than one in as many.
  bool beyond_chance(const Rows& outside, const Rows& inside) const {
    const double rest = square_sum_of(inside), drop = square_sum_of(all_) - rest;
    double log_sets = 0;  // of many readings the number of sets itself is too large
    for (std::size_t k = 0; k < outside.size(); ++k)
      log_sets += std::log(static_cast<double>(count_ - k) / static_cast<double>(k + 1));
    const auto by = judge_.yardstick(rest, linear_.freedom(inside.size()));
    return std::log(Judge::chance(drop, outside.size(), by)) + log_sets < std::log(slack::named_by_chance);
  }

  /// False if another reading in place of one of these would explain nearly as much: which is wrong cannot be told.
  bool is_told(const Rows& outside, const Rows& inside) const {
    constexpr std::size_t many = 200;
    if (count_ > many) return true;
    const double rest = square_sum_of(inside);
    const double clearly = 2 * std::log(1e2) * judge_.mean_square(rest, linear_.freedom(inside.size()));
    for (const std::size_t out : outside)
      for (const std::size_t in : inside) {
        Rows other = inside;
        std::replace(other.begin(), other.end(), in, out);
        if (square_sum_of(other) < rest + clearly) return false;
      }
    return true;
  }

  const Linear& linear_;
  const Judge& judge_;
  std::size_t count_;
  Rows all_;
};

/// Rounding, and what the model itself may leave, as a weighted square: readings without noise have no outliers.
double floor_of(const WeightedTask& weighted) {
  const double rounding = slack::outlier_rounding / weighted.units[index_of(Measure::turn)];
  return std::pow(std::max(rounding, weighted.model_error) / weighted.noise, 2);
}

}  // namespace

std::vector<std::size_t> standing_out(const WeightedTask& weighted, const LinearFit& about,
                                      bool noise_is_known) {
  const Linear linear(about.residuals, about.slopes, weighted.used.size());
  const Judge judge(noise_is_known, floor_of(weighted));
  return Search(linear, judge).outliers();
}

std::vector<std::size_t> agreeing_best(const WeightedTask& weighted, const LinearFit& about) {
  const Linear linear(about.residuals, about.slopes, weighted.used.size());
  const Judge judge(false, floor_of(weighted));
  return Search(linear, judge).core();
}

std::vector<LeftOut> leave_one_out(const WeightedTask& weighted, const LinearFit& about,
                                   const std::vector<std::size_t>& left_out, bool noise_is_known) {
  const Linear linear(about.residuals, about.slopes, weighted.used.size());
  const Judge judge(noise_is_known, floor_of(weighted));
  const Rows inside = without(all_of(weighted.used.size()), left_out);
  const auto fit = linear.agreed(inside);
  std::vector<LeftOut> all(weighted.used.size());
  for (const std::size_t i : left_out) {
    const double rest = judge.mean_square(fit.square_sum, linear.freedom(inside.size()));
    all[i].studentised = std::sqrt(linear.beyond(fit, i) / rest);
  }
  for (const std::size_t i : inside) {
    const Eigen::Matrix2d hat = linear.own_spread(fit, i), own = Eigen::Matrix2d::Identity() - hat;
    all[i].leverage = 0.5 * hat.trace();
    const double pivot = own.diagonal().maxCoeff(), other_pivot = own.determinant() / pivot;
    if (!(std::min(pivot, other_pivot) > slack::decides_alone)) continue;
    const Eigen::Vector2d e = linear.left(fit, i);
    const double drop = e.dot(own.inverse() * e);
    const int freedom = linear.freedom(inside.size()) - 2;
    if (freedom < 1 && !noise_is_known) continue;
    all[i].studentised =
        std::sqrt(std::max(0.0, drop / judge.mean_square(std::max(0.0, fit.square_sum - drop), freedom)));
  }
  return all;
}

double least_square_sum(const LinearFit& about, std::size_t readings) {
  const Linear linear(about.residuals, about.slopes, readings);
  return linear.agreed(all_of(readings)).square_sum;
}

}  // namespace kempe::calibration_detail
