#pragma once
// Follower and cutter: what stands on the tracer so that what the pen's cutter leaves is the copy wanted.
//
// A follower of radius f runs along the template's edge, so the tracer's path is the edge moved out by f. The copy of that
// path is moved out by |k| f from the edge's copy, and a cutter of radius c that runs along it cuts at |k| f - c. The cut is
// the exact copy if |k| f = c. With any other pair the template must itself be moved out by c/|k| - f (in, if negative).

#include <optional>

#include "specs/spec.hpp"

namespace kempe {

struct ToolAdvice {
  std::optional<double> follower_radius{}, cutter_radius{};  ///< mm, as given
  std::optional<double> exact_follower_radius{};             ///< mm, c/|k|; absent without a cutter
  std::optional<double> exact_cutter_radius{};               ///< mm, |k| f; absent without a follower
  /// mm, how far outside the copy's edge the cut lies (inside, if negative)
  std::optional<double> cut_outside{};
  std::optional<double> template_offset{};  ///< mm by which the template must be moved out to make up for it
};

/// Nothing if the spec has no [tool]. `scale` = |k| > 0.
std::optional<ToolAdvice> tool_advice(const ToolSpec& tool, double scale);

}  // namespace kempe
