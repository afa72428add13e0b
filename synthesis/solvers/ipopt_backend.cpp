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

/// The program as Ipopt asks for it: dense Jacobian, the equalities' rows last, lower triangle of a dense Hessian. No callback throws.
template <class Vector, class Matrix>
class Transcription : public Ipopt::TNLP {
 public:
  using Program = NonlinearProgram<Vector, Matrix>;

  Transcription(const Program& program, const Vector& start, const StopFlag& stop,
                LocalSolution<Vector>& result)
      : program_(program), start_(start), stop_(stop), result_(result) {}

  bool get_nlp_info(Index& n, Index& m, Index& jacobian_entries, Index& hessian_entries,
                    IndexStyleEnum& style) override {
    n = program_.size();
    m = program_.constraint_count + program_.equality_count;
    jacobian_entries = n * m;
    hessian_entries = n * (n + 1) / 2;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* x_lower, Number* x_upper, Index m, Number* g_lower,
                       Number* g_upper) override {
    for (Index i = 0; i < n; ++i) x_lower[i] = program_.lower[i], x_upper[i] = program_.upper[i];
    for (Index i = 0; i < m; ++i) g_lower[i] = 0, g_upper[i] = i < program_.constraint_count ? 2e19 : 0;
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
    Vector derivative(n);
    program_.objective(vector(n, x), &derivative);
    for (Index i = 0; i < n; ++i) gradient[i] = derivative[i];
    return derivative.allFinite();
  }

  bool eval_g(Index n, const Number* x, bool, Index m, Number* values) override {
    const ConstraintValues seen = rows(vector(n, x), nullptr);
    for (Index i = 0; i < m; ++i) values[i] = seen[i];
    return seen.allFinite();
  }

  bool eval_jac_g(Index n, const Number* x, bool, Index m, Index, Index* row, Index* column,
                  Number* values) override {
    if (!values) {
      for (Index i = 0; i < m; ++i)
        for (Index j = 0; j < n; ++j) row[i * n + j] = i, column[i * n + j] = j;
      return true;
    }
    ConstraintGradients gradients(m, n);
    rows(vector(n, x), &gradients);
    for (Index i = 0; i < m; ++i)
      for (Index j = 0; j < n; ++j) values[i * n + j] = gradients(i, j);
    return gradients.allFinite();
  }

  bool eval_h(Index n, const Number* x, bool, Number factor, Index m, const Number* multipliers, bool, Index,
              Index* row, Index* column, Number* values) override {
    Index entry = 0;
    if (!values) {
      for (Index i = 0; i < n; ++i)
        for (Index j = 0; j <= i; ++j) row[entry] = i, column[entry++] = j;
      return true;
    }
    // Ipopt's Lagrangian adds the constraints, ours subtracts them.
    const Eigen::VectorXd subtracted = -Eigen::Map<const Eigen::VectorXd>(multipliers, m);
    const Matrix hessian = program_.hessian ? program_.hessian(vector(n, x), factor, subtracted)
                                            : hessian_by_differences(vector(n, x), factor, subtracted);
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
  static Vector vector(Index n, const Number* x) { return Eigen::Map<const Eigen::VectorXd>(x, n); }

  ConstraintValues rows(const Vector& x, ConstraintGradients* gradients) const {
    const Index own = program_.constraint_count, equalities = program_.equality_count;
    ConstraintValues values(own + equalities);
    const auto fill = [&](const typename Program::Rows& some, Index first, Index count) {
      if (count == 0) return;
      ConstraintValues part(count);
      ConstraintGradients slopes(gradients ? count : 0, x.size());
      some(x, part, gradients ? &slopes : nullptr);
      values.segment(first, count) = part;
      if (gradients) gradients->middleRows(first, count) = slopes;
    };
    fill(program_.constraints, 0, own);
    fill(program_.equalities, own, equalities);
    return values;
  }

  Vector lagrangian_gradient(const Vector& x, double factor, const Eigen::VectorXd& multipliers) const {
    Vector gradient(x.size());
    program_.objective(x, &gradient);
    ConstraintGradients slopes(multipliers.size(), x.size());
    rows(x, &slopes);
    return factor * gradient - slopes.transpose() * multipliers;
  }

  Matrix hessian_by_differences(const Vector& x, double factor, const Eigen::VectorXd& multipliers) const {
    Matrix hessian(x.size(), x.size());
    for (Index j = 0; j < x.size(); ++j) {
      const double step = slack::hessian_step * (1 + std::abs(x[j]));
      Vector ahead = x, behind = x;
      ahead[j] += step;
      behind[j] -= step;
      hessian.col(j) = (lagrangian_gradient(ahead, factor, multipliers) -
                        lagrangian_gradient(behind, factor, multipliers)) /
                       (ahead[j] - behind[j]);
    }
    return 0.5 * (hessian + hessian.transpose());
  }

  const Program& program_;
  const Vector& start_;
  const StopFlag& stop_;
  LocalSolution<Vector>& result_;
};

/// MUMPS, which Ipopt solves its linear systems with, is not thread-safe.
std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

template <class Vector, class Matrix>
LocalSolution<Vector> solved(const NonlinearProgram<Vector, Matrix>& program, const Vector& start,
                             const StopFlag& stop, int most_iterations) {
  const std::lock_guard<std::mutex> lock(one_at_a_time());
  LocalSolution<Vector> result{.x = start};
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> solver = new Ipopt::IpoptApplication(false);
  solver->Options()->SetStringValue("sb", "yes");
  solver->Options()->SetIntegerValue("print_level", 0);
  solver->Options()->SetIntegerValue("max_iter", most_iterations);
  solver->Options()->SetNumericValue("tol", slack::ipopt_optimality);
  solver->Options()->SetNumericValue("bound_relax_factor", 0);
  solver->Options()->SetStringValue("mu_strategy", "adaptive");
  // Ipopt refines a linear solution as long as its residual is too large. To do so once more in any case costs a tenth of a search
  // here, as each call of MUMPS takes 0.1 ms whatever the size.
  solver->Options()->SetIntegerValue("min_refinement_steps", 0);
  // Without the name of a file it would take options from an ipopt.opt in the working directory.
  if (solver->Initialize("") != Ipopt::Solve_Succeeded) return result;
  const Ipopt::SmartPtr<Ipopt::TNLP> problem =
      new Transcription<Vector, Matrix>(program, start, stop, result);
  const Ipopt::ApplicationReturnStatus status = solver->OptimizeTNLP(problem);
  result.usable = (status == Ipopt::Solve_Succeeded || status == Ipopt::Solved_To_Acceptable_Level) &&
                  result.x.allFinite();
  return result;
}

}  // namespace

std::string polish_solver() { return "Ipopt " IPOPT_VERSION; }

LocalResult polish(const SmoothProgram& program, const DesignVector& start, const StopFlag& stop) {
  return solved(program, start, stop, 60);
}

LongResult polish(const LongProgram& program, const Eigen::VectorXd& start) {
  return solved(program, start, StopFlag(), 300);
}

}  // namespace kempe
