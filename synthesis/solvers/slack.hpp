#pragma once
// Every slack and threshold of the solvers, each with its reason. Programs come scaled: variables, constraints and costs are of order 1,
// so all are without a unit.

namespace kempe::slack {

// NLopt and Ipopt: as fine as they reach; what they leave is decided by the search's own check, not by these

/// What a constraint may be missed by.
inline constexpr double solver_constraint = 1e-12;
/// Share by which variables, or the cost, change no more.
inline constexpr double solver_variables = 1e-13, solver_cost = 1e-14;
/// Ipopt's optimality error.
inline constexpr double ipopt_optimality = 1e-10;
/// Share of 1 + |x|: the step of differences of gradients.
inline constexpr double hessian_step = 1e-5;

// Newton's polish

/// A constraint or bound this close to zero counts as active.
inline constexpr double active_below = 1e-6;
/// A step this short is rounding.
inline constexpr double converged_step = 1e-14;
/// The last step of a polish that counts: twenty times the step of the next, in squares, is rounding.
inline constexpr double last_step = 1e-11;
/// A longer step leads away from the solution that was to be polished.
inline constexpr double longest_step = 1e-3;
/// Share of the largest pivot: below it a row depends on the others.
inline constexpr double rank_tolerance = 1e-10;
/// A multiplier down to minus this is zero: its constraint stays active.
inline constexpr double multiplier_rounding = 1e-9;

// The minimax step (an exchange of rows)

/// Share of the largest figure: a row above the level by no more lies on it.
inline constexpr double row_rounding = 1e-11;
/// A multiplier that falls by no more does not fall.
inline constexpr double fall_rounding = 1e-11;

}  // namespace kempe::slack
