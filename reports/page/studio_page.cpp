#include "reports/page/studio_page.hpp"

#include <nlohmann/json.hpp>
#include <string_view>

#include "reports/pictures/html_text.hpp"
#include "specs/spec_reader.hpp"
#include "specs/text/text_file.hpp"

namespace kempe {
namespace {

using Json = nlohmann::ordered_json;

// As studio/make_page.py writes it; what stands between is JSON without any <.
constexpr std::string_view opening = R"(<script type="application/json" id="studio-spec">)";
constexpr std::string_view closing = "</script>";

std::string data_of(const StudioSpec& spec) {
  Json files = Json::array();
  if (spec.drawing) files.push_back({{"name", spec.drawing->name}, {"text", spec.drawing->text}});
  const Json data{{"name", spec.name}, {"text", spec.text}, {"files", std::move(files)}};
  return script_escaped(data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

tl::expected<StudioSpec, InputError> studio_spec(std::string name, std::string text,
                                                 const std::filesystem::path& folder) {
  StudioSpec spec{std::move(name), std::move(text), std::nullopt};
  if (const auto drawing = region_file_of(spec.text)) {
    auto found = read_text_file(folder / *drawing);
    if (!found) return tl::unexpected(found.error());
    spec.drawing = {std::filesystem::path(*drawing).filename().string(), std::move(*found)};
  }
  return spec;
}

std::optional<std::string> studio_page_with(const std::string& page, const StudioSpec& spec) {
  const std::size_t found = page.find(opening);
  if (found == std::string::npos) return std::nullopt;
  const std::size_t start = found + opening.size(), end = page.find(closing, start);
  if (end == std::string::npos) return std::nullopt;
  return page.substr(0, start) + data_of(spec) + page.substr(end);
}

}  // namespace kempe
