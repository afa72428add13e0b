// Steps: the poses moved to their centroid and scaled; the null space of their rows; two conics met by their resultant; Newton's method on
// the circles themselves; pairs of dyads judged; of three and four poses the best pairs led to larger transmission angles.

#include "synthesis/paths/pose_guidance.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/convex_hull.hpp"
#include "geometry/decompositions.hpp"
#include "synthesis/paths/slack.hpp"
#include "synthesis/solvers/van_der_corput.hpp"

namespace kempe {
namespace {

using Row8 = Eigen::Matrix<double, 1, 8>;
using Rows8 = Eigen::Matrix<double, 5, 8>;

Row8 row_of(const BodyPlacement& pose) {
  const double x = pose.at.x(), y = pose.at.y(), c = std::cos(pose.angle), s = std::sin(pose.angle);
  Row8 row;
  row << x * x + y * y, 2 * (x * c + y * s), 2 * (y * c - x * s), -2 * x, -2 * y, -2 * c, 2 * s, 1;
  return row;
}

/// a0 + a1 t + a2 t^2 + ..., the lowest power first.
template <std::size_t N, std::size_t M>
std::array<double, N + M - 1> product(const std::array<double, N>& a, const std::array<double, M>& b) {
  std::array<double, N + M - 1> c{};
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < M; ++j) c[i + j] += a[i] * b[j];
  return c;
}

/// The real places (s, t, 1) where two conics meet.
std::vector<Eigen::Vector3d> meeting_of(const Eigen::Matrix3d& one, const Eigen::Matrix3d& other) {
  const double p1 = one(0, 0), p2 = other(0, 0);
  const std::array<double, 2> q1{2 * one(0, 2), 2 * one(0, 1)}, q2{2 * other(0, 2), 2 * other(0, 1)};
  const std::array<double, 3> r1{one(2, 2), 2 * one(1, 2), one(1, 1)},
      r2{other(2, 2), 2 * other(1, 2), other(1, 1)};
  std::array<double, 3> pr{};
  for (std::size_t k = 0; k < 3; ++k) pr[k] = p1 * r2[k] - p2 * r1[k];
  const std::array<double, 2> pq{p1 * q2[0] - p2 * q1[0], p1 * q2[1] - p2 * q1[1]};
  auto qr = product(q1, r2);
  const auto less = product(q2, r1);
  for (std::size_t k = 0; k < 4; ++k) qr[k] -= less[k];
  auto resultant = product(pr, pr);
  const auto mixed = product(pq, qr);
  for (std::size_t k = 0; k < 5; ++k) resultant[k] -= mixed[k];
  if (resultant[4] == 0) return {};
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  for (int k = 0; k < 4; ++k) companion(k, 3) = -resultant[static_cast<std::size_t>(k)] / resultant[4];
  companion.bottomLeftCorner<3, 3>().setIdentity();
  if (!companion.allFinite()) return {};
  const Eigen::Vector4cd roots = companion.eigenvalues();
  std::vector<Eigen::Vector3d> places;
  for (const Complex root : roots) {
    if (std::abs(root.imag()) > slack::nearly_real * (1 + std::abs(root))) continue;
    const double t = root.real();
    const double s = -(pr[0] + t * (pr[1] + t * pr[2])) / (pq[0] + t * pq[1]);
    if (std::isfinite(s)) places.emplace_back(s, t, 1);
  }
  return places;
}

/// w and Z that five rows allow, to the accuracy of their roots.
std::vector<Eigen::Vector4d> roots_of(const Rows8& rows) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullV);
  if (svd.singularValues()[4] < slack::rows_depend * svd.singularValues()[0]) return {};
  // Turned within the null space, so that no root lies at infinity by a symmetry of the poses.
  Eigen::Matrix3d turned;
  turned << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6;
  const Eigen::Matrix<double, 8, 3> N = svd.matrixV().rightCols<3>() * turned;
  const auto pair = [&](int i, int j) -> Eigen::Matrix3d {
    const Eigen::Matrix3d m = N.row(i).transpose() * N.row(j);
    return 0.5 * (m + m.transpose());
  };
  std::vector<Eigen::Vector4d> found;
  for (const Eigen::Vector3d& place :
       meeting_of(pair(0, 5) - pair(3, 1) - pair(4, 2), pair(0, 6) - pair(3, 2) + pair(4, 1))) {
    const Eigen::Matrix<double, 8, 1> q = N * place;
    if (std::abs(q[0]) < slack::pair_at_infinity * q.norm()) continue;
    found.emplace_back(q[1] / q[0], q[2] / q[0], q[3] / q[0], q[4] / q[0]);
  }
  return found;
}

