// kempe/write.hpp.

#include "kempe/write.hpp"
#include "reports/page/studio_page.hpp"
#include "specs/spec_reader.hpp"

namespace kempe {

std::variant<std::string, InputError> studio_page(const std::string& page, std::string_view spec,
                                                  const std::string& name,
                                                  const std::filesystem::path& folder) {
  if (const auto checked = read_spec(spec, name, folder); !checked) return checked.error();
  const auto inside = studio_spec(name, std::string(spec), folder);
  if (!inside) return inside.error();
  if (auto filled = studio_page_with(page, *inside)) return std::move(*filled);
  return InputError{"", 0, "page", "no page of the studio",
                    "one that scripts/studio of this version has built"};
}

}  // namespace kempe
