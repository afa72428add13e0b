#include "kinematics/pose_batch.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/slack.hpp"

namespace kempe {
namespace {

/// What all rows share. Complex numbers are spelled out in columns below.
struct Shared {
  double pole_x, pole_y;
  double chain_x, chain_y;  ///< X - V per tracer - pole
  double s_x, s_y;
  double outer, inner;        ///< a + b, |a - b|
  double difference;          ///< D = (a - b)(a + b)
  double side;                ///< sign of h
  double change_x, change_y;  ///< sin(opening) = change_x sin(elbow) + change_y cos(elbow)
  double change_side;         ///< sign of sin(opening) over the assembly mode
  bool ground_at_X;
};

Shared shared_by(const CopyingLinkage& linkage) {
  const Complex s = linkage.shape();
  const double a = linkage.VA(), b = linkage.VB() / std::abs(s);
  const Complex chain = chain_per_tracer(linkage.k(), linkage.grounding());
  const double middle = linkage.assembly_mode().openings.middle();
  const double elbow = std::sin(middle - std::arg(s));
  return {.pole_x = linkage.pole().x(),
          .pole_y = linkage.pole().y(),
          .chain_x = chain.real(),
          .chain_y = chain.imag(),
          .s_x = s.real(),
          .s_y = s.imag(),
          .outer = a + b,
          .inner = std::abs(a - b),
          .difference = (a - b) * (a + b),
          .side = elbow < 0 ? -1.0 : 1.0,
          .change_x = s.real() / std::abs(s),
          .change_y = is_straight(s) ? 0 : s.imag() / std::abs(s),
          .change_side = std::sin(middle) < 0 ? -1.0 : 1.0,
          .ground_at_X = linkage.pole_joint() == Joint::X};
}

/// How far from its limits each row of a block is, in units of (a + b)^2; negative: past it.
struct Margins {
  static constexpr std::size_t rows = 256;
  std::array<double, rows> outer, inner, change;
};

/// The columns of one block.
struct Block {
  const double *tracer_x, *tracer_y;
  std::array<double*, 6> x, y;
};

/// The arithmetic of all rows of a block, without a branch.
void place_rows(const Shared& l, const Block& block, std::size_t count, Margins& margins) {
  const double square = 1 / (l.outer * l.outer), tiny = slack::above_zero_square;
  const double ground = l.ground_at_X ? 1 : 0;
  double *__restrict Vx = block.x[0], *__restrict Vy = block.y[0], *__restrict Ax = block.x[1],
         *__restrict Ay = block.y[1], *__restrict Bx = block.x[2], *__restrict By = block.y[2],
         *__restrict Cx = block.x[3], *__restrict Cy = block.y[3], *__restrict Xx = block.x[4],
         *__restrict Xy = block.y[4], *__restrict Yx = block.x[5], *__restrict Yy = block.y[5];
  const double* __restrict tx = block.tracer_x, * __restrict ty = block.tracer_y;
  for (std::size_t i = 0; i < count; ++i) {
    const double dx = tx[i] - l.pole_x, dy = ty[i] - l.pole_y;
    const double wx = dx * l.chain_x - dy * l.chain_y, wy = dx * l.chain_y + dy * l.chain_x;
    const double ww = wx * wx + wy * wy, w = std::sqrt(ww);
    const double outer = (l.outer - w) * (l.outer + w), inner = (w - l.inner) * (w + l.inner);
    const double product = outer * inner;
    const double h = l.side * std::sqrt(product > 0 ? product : 0.0);
    margins.outer[i] = outer * square;
    margins.inner[i] = inner * square;
    // cos(elbow) = (inner - outer) / (4ab), sin(elbow) = 2h / (4ab)
    margins.change[i] = l.change_side * (l.change_x * (2 * h) + l.change_y * (inner - outer)) * square;
    const double scale = 0.5 / (ww > tiny ? ww : tiny);
    const double pu = (ww + l.difference) * scale, qu = (ww - l.difference) * scale, v = h * scale;
    const double px = wx * pu + wy * v, py = wy * pu - wx * v;  // p = w (pu - i v)
    const double ux = wx * qu - wy * v, uy = wy * qu + wx * v;  // q/s = w (qu + i v)
    const double qx = ux * l.s_x - uy * l.s_y, qy = ux * l.s_y + uy * l.s_x;
    const double x = l.pole_x - ground * wx, y = l.pole_y - ground * wy;  // V
    Vx[i] = x;
    Vy[i] = y;
    Ax[i] = x + px;
    Ay[i] = y + py;
    Bx[i] = x + qx;
    By[i] = y + qy;
    Cx[i] = x + (px + qx);
    Cy[i] = y + (py + qy);
    Xx[i] = l.pole_x + (1 - ground) * wx;
    Xy[i] = l.pole_y + (1 - ground) * wy;
    Yx[i] = x + (qx + (px * l.s_x - py * l.s_y));
    Yy[i] = y + (qy + (px * l.s_y + py * l.s_x));
  }
}

constexpr double least_margin = -slack::batch_slack;

std::uint8_t code(Unreachable why) { return static_cast<std::uint8_t>(1 + static_cast<int>(why)); }

/// The outcome of one row; NaN counts as too near.
std::uint8_t outcome(const Margins& margins, std::size_t i) {
  if (margins.outer[i] < least_margin) return code(Unreachable::too_far);
  if (!(margins.inner[i] >= least_margin)) return code(Unreachable::too_near);
  if (margins.change[i] < least_margin) return code(Unreachable::beyond_change_point);
  return 0;
}

}  // namespace

void PoseBatch::resize(std::size_t count) {
  for (auto* columns : {&x_, &y_})
    for (auto& column : *columns) column.resize(count);
  outcome_.resize(count);
}

tl::expected<Pose, Unreachable> PoseBatch::operator[](std::size_t row) const {
  if (outcome_[row] != 0) return tl::unexpected(static_cast<Unreachable>(outcome_[row] - 1));
  Pose pose;
  for (const Joint joint : all_joints) pose[joint] = Point(x(joint)[row], y(joint)[row]);
  return pose;
}

void poses_with_tracer_at(const CopyingLinkage& linkage, std::span<const double> tracer_x,
                          std::span<const double> tracer_y, PoseBatch& poses) {
  const Shared shared = shared_by(linkage);
  const std::size_t all = std::min(tracer_x.size(), tracer_y.size());
  poses.resize(all);
  poses.reached_ = 0;
  Margins margins;
  for (std::size_t first = 0; first < all; first += Margins::rows) {
    const std::size_t count = std::min(Margins::rows, all - first);
    Block block{tracer_x.data() + first, tracer_y.data() + first, {}, {}};
    for (std::size_t j = 0; j < 6; ++j) {
      block.x[j] = poses.x_[j].data() + first;
      block.y[j] = poses.y_[j].data() + first;
    }
    place_rows(shared, block, count, margins);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint8_t found = outcome(margins, i);
      poses.outcome_[first + i] = found;
      poses.reached_ += found == 0;
      if (found == 0) continue;
      for (std::size_t j = 0; j < 6; ++j) block.x[j][i] = block.y[j][i] = 0;
    }
  }
}

}  // namespace kempe
