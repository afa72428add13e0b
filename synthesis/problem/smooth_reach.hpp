#pragma once
// The reach of one grounding and assembly mode, as smooth functions and in closed form.
//
//   b = VB/|s|,  psi = d - arg s,  c = |chain per tracer| (1, 1 or |k|)
//   W = VA^2 + b^2 + 2 VA b cos psi,   tracer's distance from the pole  r = sqrt(W) / c
//
// With m^2 = 2 VA b and lambda = log(b / VA) this is  W = m^2 (cosh lambda + cos psi).  So a pair of lengths
// covers the distances r_min .. r_max between the openings d_near and d_far if, and only if,
//
//   log m <= log(c r_min) - 1/2 log(cosh lambda + cos psi_near)
//   log m >= log(c r_max) - 1/2 log(cosh lambda + cos psi_far)
//
// and such an m exists if, and only if,  cosh lambda <= (cos psi_far - q^2 cos psi_near) / (q^2 - 1),  q =
// r_max/r_min.

#include <Eigen/Core>
#include <optional>

#include "kinematics/copying_linkage.hpp"

namespace kempe {

/// A value with its derivatives by u = log VA, v = log VB and the opening d.
struct LinkageJet {
  double value = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

/// Two link lengths as logarithms of millimetres.
struct LogLengths {
  double u = 0, v = 0;
};

/// The same in millimetres, and b = VB / |s|.
struct SideLengths {
  double VA = 0, VB = 0, b = 0;
};

struct LogRange {
  double lower = 0, upper = 0;
  bool empty() const { return !(lower <= upper); }
  double width() const { return upper - lower; }
};

/// Bounds of log VA and log VB.
struct LogBox {
  LogRange u, v;
};

/// What a grounding and an assembly mode fix, whatever the lengths.
class Reach {
 public:
  Reach(Complex k, Grounding grounding, int assembly_mode);

  Complex shape() const { return s_; }
  const OpeningInterval& interval() const { return interval_; }
  /// True if the region's nearest place belongs to the interval's lower end.
  bool near_is_lower() const { return near_is_lower_; }

  /// Tracer's distance from the pole, mm, with exact derivatives.
  LinkageJet radius(const LogLengths& lengths, double opening) const;
  double radius_value(const LogLengths& lengths, double opening) const;
  SideLengths sides(const LogLengths& lengths) const;
  /// The opening at a distance (mm), clamped to the interval where it is out of reach.
  double opening_at(const LogLengths& lengths, double radius) const {
    return opening_at(sides(lengths), radius);
  }
  double opening_at(const SideLengths& sides, double radius) const;
  /// exp(i opening_at()), mostly without a sine or an arc.
  Complex direction_at(const SideLengths& sides, double radius) const;

  /// How far an opening stands from the interval's near or far end, rad (negative outside).
  double from_near_end(double opening) const;
  double from_far_end(double opening) const;

  /// The pairs of lengths that reach r_min .. r_max (mm) with openings inside `allowed`, as lambda =
  /// log(b/VA) from -limit to limit; nothing if no lengths do.
  std::optional<double> lambda_limit(double r_min, double r_max, const OpeningInterval& allowed) const;
  /// For a lambda within its limit: the log m that reach; and those inside the box of lengths.
  LogRange log_m_range(double lambda, double r_min, double r_max, const OpeningInterval& allowed) const;
  LogRange log_m_range(double lambda, const LogBox& box) const;
  LogRange lambda_range(const LogBox& box) const;
  LogLengths lengths(double lambda, double log_m) const;

  /// Link lengths are VA times {1, 1, |s|, |1-s|} (VA, BC, BY, CY) and VB times {1, 1, 1/|s|, |1-s|/|s|} (VB,
  /// AC, AX, CX). The smallest and largest of these factors, and size = size_per_VA VA + size_per_VB VB.
  struct LengthFactors {
    double least_of_VA, most_of_VA, least_of_VB, most_of_VB, size_per_VA, size_per_VB;
  };
  const LengthFactors& factors() const { return factors_; }

 private:
  /// Squares in proportion to those of sine and cosine of psi / 2, mm^2.
  struct HalfAngle {
    double outer, inner;
  };
  HalfAngle half_angle(const SideLengths& sides, double radius) const;
  double near_cosine(const OpeningInterval& allowed) const;  ///< cos psi at the end nearer to the pole
  double far_cosine(const OpeningInterval& allowed) const;

  Complex s_;
  Complex direction_of_s_;
  double chain_, log_s_, arg_s_;
  double bend_;  ///< sign of sin psi over the interval
  OpeningInterval interval_;
  Complex lower_end_, upper_end_;  ///< directions of the interval's ends
  bool near_is_lower_;
  LengthFactors factors_{};
};

}  // namespace kempe
