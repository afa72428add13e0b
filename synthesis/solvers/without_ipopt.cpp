// solvers/polish.hpp for builds without Ipopt: SLSQP once more, from where the first solution ended.
#include "synthesis/solvers/nlopt_backend.hpp"
#include "synthesis/solvers/polish.hpp"

namespace kempe {

std::string polish_solver() { return nlopt_name() + " SLSQP"; }

LocalResult polish(const SmoothProgram& program, const DesignVector& start, const StopFlag& stop) {
  return minimize_by_sqp(program, start, 400, stop);
}

LongResult polish(const LongProgram& program, const Eigen::VectorXd& start) {
  return minimize_by_sqp(program, start, 400);
}

}  // namespace kempe
