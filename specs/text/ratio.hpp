#pragma once
// Ratios as people write them.

#include <optional>
#include <string_view>

namespace kempe {

/// A positive ratio from "1:3", "1/3", "1 : 3" or "0.4"; nothing for any other text.
std::optional<double> parse_ratio(std::string_view text);

}  // namespace kempe
