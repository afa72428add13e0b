// Steps: lay out the wanted pairs of angles; search the four-bars through precision points, or those of least error; say
// what was found.

#include "synthesis/functions/function_generator.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "synthesis/functions/refinement.hpp"
#include "synthesis/functions/slack.hpp"

namespace kempe {

std::string_view name(FunctionMethod method) {
  switch (method) {
    case FunctionMethod::precision_points: return "precision_points";
    case FunctionMethod::least_squares: return "least_squares";
    case FunctionMethod::minimax: return "minimax";
  }
  return "";
}

std::optional<FreudensteinCoefficients> freudenstein_three_points(const std::vector<double>& phi,
                                                                  const std::vector<double>& psi) {
  if (phi.size() != 3 || psi.size() != 3) return std::nullopt;
  Eigen::Matrix3d rows;
  Eigen::Vector3d right;
  for (int i = 0; i < 3; ++i) {
    const auto j = static_cast<std::size_t>(i);
    rows.row(i) << std::cos(psi[j]), -std::cos(phi[j]), 1;
    right[i] = std::cos(phi[j] - psi[j]);
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(rows);
  if (lu.rcond() < slack::least_condition) return std::nullopt;
  const Eigen::Vector3d k = lu.solve(right);
  return FreudensteinCoefficients{k[0], k[1], k[2]};
}

namespace {

FunctionDefect commonest(const std::array<std::size_t, defect_kinds>& seen) {
  const auto most = std::max_element(seen.begin() + 1, seen.end());
  return *most == 0 ? FunctionDefect::none : static_cast<FunctionDefect>(most - seen.begin());
}

std::size_t count(const std::array<std::size_t, defect_kinds>& seen, FunctionDefect defect) {
  return seen[static_cast<std::size_t>(defect)];
}

/// The design with the rejections counted, or what was looked at in vain.
tl::expected<FunctionDesign, NoFunctionDesign> verdict(const std::optional<FunctionDesign>& chosen,
                                                       const std::array<std::size_t, defect_kinds>& seen,
                                                       const std::string& extent) {
  if (!chosen) {
    const FunctionDefect most = commonest(seen);
    const std::string found =
        most == FunctionDefect::none
            ? "no four-bar came near enough to be measured"
            : "every four-bar measured has a defect; the most frequent: " + std::string(name(most));
    return tl::unexpected(NoFunctionDesign{most, found + ". Searched: " + extent, false});
  }
  FunctionDesign design = *chosen;
  design.rejected_branch = count(seen, FunctionDefect::branch);
  design.rejected_order = count(seen, FunctionDefect::order);
  design.rejected_other = count(seen, FunctionDefect::does_not_assemble) +
                          count(seen, FunctionDefect::transmission) + count(seen, FunctionDefect::lengths) +
                          count(seen, FunctionDefect::start);
  return design;
}

NoFunctionDesign without_dial(const NoDial& why) {
  return {FunctionDefect::none, why.found, why.proven, why.allowed};
}

FunctionSearch searched(const FunctionTask& task, const WantedAngles& wanted) {
  if (task.method != FunctionMethod::precision_points) return search_function(task, wanted);
  PrecisionSearch precise = search_precision_points(task, wanted);
  return {std::move(precise.best), precise.seen, std::move(precise.extent)};
}

}  // namespace

tl::expected<FunctionDesign, NoFunctionDesign> generate_function(const FunctionTask& asked) {
  FunctionTask task = asked;
  if (task.method != FunctionMethod::precision_points) task.points = 3;  // of the starts of the search
  const WantedAngles wanted(task);
  if (wanted.no_dial()) return tl::unexpected(without_dial(*wanted.no_dial()));
  FunctionSearch search = task.stop() ? FunctionSearch{} : searched(task, wanted);
  const bool stopped = task.stop();
  if (!search.best && stopped) {
    NoFunctionDesign none{FunctionDefect::none, "before a four-bar was found"};
    none.stopped = true;
    return tl::unexpected(none);
  }
  if (search.best) {
    search.best->complete = !stopped;
    if (const auto x = complete_design(task, wanted, *search.best))
      return tl::unexpected(without_dial(not_finite_at(task, *x)));
    if (task.method != FunctionMethod::precision_points)
      search.best->precision_points = zeros_of(task, wanted, *search.best);
  }
  return verdict(search.best, search.seen, search.extent);
}

}  // namespace kempe
