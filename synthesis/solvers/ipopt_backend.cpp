// Ipopt behind solvers/polish.hpp. Compiled only with KEMPE_WITH_IPOPT (Eclipse licence: README, Licence).
#include <IpoptConfig.h>

#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <cmath>
#include <mutex>

#include "synthesis/solvers/polish.hpp"
#include "synthesis/solvers/slack.hpp"

namespace kempe {
namespace {

using Ipopt::Index;
using Ipopt::Number;

/// The program as Ipopt asks for it: dense Jacobian, lower triangle of a dense Hessian. No callback throws.
class Transcription : public Ipopt::TNLP {
 public:
  Transcription(const SmoothProgram& program, const DesignVector& start, const StopFlag& stop,
                LocalResult& result)
      : program_(program), start_(start), stop_(stop), result_(result) {}

  bool get_nlp_info(Index& n, Index& m, Index& jacobian_entries, Index& hessian_entries,
                    IndexStyleEnum& style) override {
    n = program_.size();
    m = program_.constraint_count;
    jacobian_entries = n * m;
    hessian_entries = n * (n + 1) / 2;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* x_lower, Number* x_upper, Index m, Number* g_lower,
                       Number* g_upper) override {
    for (Index i = 0; i < n; ++i) x_lower[i] = program_.lower[i], x_upper[i] = program_.upper[i];
    for (Index i = 0; i < m; ++i) g_lower[i] = 0, g_upper[i] = 2e19;
    return true;
  }

  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool, Number*) override {
    for (Index i = 0; i < n; ++i) x[i] = start_[i];
    return true;
  }

  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    ++result_.evaluations;
    value = program_.objective(vector(n, x), nullptr);
    return std::isfinite(value);
  }

  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    DesignVector derivative(n);
    program_.objective(vector(n, x), &derivative);
    for (Index i = 0; i < n; ++i) gradient[i] = derivative[i];
    return derivative.allFinite();
  }

  bool eval_g(Index n, const Number* x, bool, Index m, Number* values) override {
    ConstraintValues seen(m);
    program_.constraints(vector(n, x), seen, nullptr);
    for (Index i = 0; i < m; ++i) values[i] = seen[i];
    return seen.allFinite();
  }

  bool eval_jac_g(Index n, const Number* x, bool, Index m, Index, Index* rows, Index* columns,
                  Number* values) override {
    if (!values) {
      for (Index i = 0; i < m; ++i)
        for (Index j = 0; j < n; ++j) rows[i * n + j] = i, columns[i * n + j] = j;
      return true;
    }
    ConstraintValues seen(m);
    ConstraintGradients gradients(m, n);
    program_.constraints(vector(n, x), seen, &gradients);
    for (Index i = 0; i < m; ++i)
      for (Index j = 0; j < n; ++j) values[i * n + j] = gradients(i, j);
    return gradients.allFinite();
  }

  bool eval_h(Index n, const Number* x, bool, Number factor, Index m, const Number* multipliers, bool, Index,
              Index* rows, Index* columns, Number* values) override {
    Index entry = 0;
    if (!values) {
      for (Index i = 0; i < n; ++i)
        for (Index j = 0; j <= i; ++j) rows[entry] = i, columns[entry++] = j;
      return true;
    }
    // Ipopt's Lagrangian adds the constraints, ours subtracts them.
    const Eigen::VectorXd subtracted = -Eigen::Map<const Eigen::VectorXd>(multipliers, m);
    const DesignMatrix hessian = program_.hessian(vector(n, x), factor, subtracted);
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j <= i; ++j) values[entry++] = hessian(i, j);
    return hessian.allFinite();
  }

  bool intermediate_callback(Ipopt::AlgorithmMode, Index, Number, Number, Number, Number, Number, Number,
                             Number, Number, Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    return !stop_();
  }

  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number*, const Number*, Index,
                         const Number*, const Number*, Number, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    result_.x = vector(n, x);
  }

 private:
  static DesignVector vector(Index n, const Number* x) { return Eigen::Map<const Eigen::VectorXd>(x, n); }

  const SmoothProgram& program_;
  const DesignVector& start_;
  const StopFlag& stop_;
  LocalResult& result_;
};

/// MUMPS, which Ipopt solves its linear systems with, is not thread-safe.
std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

std::string polish_solver() { return "Ipopt " IPOPT_VERSION; }

LocalResult polish(const SmoothProgram& program, const DesignVector& start, const StopFlag& stop) {
  const std::lock_guard<std::mutex> lock(one_at_a_time());
  LocalResult result{.x = start};
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> solver = new Ipopt::IpoptApplication(false);
  solver->Options()->SetStringValue("sb", "yes");
  solver->Options()->SetIntegerValue("print_level", 0);
  solver->Options()->SetIntegerValue("max_iter", 60);
  solver->Options()->SetNumericValue("tol", slack::ipopt_optimality);
  solver->Options()->SetNumericValue("bound_relax_factor", 0);
  solver->Options()->SetStringValue("mu_strategy", "adaptive");
  if (solver->Initialize() != Ipopt::Solve_Succeeded) return result;
  const Ipopt::SmartPtr<Ipopt::TNLP> problem = new Transcription(program, start, stop, result);
  const Ipopt::ApplicationReturnStatus status = solver->OptimizeTNLP(problem);
  result.usable = (status == Ipopt::Solve_Succeeded || status == Ipopt::Solved_To_Acceptable_Level) &&
                  result.x.allFinite();
  return result;
}

}  // namespace kempe
