#include "synthesis/certificate/requirement_sum.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/certificate/slack.hpp"

namespace kempe::certificate {
namespace {

/// A quadratic about the middle of a cell: value, slopes, squares, and the product of a and b.
struct Quadratic {
  double value = 0, size = 0;  // size: of the terms that make up the value
  std::array<double, 4> slope{}, square{};
  double mixed = 0;

  Quadratic& add(double weight, const Quadratic& other) {
    value += weight * other.value;
    size += weight * other.size;
    for (std::size_t i = 0; i < 4; ++i) {
      slope[i] += weight * other.slope[i];
      square[i] += weight * other.square[i];
    }
    mixed += weight * other.mixed;
    return *this;
  }

  /// What a variable's half range adds at most.
  double growth(std::size_t i, double half) const {
    const double g = std::abs(slope[i]), q = square[i];
    return q < 0 && g < -2 * q * half ? g * g / (-4 * q) : g * half + q * half * half;
  }
  /// Largest value over the cell.
  double most(const std::array<double, 4>& half) const {
    double sum = value + std::abs(mixed) * half[0] * half[1];
    for (std::size_t i = 0; i < 4; ++i) sum += growth(i, half[i]);
    return sum;
  }
};

struct Candidate {
  Requirement requirement;  // with the weight that makes it a length, about
  Quadratic quadratic;
};

/// sign (|g|^2 |T - P|^2 - R(phi)): the reach at a place, against an end of the window.
Candidate reach(const SumTask& task, const DesignCell& cell, Requirement::Kind kind,
                const KnownPlace& place) {
  const double g2 = std::norm(task.root->g), a = cell.middle(Variable::a), b = cell.middle(Variable::b);
  const double sign = kind == Requirement::Kind::far ? -1 : 1;
  const double c = kind == Requirement::Kind::far ? cell.far_cosine : cell.near_cosine;
  const Point away = place.at - cell.pole();
  const double weight = 1 / std::max(slack::nearest_weighed, 2 * away.norm() * std::sqrt(g2));
  const double p = sign * weight * g2, l = -sign * weight;
  Candidate one{{kind, place.place, weight}, {}};
  Quadratic& q = one.quadratic;
  const double reach2 = a * a + b * b + 2 * a * b * c;
  q.value = p * away.squaredNorm() + l * reach2;
  q.size = std::abs(p) * away.squaredNorm() + std::abs(l) * (a + b) * (a + b);
  q.slope = {2 * l * (a + b * c), 2 * l * (b + a * c), -2 * p * away.x(), -2 * p * away.y()};
  q.square = {l, l, p, p};
  q.mixed = 2 * l * c;
  return one;
}

Candidate size_in_bound(const SumTask& task, const DesignCell& cell) {
  const double A = task.root->mode.size_per_a, B = task.root->mode.size_per_b, weight = 1 / (A + B);
  Candidate one{{Requirement::Kind::bound, Point(Point::Zero()), weight}, {}};
  const double size = A * cell.middle(Variable::a) + B * cell.middle(Variable::b);
  one.quadratic.value = weight * (*task.size_bound - size);
  one.quadratic.size = weight * (*task.size_bound + size);
  one.quadratic.slope = {-weight * A, -weight * B, 0, 0};
  return one;
}

Candidate posts_apart(const SumTask& task, const DesignCell& cell, const KnownPlace& place) {
  const double weight = 1 / task.least_radius;
  const Point away = place.at - cell.pole();
  Candidate one{{Requirement::Kind::posts, place.place, weight}, {}};
  one.quadratic.value = weight * away.squaredNorm() - task.least_radius;
  one.quadratic.size = weight * away.squaredNorm() + task.least_radius;
  one.quadratic.slope = {0, 0, -2 * weight * away.x(), -2 * weight * away.y()};
  one.quadratic.square = {0, 0, weight, weight};
  return one;
}

bool same_place(const KnownPlace& one, const KnownPlace& other) { return one.at == other.at; }

void add_new(std::vector<KnownPlace>& places, const KnownPlace& place) {
  if (std::none_of(places.begin(), places.end(), [&](const auto& known) { return same_place(known, place); }))
    places.push_back(place);
}

std::vector<Candidate> candidates(const SumTask& task, const DesignCell& cell) {
  std::vector<Point> poles{cell.pole()};
  if (cell.half(Variable::x) > 0 || cell.half(Variable::y) > 0)
    for (const double x : {cell[Variable::x].lower, cell[Variable::x].upper})
      for (const double y : {cell[Variable::y].lower, cell[Variable::y].upper}) poles.emplace_back(x, y);
  std::vector<KnownPlace> farthest, nearest;
  for (const Point& pole : poles) {
    add_new(farthest, task.places->farthest(pole));
    add_new(nearest, task.places->nearest(pole));
  }
  std::vector<Candidate> all;
  for (const KnownPlace& place : farthest) all.push_back(reach(task, cell, Requirement::Kind::far, place));
  for (const KnownPlace& place : nearest) all.push_back(reach(task, cell, Requirement::Kind::near, place));
  if (task.size_bound) all.push_back(size_in_bound(task, cell));
  if (task.least_radius > 0) all.push_back(posts_apart(task, cell, nearest.front()));
  return all;
}

/// Weights of a sum and the sum itself.
struct Weighted {
  std::vector<double> weights;
  Quadratic sum;
  double most = infinity;
};

/// The weights, >= 0 and 1 together, that make q w + (w G w)/(2 soft) least, from those given: the pair that gains most moves
/// first. G holds the products of the slopes, each times its half range.
void relax_weights(const std::vector<double>& q, const std::vector<std::vector<double>>& G, double soft,
                   std::vector<double>& weights) {
  const std::size_t n = weights.size();
  std::vector<double> slope(n);
  for (std::size_t i = 0; i < n; ++i) {
    slope[i] = q[i];
    for (std::size_t j = 0; j < n; ++j) slope[i] += G[i][j] * weights[j] / soft;
  }
  constexpr int moves = 60;
  for (int move = 0; move < moves; ++move) {
    std::size_t to = 0, from = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (slope[i] < slope[to]) to = i;
      if (weights[i] > 0 && (from == n || slope[i] > slope[from])) from = i;
    }
    const double gain = slope[from] - slope[to];
    if (!(gain > slack::rounding * (std::abs(slope[from]) + std::abs(slope[to])))) return;
    const double bend = (G[to][to] + G[from][from] - 2 * G[to][from]) / soft;
    const double share = bend > 0 ? std::min(weights[from], gain / bend) : weights[from];
    weights[to] += share;
    weights[from] = share == weights[from] ? 0 : weights[from] - share;
    for (std::size_t i = 0; i < n; ++i) slope[i] += share * (G[i][to] - G[i][from]) / soft;
  }
}

Weighted weighted(const std::vector<Candidate>& all, const std::array<double, 4>& half,
                  const std::vector<double>& weights) {
  Weighted result{weights, {}, 0};
  for (std::size_t i = 0; i < all.size(); ++i)
    if (weights[i] > 0) result.sum.add(weights[i], all[i].quadratic);
  result.most = result.sum.most(half);
  return result;
}

/// Weights whose sum's largest value over the cell is about least. That value is q w + sum |slope half range| and some
/// squares: kinks, which are made soft at first and harder from step to step.
Weighted best_weights(const std::vector<Candidate>& all, const std::array<double, 4>& half) {
  const std::size_t n = all.size();
  std::vector<double> q(n);
  std::vector<std::vector<double>> G(n, std::vector<double>(n, 0));
  Weighted best;
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    q[i] = all[i].quadratic.value;
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t v = 0; v < 4; ++v)
        G[i][j] += half[v] * half[v] * all[i].quadratic.slope[v] * all[j].quadratic.slope[v];
    largest = std::max(largest, G[i][i]);
    std::vector<double> alone(n, 0);
    alone[i] = 1;
    if (const Weighted one = weighted(all, half, alone); one.most < best.most) best = one;
  }
  std::vector<double> weights = best.weights;
  double soft = std::sqrt(largest);
  constexpr int rounds = 9;
  for (int round = 0; round < rounds && best.most >= 0 && soft > 0; ++round, soft *= 0.2) {
    relax_weights(q, G, soft, weights);
    if (Weighted one = weighted(all, half, weights); one.most < best.most) best = std::move(one);
  }
  return best;
}

