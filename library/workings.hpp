#pragma once
// What the public classes carry inside, and how the library makes them.

#include <memory>
#include <string>
#include <utility>

#include "kempe/design.hpp"
#include "synthesis/design/design.hpp"
#include "synthesis/search/steps/outcome.hpp"

namespace kempe {

/// The way into the public classes; they name it as a friend.
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