/// Newton's method on |x + R w - Z|^2 being alike in all poses; with a line through the origin for w where there are but four. False
/// where it does not end at rounding.
bool met_exactly(const std::vector<BodyPlacement>& poses, const Point* across, Eigen::Vector4d& wz) {
  for (int round = 0; round < 20; ++round) {
    Eigen::Matrix4d slope = Eigen::Matrix4d::Zero();
    Eigen::Vector4d value = Eigen::Vector4d::Zero();
    Eigen::RowVector4d first_slope;
    double first = 0, size = 0;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const double c = std::cos(poses[k].angle), s = std::sin(poses[k].angle);
      const Point d = poses[k].at + Point(c * wz[0] - s * wz[1], s * wz[0] + c * wz[1]) - wz.tail<2>();
      Eigen::RowVector4d along;
      along << 2 * (c * d.x() + s * d.y()), 2 * (c * d.y() - s * d.x()), -2 * d.x(), -2 * d.y();
      size = std::max({size, d.squaredNorm(), wz.squaredNorm()});
      if (k == 0) {
        first = d.squaredNorm();
        first_slope = along;
        continue;
      }
      value[static_cast<Eigen::Index>(k) - 1] = d.squaredNorm() - first;
      slope.row(static_cast<Eigen::Index>(k) - 1) = along - first_slope;
    }
    if (across != nullptr) {
      value[3] = across->dot(Point(wz.head<2>()));
      slope.row(3).head<2>() = across->transpose();
    }
    if (value.cwiseAbs().maxCoeff() < 1e-14 * (1 + size)) return true;
    const Eigen::Vector4d step = solution_of(Eigen::FullPivLU<Eigen::MatrixXd>(slope), value);
    if (!step.allFinite()) return false;
    wz -= step;
    if (step.norm() < 1e-15 * (1 + wz.norm())) return value.cwiseAbs().maxCoeff() < 1e-12 * (1 + size);
  }
  return false;
}

/// The poses about their centroid, in units of their size.
struct ScaledPoses {
  std::vector<BodyPlacement> poses;
  Point centre = Point::Zero();
  double unit = 0;

  explicit ScaledPoses(const std::vector<BodyPlacement>& given) : poses(given) {
    for (const BodyPlacement& pose : given) centre += pose.at / static_cast<double>(given.size());
    for (const BodyPlacement& pose : given) unit = std::max(unit, (pose.at - centre).norm());
    if (unit == 0) unit = 1;
    for (BodyPlacement& pose : poses) pose.at = (pose.at - centre) / unit;
  }

  Dyad dyad(const Eigen::Vector4d& wz) const {
    Dyad dyad{centre + unit * Point(wz.tail<2>()), unit * Point(wz.head<2>()), 0};
    const double c = std::cos(poses[0].angle), s = std::sin(poses[0].angle);
    const Point at = poses[0].at + Point(c * wz[0] - s * wz[1], s * wz[0] + c * wz[1]);
    dyad.length = unit * (at - Point(wz.tail<2>())).norm();
    return dyad;
  }
};

bool met_before(const std::vector<Dyad>& dyads, const Dyad& dyad) {
  const double near = slack::path_met * (dyad.length + dyad.circle.norm());
  return std::any_of(dyads.begin(), dyads.end(), [&](const Dyad& other) {
    return (other.circle - dyad.circle).norm() <= near && (other.centre - dyad.centre).norm() <= near;
  });
}

/// Of the rows of five poses, or of four and of a line for the circle point.
void add_dyads(const ScaledPoses& scaled, const Point* across, std::vector<Dyad>& dyads) {
  Rows8 rows;
  for (std::size_t k = 0; k < scaled.poses.size(); ++k)
    rows.row(static_cast<Eigen::Index>(k)) = row_of(scaled.poses[k]);
  if (across != nullptr) rows.row(4) << 0, across->x(), across->y(), 0, 0, 0, 0, 0;
  for (Eigen::Vector4d wz : roots_of(rows)) {
    if (!met_exactly(scaled.poses, across, wz)) continue;
    const Dyad dyad = scaled.dyad(wz);
    if (!met_before(dyads, dyad)) dyads.push_back(dyad);
  }
}

