#pragma once
// Every requirement evaluated anew at a finished linkage, by the rooms below and nothing of the search.

#include <optional>

#include "synthesis/problem/requirements.hpp"

namespace kempe {

struct DesignCheck {
  bool feasible = false;
  std::optional<Goal> broken;  ///< the first limit that does not hold; transmission stands for the reach too
  OpeningInterval needed{};    ///< openings that covering the region needs; empty if it cannot be reached
  OpeningInterval opening{};   ///< certified: transmission and self-contact kept; holds `needed` if feasible
  Attained attained{};         ///< copy_error 0 without [tolerance]; footprint not measured
  double load_error_of_links = 0;  ///< mm, also where attained.load_error has pins and layers in it
};

/// Obstacles are not looked at (obstacle_check.hpp). A limit that is met up to slack::limit_rounding of itself
/// is met.
DesignCheck check_design(const Spec& spec, const Requirements& limits, const CopyingLinkage& linkage,
                         const LayerAssignment& layers);

/// True if VA, VB, AX and BY, and AC and BC with them, are lengths of the grid or the list, and every locked length is as it was locked.
bool keeps_stock_lengths(const CopyingLinkage& linkage, const StockLengths& stock_lengths);

}  // namespace kempe
