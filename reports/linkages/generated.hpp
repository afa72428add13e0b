#pragma once
// What `kempe inversor`, `kempe function` and `kempe path` design, as a linkage file that `solve`, `mobility` and `centres` take.

#include <string>

#include "synthesis/functions/function_generator.hpp"
#include "synthesis/functions/inversor.hpp"
#include "synthesis/paths/coupler_copy.hpp"
#include "synthesis/paths/path_generator.hpp"

namespace kempe {

/// The inversor with its focus O at the origin and the scale line along x: the object's point P at x = f/m from O is driven over
/// the range of magnifications, the image's point Q follows at x' = f m; on the same side of O with Peaucellier's, on the
/// other with Hart's and the right angle, whose pivot F stands at distance f from the scale line. mm; every
/// length to its last digit.
std::string inversor_linkage(const InversorTask& task, const InversorDesign& design);

/// The four-bar O-A-B-D with its input crank O-A driven over its range, O at the origin, D on the x axis; the table has the output
/// crank's angle. `wanted` says in one line what function it is. mm, degrees; every number to its last digit.
std::string function_linkage(const FunctionTask& task, const FunctionDesign& design,
                             const std::string& wanted);

/// The name of the coupler point in the linkages of path answers: what was asked for is asked of it.
inline constexpr const char* coupler_point_name = "P";

/// The four-bar of an answer, crank pivot O, joints A and B, rocker pivot D, coupler point P, its crank driven from the first point to the
/// last; or one of its cognates (0 or 1, which the answer must have), driven by the link that moves P in the same way. mm, degrees; every
/// number to its last digit.
std::string path_linkage(const PathAnswer& answer, std::optional<std::size_t> cognate = std::nullopt);

/// The six-bar of a copy: the four-bar it stands on as in path_linkage, C on its coupler, the links O-Q (or D-Q) and Q-C-Y, and the point Y that
/// draws the copy. mm, degrees; every number to its last digit.
std::string copy_linkage(const PathAnswer& answer, const CopyTask& task, const CouplerCopy& copy);

}  // namespace kempe
