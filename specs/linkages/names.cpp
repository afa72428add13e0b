#include "specs/linkages/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "specs/key_checks.hpp"

namespace kempe {
namespace {

bool is_good_name(const std::string& name) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return !name.empty() && name.size() <= 40 && is_letter(name[0]) && !name.ends_with("_deg") &&
         std::all_of(name.begin(), name.end(),
                     [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

template <class Names>
std::string nearest_of(const std::string& name, const Names& names) {
  std::vector<std::string_view> candidates;
  for (const auto& each : names) {
    if constexpr (requires { each.first; })
      candidates.push_back(each.first);
    else
      candidates.push_back(each);
  }
  if (candidates.empty()) return "none is defined";
  if (const auto meant = nearest(name, candidates))
    return fmt::format("the nearest defined one is {}", *meant);
  constexpr std::size_t most_shown = 12;
  const std::size_t shown = std::min(most_shown, candidates.size());
  return fmt::format(
      "defined: {}{}",
      fmt::join(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
      shown < candidates.size() ? ", ..." : "");
}

}  // namespace

bool LinkageNames::check_name(const NameAt& name, const std::string& key) {
  if (is_good_name(name.name)) return true;
  complaints_.add(name.line, key, fmt::format("the name \"{}\"", name.name.substr(0, 60)),
                  "a letter, then letters, digits and underscores, not ending in _deg");
  return false;
}

bool LinkageNames::define_point(const NameAt& name, const std::string& where) {
  if (!check_name(name, where)) return false;
  const auto [entry, is_new] = points_.try_emplace(name.name, where);
  if (!is_new)
    complaints_.add(name.line, where, fmt::format("{}, already defined in {}", name.name, entry->second),
                    "a new name");
  return is_new;
}

bool LinkageNames::define_link(const NameAt& name) {
  const std::string key = "links." + name.name;
  if (!check_name(name, key)) return false;
  const bool is_new = name.name != "ground" && links_.insert(name.name).second;
  if (!is_new) complaints_.add(name.line, key, fmt::format("the name {}", name.name), "another name");
  return is_new;
}

void LinkageNames::define_joints(const FileLink& link, int line) {
  for (const auto& [name, place] : link.joints)
    if (check_name({name, line}, "links." + link.name)) points_.try_emplace(name, "links." + link.name);
}

std::optional<Point> LinkageNames::local_place(const std::string& point, const std::string& link) const {
  const auto in = [&](const std::vector<NamedPoint>& list) -> std::optional<Point> {
    for (const auto& [name, place] : list)
      if (name == point) return place;
    return std::nullopt;
  };
  if (link == "ground") return in(file_.ground);
  for (const FileLink& each : file_.links)
    if (each.name == link) return in(each.joints);
  return std::nullopt;
}

bool LinkageNames::share_a_link(const std::string& a, const std::string& b) const {
  const auto both = [&](const std::string& link) { return local_place(a, link) && local_place(b, link); };
  return both("ground") || std::any_of(file_.links.begin(), file_.links.end(),
                                       [&](const FileLink& link) { return both(link.name); });
}

bool LinkageNames::require_point(const NameAt& name, const std::string& key) {
  if (is_point(name.name)) return true;
  complaints_.add(name.line, key, fmt::format("the point {}, which is not defined", name.name),
                  fmt::format("a point of [ground], of a link, of [bars] or of `points`; {}",
                              nearest_of(name.name, points_)));
  return false;
}

bool LinkageNames::require_link(const NameAt& name, const std::string& key) {
  if (name.name == "ground" || is_link(name.name)) return true;
  complaints_.add(name.line, key, fmt::format("the link {}, which is not defined", name.name),
                  fmt::format("a link of [links] or \"ground\"; {}", nearest_of(name.name, links_)));
  return false;
}

std::optional<std::string> LinkageNames::point(const LinkageTable& table, std::string_view key) {
  if (!table.has(key)) table.missing(key);
  const auto name = table.text(key);
  return name && require_point({*name, table.line(key)}, table.dotted(key)) ? name : std::nullopt;
}

std::optional<std::string> LinkageNames::link(const LinkageTable& table, std::string_view key) {
  if (!table.has(key)) table.missing(key);
  const auto name = table.text(key);
  return name && require_link({*name, table.line(key)}, table.dotted(key)) ? name : std::nullopt;
}

std::optional<Point> LinkageNames::place_on(const LinkageTable& table, std::string_view key,
                                            const std::string& link) {
  if (!table.has(key)) {
    table.missing(key);
    return std::nullopt;
  }
  if (!table.is_text(key)) {
    const auto at = table.point(key);
    return at ? std::optional<Point>(*at * file_.unit.in_mm) : std::nullopt;
  }
  const auto name = point(table, key);
  if (!name) return std::nullopt;
  auto local = local_place(*name, link);
  if (!local) table.refuse(key, fmt::format("{}, which is no point of {}", *name, link));
  return local;
}

std::vector<std::string> LinkageNames::points(const LinkageTable& table, std::string_view key) {
  std::vector<std::string> result;
  for (const NameAt& name : table.names(key))
    if (require_point(name, table.dotted(key))) result.push_back(name.name);
  return result;
}

}  // namespace kempe
