#pragma once
// A second, independent solver for the last digits. Ipopt where the build has it (KEMPE_WITH_IPOPT), else
// NLopt again.

#include "synthesis/solvers/smooth_program.hpp"

namespace kempe {

/// "Ipopt 3.11.9", or NLopt's name.
std::string polish_solver();

/// From a point close to a solution to a better one, with exact Hessians. Safe to call from any thread (calls
/// wait for each other: Ipopt's linear solver is not thread-safe).
LocalResult polish(const SmoothProgram& program, const DesignVector& start, const StopFlag& stop);

/// The same for any number of variables; a program without a Hessian has it from differences of gradients.
LongResult polish(const LongProgram& program, const Eigen::VectorXd& start);

}  // namespace kempe
