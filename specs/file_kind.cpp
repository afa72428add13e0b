#include "specs/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "specs/text/json_text.hpp"
#include "specs/text/toml_access.hpp"

namespace kempe {
namespace {

/// "a spec", and what reads it.
struct KindWords {
  std::string_view name, use;
};

KindWords words_of(FileKind kind) {
  switch (kind) {
    case FileKind::spec:
      return {"a spec of a copying linkage",
              "kempe synthesize finds its design, kempe workspace maps its [mechanism]"};
    case FileKind::json_spec:
      return {"a spec as JSON", "kempe synthesize --batch takes it as a line of a .jsonl file"};
    case FileKind::sweep: return {"a sweep", "kempe synthesize --batch takes it"};
    case FileKind::linkage:
      return {"a linkage file", "kempe solve moves it, kempe mobility and kempe centres analyse it"};
    case FileKind::measurements: return {"a file of measurements", "kempe calibrate takes it"};
    case FileKind::function: return {"a spec of a function generator", "kempe function takes it"};
    case FileKind::inversor: return {"a spec of an inversor", "kempe inversor takes it"};
    case FileKind::path: return {"a spec of a path generator", "kempe path takes it"};
    case FileKind::design: return {"a design.json", "kempe verify checks it, kempe trace draws with it"};
    case FileKind::drawing:
      return {"a drawing", "kempe trace copies an SVG; a spec names a drawing as region.file"};
  }
  return {};
}

bool has_any_of(const toml::table& file, std::initializer_list<std::string_view> tables) {
  return std::any_of(tables.begin(), tables.end(),
                     [&](std::string_view table) { return file.contains(table); });
}

/// By tables that no other kind has.
std::optional<FileKind> kind_of(const toml::table& file) {
  if (has_any_of(file, {"copy", "region", "pole", "obstacles", "mechanism"})) return FileKind::spec;
  if (has_any_of(file, {"reading", "instrument", "lengths_mm", "simulate"})) return FileKind::measurements;
  if (has_any_of(file, {"function"})) return FileKind::function;
  if (has_any_of(file, {"lens"})) return FileKind::inversor;
  if (has_any_of(file, {"path"})) return FileKind::path;
  if (has_any_of(file,
                 {"bars", "bounds", "drivers", "gears", "ground", "guess", "motion", "racks", "sliders"}))
    return FileKind::linkage;
  return std::nullopt;
}

bool is_geojson(const nlohmann::json& file) {
  return file.contains("features") || file.contains("coordinates") || file.contains("geometry");
}

std::optional<FileKind> kind_of(const nlohmann::json& file) {
  if (!file.is_object()) return std::nullopt;
  const auto format = file.find("format");
  const bool says_so = format != file.end() && format->is_string() &&
                       format->get_ref<const std::string&>().starts_with("kempe-design");
  if (says_so || (file.contains("mechanism") && file.contains("quality"))) return FileKind::design;
  if (file.contains("spec") && file.contains("axes")) return FileKind::sweep;
  if (is_geojson(file)) return FileKind::drawing;
  return file.contains("copy") ? std::optional(FileKind::json_spec) : std::nullopt;
}

bool is_svg(std::string_view text) {
  constexpr std::size_t head = 4096;
  return text.starts_with("<") && text.substr(0, head).find("<svg") != std::string_view::npos;
}

/// A DXF begins with the group code 0 and the word SECTION, a line each; comments (999) may stand before.
bool is_dxf(std::string_view text) {
  constexpr std::size_t head = 200;
  const std::string_view start = text.substr(0, head);
  return (start.starts_with("0") || start.starts_with("999")) &&
         start.find("\nSECTION") != std::string_view::npos;
}

}  // namespace

std::optional<FileKind> recognised_kind(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n\xEF\xBB\xBF"), text.size()));
  if (is_svg(text) || is_dxf(text)) return FileKind::drawing;
  if (text.starts_with("{")) {
    const auto json = parse_json(text, "");
    return json ? kind_of(*json) : std::nullopt;
  }
  const auto toml = parse_toml(text, "");
  return toml ? kind_of(*toml) : std::nullopt;
}

InputError or_other_kind(InputError faults, std::string_view text, FileKind expected) {
  const auto kind = recognised_kind(text);
  if (!kind || *kind == expected) return faults;
  const KindWords found = words_of(*kind), wanted = words_of(expected);
  return {faults.file, 0, "", std::string(found.name), fmt::format("{}; {}", wanted.name, found.use)};
}

}  // namespace kempe