/// A circle point of three poses (in units of their size) with the centre of the circle through its places; nothing where these lie on a line.
std::optional<Dyad> dyad_of_three(const ScaledPoses& scaled, const Point& w) {
  std::array<Point, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const double c = std::cos(scaled.poses[k].angle), s = std::sin(scaled.poses[k].angle);
    at[k] = scaled.poses[k].at + Point(c * w.x() - s * w.y(), s * w.x() + c * w.y());
  }
  const Point one = at[1] - at[0], other = at[2] - at[0];
  const double twice = 2 * cross(one, other);
  if (std::abs(twice) < slack::path_met) return std::nullopt;
  const Point Z = at[0] + left_of(one * other.squaredNorm() - other * one.squaredNorm()) / twice;
  return scaled.dyad({w.x(), w.y(), Z.x(), Z.y()});
}

/// A grid of circle points, each with the centre of the circle through its three places.
std::vector<Dyad> dyads_of_three(const ScaledPoses& scaled, double longest) {
  constexpr int places = 16;
  const double half = std::min(longest / scaled.unit, 3.0);
  std::vector<Dyad> dyads;
  for (int i = 0; i <= places; ++i)
    for (int j = 0; j <= places; ++j) {
      const Point w(half * (2.0 * i / places - 1), half * (2.0 * j / places - 1));
      if (const auto dyad = dyad_of_three(scaled, w)) dyads.push_back(*dyad);
    }
  return dyads;
}

/// The crank's angles at the poses, turning one way by less than a turn; nothing if it does not.
std::optional<std::vector<double>> one_way(const std::vector<double>& angles) {
  for (const double way : {1.0, -1.0}) {
    std::vector<double> turned{angles[0]};
    for (std::size_t k = 1; k < angles.size(); ++k) {
      double turn = way * (angles[k] - turned.back());
      turn -= 2 * pi * std::floor(turn / (2 * pi));
      turned.push_back(turned.back() + way * turn);
    }
    const double whole = std::abs(turned.back() - turned.front());
    bool moves = whole < 2 * pi;
    for (std::size_t k = 1; k < angles.size(); ++k)
      moves = moves && std::abs(turned[k] - turned[k - 1]) >= slack::least_turn;
    if (moves) return turned;
  }
  return std::nullopt;
}

struct PairOfDyads {
  Dyad crank, rocker;
  CouplerFourBar linkage;
  std::vector<double> crank_angles;
  double body_from_coupler;  // rad: the body's angle less the coupler's
  double transmission;
};

/// The four-bar on two dyads, if its poses lie on one branch and in order.
std::optional<PairOfDyads> paired(const PoseTask& task, const Dyad& crank, const Dyad& rocker) {
  const Point across = rocker.circle - crank.circle;
  PairOfDyads pair;
  pair.crank = crank;
  pair.rocker = rocker;
  CouplerFourBar& bar = pair.linkage;
  bar.crank_pivot = crank.centre;
  bar.rocker_pivot = rocker.centre;
  bar.crank = crank.length;
  bar.rocker = rocker.length;
  bar.coupler = across.norm();
  const Point along = across / bar.coupler;
  bar.coupler_point = {-crank.circle.dot(along), -cross(along, crank.circle)};
  pair.body_from_coupler = -std::arg(as_complex(across));
  std::vector<double> angles;
  double side = 0;
  for (const BodyPlacement& pose : task.poses) {
    const Complex turn = std::polar(1.0, pose.angle);
    const Point A = pose.at + as_point(turn * as_complex(crank.circle)),
                B = pose.at + as_point(turn * as_complex(rocker.circle));
    angles.push_back(std::arg(as_complex(A - bar.crank_pivot)));
    const double here = cross(A - bar.rocker_pivot, B - bar.rocker_pivot);
    if (here == 0 || here * side < 0) return std::nullopt;
    side = here;
  }
  bar.branch = side < 0 ? FourBarBranch::first : FourBarBranch::second;
  const auto turned = one_way(angles);
  if (!turned) return std::nullopt;
  pair.crank_angles = *turned;
  const auto transmission = bar.least_transmission_angle(turned->front(), turned->back());
  if (!transmission) return std::nullopt;
  pair.transmission = *transmission;
  return pair;
}

