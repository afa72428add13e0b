#pragma once
// NLopt behind our own nouns: the global and the first local search.

#include <cstdint>
#include <span>

#include "synthesis/solvers/smooth_program.hpp"

namespace kempe {

/// "NLopt 2.7.1"
std::string nlopt_name();

/// A point of the unit cube that the global search looked at. The smaller the merit the better.
struct Explored {
  std::vector<double> z;
  double merit = 0;
};

struct ExploreTask {
  int dimensions = 2;  ///< of the unit cube
  int evaluations = 0;
  std::uint64_t seed = 0;
  std::function<double(std::span<const double> z)> merit;  ///< finite everywhere
  StopFlag stop;
};

/// Every point that a deterministic division of the unit cube (DIRECT-L) and then a controlled random search
/// (CRS2) looked at, in their order: half of the evaluations each. Same task, same points, on any thread.
std::vector<Explored> explore(const ExploreTask& task);

/// Sequential quadratic programming (SLSQP) from a start, which is moved into the bounds.
LocalResult minimize_by_sqp(const SmoothProgram& program, const DesignVector& start, int most_evaluations,
                            const StopFlag& stop);

/// The same for any number of variables; ends only where they change no more, for a cost that is to fall to nothing.
LongResult minimize_by_sqp(const LongProgram& program, const Eigen::VectorXd& start, int most_evaluations);

}  // namespace kempe
