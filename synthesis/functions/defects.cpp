#include "synthesis/functions/defects.hpp"

namespace kempe {

std::string_view name(FunctionDefect defect) {
  switch (defect) {
    case FunctionDefect::none: return "none";
    case FunctionDefect::does_not_assemble: return "the loop does not close over the whole range";
    case FunctionDefect::branch: return "the precision points lie on both branches";
    case FunctionDefect::order: return "the output crank turns back within the range";
    case FunctionDefect::transmission: return "the transmission angle falls below the limit";
    case FunctionDefect::lengths: return "a link vanishes or grows too long";
    case FunctionDefect::start: return "a crank would have to start half a turn from the start given";
  }
  return "";
}

}  // namespace kempe