bool breaks_limits(const PoseTask& task, const Dyad& dyad) {
  return !(dyad.length > 0) || dyad.length > task.longest || dyad.circle.norm() > task.longest ||
         !lies_within(task.pivots_within, dyad.centre);
}

bool joints_fall_together(const Dyad& crank, const Dyad& rocker) {
  const double near = slack::on_a_joint * crank.length;
  return (rocker.circle - crank.circle).norm() <= near || (rocker.centre - crank.centre).norm() <= near;
}

/// The dyad beside another in the family of three or four poses: its circle point moved by `step` (in units of the poses' size), or, of
/// four, turned about the body's origin by its first number (rad).
std::optional<Dyad> dyad_beside(const ScaledPoses& scaled, const Dyad& from, const Point& step) {
  const Point w = from.circle / scaled.unit;
  if (scaled.poses.size() == 3) return dyad_of_three(scaled, w + step);
  const Point turned = as_point(as_complex(w) * std::polar(1.0, step.x()));
  const Point across = left_of(turned.normalized());
  Eigen::Vector4d wz;
  wz << turned, (from.centre - scaled.centre) / scaled.unit;
  if (!across.allFinite() || !met_exactly(scaled.poses, &across, wz)) return std::nullopt;
  return scaled.dyad(wz);
}

/// Leads a pair to a larger transmission angle within its family: steps in scattered directions, halved where none helps. An end where no
/// nearby pair is better, no proof that it is the best of all.
void raise_transmission(const PoseTask& task, const ScaledPoses& scaled, PairOfDyads& pair) {
  constexpr double first_step = 0.1, last_step = 1e-7;
  constexpr std::size_t directions = 24, most_tries = 4000;
  std::size_t tries = 0;
  for (double step = first_step; step > last_step; step /= 2)
    for (std::size_t failed = 0; failed < directions && tries < most_tries;) {
      ++tries;
      const auto part = [&](unsigned base) { return step * (2 * van_der_corput(tries, base) - 1); };
      const auto crank = dyad_beside(scaled, pair.crank, {part(2), part(3)}),
                 rocker = dyad_beside(scaled, pair.rocker, {part(5), part(7)});
      ++failed;
      if (!crank || !rocker || breaks_limits(task, *crank) || breaks_limits(task, *rocker) ||
          joints_fall_together(*crank, *rocker))
        continue;
      auto beside = paired(task, *crank, *rocker);
      if (!beside || beside->transmission <= pair.transmission || beside->linkage.longest() > task.longest)
        continue;
      const CrankMotion motion = beside->linkage.links().motion();
      if (!task.motions.empty() &&
          std::find(task.motions.begin(), task.motions.end(), motion) == task.motions.end())
        continue;
      pair = std::move(*beside);
      failed = 0;
    }
}

bool alike(const PairOfDyads& one, const PairOfDyads& other, double near) {
  return (one.crank.circle - other.crank.circle).norm() <= near &&
         (one.rocker.circle - other.rocker.circle).norm() <= near;
}

/// The best pairs that differ, each led to a larger transmission angle; those that end at one place are one.
std::vector<PairOfDyads> raised_pairs(const PoseTask& task, const std::vector<PairOfDyads>& ranked) {
  constexpr std::size_t most = 12;
  constexpr double starts_apart = 0.3, ends_apart = 0.01;  // of the poses' size
  const ScaledPoses scaled(task.poses);
  std::vector<PairOfDyads> starts, ends;
  for (const PairOfDyads& pair : ranked) {
    if (starts.size() == most) break;
    const auto near = [&](const PairOfDyads& other) {
      return alike(pair, other, starts_apart * scaled.unit);
    };
    if (std::none_of(starts.begin(), starts.end(), near)) starts.push_back(pair);
  }
  for (PairOfDyads pair : starts) {
    raise_transmission(task, scaled, pair);
    const auto near = [&](const PairOfDyads& other) { return alike(pair, other, ends_apart * scaled.unit); };
    if (std::none_of(ends.begin(), ends.end(), near)) ends.push_back(std::move(pair));
  }
  return ends;
}

