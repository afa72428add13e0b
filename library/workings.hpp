#pragma once
// The way between the public classes and what they hold: `FinishedDesign` is the public face of a `Design`
// (synthesis/design/design.hpp), `Outcome` that of a `SearchOutcome`.

#include <memory>
#include <string>
#include <utility>

#include "kempe/design.hpp"
#include "synthesis/design/design.hpp"
#include "synthesis/search/steps/outcome.hpp"

namespace kempe {

/// Makes the public classes and opens them; they name it as a friend.
struct Workings {
  static FinishedDesign finished(Design design, std::string spec_text) {
    return {std::make_shared<const Design>(std::move(design)), std::move(spec_text)};
  }
  static const Design& inside(const FinishedDesign& design) { return *design.inside_; }
  static const std::string& spec_text(const FinishedDesign& design) { return design.spec_text_; }

  static Outcome outcome(FinishedDesign design);
  static Outcome outcome(const NoDesign& none);
  static Outcome outcome(const Stopped& stopped);
  static Outcome outcome(InputError fault);
  /// A design that the map does not certify is none.
  static Outcome uncertified(std::string reason);
};

}  // namespace kempe
