#include "specs/region_growth.hpp"

namespace kempe {

tl::expected<Region, InputError> grown_region(const Region& region, double margin,
                                              const std::string& file_name) {
  auto result = grown(region, margin);
  if (result) return std::move(*result);
  return tl::unexpected(InputError{file_name, 0, "", result.error(), "a simpler drawing, or margin_mm = 0"});
}

}  // namespace kempe