std::optional<PoseAnswer> judged_poses(const PoseTask& task, const PathTask& path, const PairOfDyads& pair) {
  auto judged = judged_path(path, pair.linkage, pair.crank_angles);
  if (!judged || judged->error_max > slack::poses_met * pair.linkage.longest()) return std::nullopt;
  PoseAnswer answer{std::move(*judged), {}, 0};
  for (std::size_t k = 0; k < task.poses.size(); ++k) {
    const double angle = answer.path.coupler_angles[k] + pair.body_from_coupler;
    const double off = std::remainder(angle - task.poses[k].angle, 2 * pi);
    answer.angles.push_back(task.poses[k].angle + off);
    answer.error_angle = std::max(answer.error_angle, std::abs(off));
  }
  if (answer.error_angle > slack::poses_met) return std::nullopt;
  return answer;
}

}  // namespace

std::vector<Dyad> burmester_dyads(const std::vector<BodyPlacement>& five) {
  std::vector<Dyad> dyads;
  if (five.size() == 5) add_dyads(ScaledPoses(five), nullptr, dyads);
  return dyads;
}

std::vector<Dyad> dyads_of(const PoseTask& task) {
  const ScaledPoses scaled(task.poses);
  std::vector<Dyad> dyads;
  if (task.poses.size() == 3) dyads = dyads_of_three(scaled, task.longest);
  if (task.poses.size() == 5) add_dyads(scaled, nullptr, dyads);
  constexpr int lines = 180;
  for (int k = 0; k < lines && task.poses.size() == 4; ++k) {
    const double direction = (k + 0.5) * pi / lines;
    const Point across(std::sin(direction), -std::cos(direction));
    add_dyads(scaled, &across, dyads);
  }
  std::erase_if(dyads, [&](const Dyad& dyad) { return breaks_limits(task, dyad); });
  return dyads;
}

tl::expected<PoseSearch, std::string> guide_poses(const PoseTask& task, std::size_t most) {
  PathTask path;
  for (const BodyPlacement& pose : task.poses) path.points.push_back(pose.at);
  path.longest = task.longest;
  path.transmission = task.transmission;
  path.pivots_within = task.pivots_within;
  path.motions = task.motions;
  PoseSearch search;
  search.dyads = dyads_of(task);
  const double kept = std::max(task.transmission, slack::path_from_dead_points);
  std::vector<PairOfDyads> pairs;
  for (const Dyad& crank : search.dyads)
    for (const Dyad& rocker : search.dyads) {
      if (&crank == &rocker || joints_fall_together(crank, rocker)) continue;
      ++search.linkages;
      auto pair = paired(task, crank, rocker);
      if (!pair)
        ++search.defective;
      else if (pair->transmission < kept || pair->linkage.longest() > task.longest)
        ++search.limited;
      else
        pairs.push_back(std::move(*pair));
    }
  const auto moves_better = [](const PairOfDyads& a, const PairOfDyads& b) {
    return a.transmission > b.transmission;
  };
  std::stable_sort(pairs.begin(), pairs.end(), moves_better);
  if (task.poses.size() < 5) {
    const std::vector<PairOfDyads> raised = raised_pairs(task, pairs);
    pairs.insert(pairs.begin(), raised.begin(), raised.end());
    std::stable_sort(pairs.begin(), pairs.end(), moves_better);
  }
  for (const PairOfDyads& pair : pairs) {
    if (search.answers.size() == most) break;
    if (auto answer = judged_poses(task, path, pair))
      search.answers.push_back(std::move(*answer));
    else
      ++search.limited;
  }
  if (!search.answers.empty()) return search;
  const char* looked[] = {"a grid of circle points", "circle points on 180 lines", "every circle point"};
  return tl::unexpected(fmt::format(
      "no four-bar was found that takes the poses without defect and keeps the limits. Searched: {}, {} "
      "dyads within "
      "the limits, {} four-bars of them, {} with the poses on two branches or in another order, {} against a "
      "limit; "
      "that is not a proof that none exists",
      looked[task.poses.size() - 3], search.dyads.size(), search.linkages, search.defective, search.limited));
}

}  // namespace kempe
