#pragma once
// workshop.pdf: the drawings to make a design from.

#include <string>

#include "kempe/drawing_options.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// What the drawings say beside the design. Every text may be anything.
struct WorkshopJob {
  std::string title;            ///< empty: one made from the copy ratio
  std::string program_version;  ///< "0.1.0"
  Paper paper = Paper::A4;      ///< to print on
};

/// The file: assembly, stack, each link with its dimensions (1:1, in tiles where the paper is smaller), the bench plan, parts list and
/// cutting list, on the paper that the job names. It depends on its arguments alone: no date of today. Every dimension is that of
/// design.json to 0.0005 mm; lines lie within 1e-4 mm of where they should.
std::string workshop_pdf(const Design& design, const WorkshopJob& job);

}  // namespace kempe
