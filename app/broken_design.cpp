#include "app/broken_design.hpp"

#include <fmt/format.h>

#include "specs/text/printable.hpp"

namespace kempe::app {

std::string broken_text(const DesignAudit& found, const std::string& file) {
  std::string text = printable(file) + ":";
  for (const BrokenLimit& breach : found.broken)
    text += fmt::format("\n  {}: {}", breach.limit, breach.sentence);
  return text;
}

}  // namespace kempe::app
