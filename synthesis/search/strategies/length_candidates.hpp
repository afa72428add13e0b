#pragma once
// Pairs of stock lengths in the order in which they are tried.

#include "synthesis/search/steps/relax.hpp"
#include "synthesis/search/steps/search_result.hpp"
#include "synthesis/search/strategies/ratio_lengths.hpp"

namespace kempe {

struct LengthPair {
  double VA, VB;  ///< mm
};

/// The prospects that differ in their layers alone: of one grounding, assembly mode and interval of openings.
struct Shape {
  std::vector<std::size_t> prospects;  ///< indices
  RatioLengths lengths;
};
std::vector<Shape> shapes_of(const SearchTask& task, const std::vector<Prospect>& prospects);

/// A pair of lengths of a shape, with what orders the candidates.
struct LengthCandidate {
  const Shape* shape;
  LengthPair lengths;
  double order;
};

/// By size, from the size that no lengths can beat up to `largest` (mm).
std::vector<LengthCandidate> candidates_by_size(const SearchTask& task,
                                                const std::vector<Prospect>& prospects,
                                                const std::vector<Shape>& shapes,
                                                const std::optional<FoundDesign>& any_lengths,
                                                double largest);

/// Those next to the best lengths of each shape, by what the task's goal promises there without contact.
std::vector<LengthCandidate> candidates_near(const SearchTask& task, const std::vector<Prospect>& prospects,
                                             const std::vector<Shape>& shapes,
                                             const std::optional<FoundDesign>& any_lengths);

}  // namespace kempe
