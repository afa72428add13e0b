#pragma once
// What the rows of a design problem share: the variables' places, the lengths they stand for.

#include "synthesis/problem/design_problem.hpp"

namespace kempe::row_parts {

inline constexpr int log_VA = DesignLayout::log_VA, log_VB = DesignLayout::log_VB;
inline constexpr int pole_x = DesignLayout::pole_x;

/// Openings looked at for the largest load error between the region's two openings.
inline constexpr int load_openings = 9;

inline LogLengths lengths_of(const DesignVector& x) { return {x[log_VA], x[log_VB]}; }

inline RowJet zero_jet(int n) { return {0, DesignVector::Zero(n), DesignMatrix::Zero(n, n)}; }

}  // namespace kempe::row_parts