bool refutes(const Weighted& sum) { return sum.most < -slack::rounding * sum.sum.size; }

/// The weights as a log has them, each in its requirement's own unit.
std::vector<double> written_weights(const std::vector<Candidate>& all, const Weighted& best) {
  std::vector<double> written = best.weights;
  for (std::size_t i = 0; i < all.size(); ++i) written[i] *= all[i].requirement.weight;
  return written;
}

/// Those of a sum that refutes, the largest 1 (their ratios alone matter) and all in few digits, if the sum refutes with these.
std::vector<double> short_weights(const std::vector<Candidate>& all, const std::array<double, 4>& half,
                                  const Weighted& best) {
  const std::vector<double> written = written_weights(all, best);
  const double largest = *std::max_element(written.begin(), written.end());
  std::vector<double> rounded = written, weights(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    rounded[i] = std::round(slack::steps_of_weights * written[i] / largest) / slack::steps_of_weights;
    weights[i] = rounded[i] / all[i].requirement.weight;
  }
  return refutes(weighted(all, half, weights)) ? rounded : written;
}

}  // namespace

BestSum best_sum(const SumTask& task, const DesignCell& cell) {
  std::array<double, 4> half{};
  for (const Variable variable : all_variables)
    half[static_cast<std::size_t>(variable)] = cell.half(variable) * slack::whole_half;
  const std::vector<Candidate> all = candidates(task, cell);
  const Weighted best = best_weights(all, half);
  BestSum result;
  result.refutes = refutes(best);
  constexpr double soon = 0.2;
  result.refutes_soon = best.sum.value < -soon * (best.most - best.sum.value);
  for (std::size_t i = 0; i < 4; ++i) result.share[i] = std::max(0.0, best.sum.growth(i, half[i]));
  const double both = 0.5 * std::abs(best.sum.mixed) * half[0] * half[1];
  result.share[0] += both;
  result.share[1] += both;
  const std::vector<double> shares =
      result.refutes ? short_weights(all, half, best) : written_weights(all, best);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!(shares[i] > 0)) continue;
    Requirement one = all[i].requirement;
    one.weight = shares[i];
    result.leaf.of.push_back(one);
  }
  return result;
}

}  // namespace kempe::certificate
