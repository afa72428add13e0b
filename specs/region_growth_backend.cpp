#include "specs/region_growth.hpp"
namespace kempe {
tl::expected<Region, std::string> grown(const Region& region, double margin) {
  if (margin == 0) return region;
  return tl::unexpected(std::string("a region that cannot be grown"));
}
}  // namespace kempe
