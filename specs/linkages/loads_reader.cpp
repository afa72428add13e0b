#include "specs/linkages/loads_reader.hpp"

#include <fmt/format.h>

namespace kempe {
namespace {

constexpr double mm_a_metre = 1000;

/// Complains about a key that does not go with another one.
void forbid_beside(const LinkageTable& table, std::string_view key, std::string_view beside,
                   std::string_view allowed) {
  if (table.has(key)) table.refuse(key, fmt::format("a key beside `{}`", beside), std::string(allowed));
}

void read_pair_force(const LinkageTable& table, LinkageNames& names, LinkageFile& file) {
  for (const std::string_view key : {"at", "link", "turns_with"})
    forbid_beside(table, key, "between", "`between` and `newton` alone");
  const auto newton = table.number("newton");
  if (!table.has("newton")) table.missing("newton");
  const std::vector<NameAt> ends = table.names("between");
  if (ends.empty()) return;  // complained about
  if (ends.size() != 2 || ends[0].name == ends[1].name)
    return table.refuse("between",
                        ends.size() == 2 ? ends[0].name + " twice" : fmt::format("{} points", ends.size()));
  for (const NameAt& end : ends)
    if (!names.require_point(end, table.dotted("between"))) return;
  if (names.share_a_link(ends[0].name, ends[1].name))
    return table.refuse("between",
                        fmt::format("{} and {}, two points of one link", ends[0].name, ends[1].name),
                        "points of different links");
  if (newton) file.loads.pairs.push_back({ends[0].name, ends[1].name, *newton});
}

/// The link that bears a force at a point, as far as the file says it.
std::optional<std::string> bearer_of(const LinkageTable& table, const std::string& point,
                                     LinkageNames& names) {
  if (table.has("link")) {
    const auto link = names.link(table, "link");
    if (!link) return std::nullopt;
    if (*link != "ground" && names.local_place(point, *link)) return link;
    table.refuse("link",
                 *link == "ground" ? "the ground" : fmt::format("{}, which does not hold {}", *link, point),
                 fmt::format("a link that holds {}", point));
    return std::nullopt;
  }
  if (!names.local_place(point, "ground")) return "";
  table.refuse("at", fmt::format("{}, a point of the ground", point),
               "a point that can move, or `link` besides: the link that bears the force there");
  return std::nullopt;
}

}  // namespace

void read_force(const LinkageTable& table, LinkageNames& names, LinkageFile& file) {
  if (table.has("between")) return read_pair_force(table, names, file);
  FileForce force;
  const auto at = names.point(table, "at");
  const auto newton = table.point("newton");
  if (!table.has("newton")) table.missing("newton");
  if (table.has("turns_with")) {
    const auto with = names.link(table, "turns_with");
    if (!with) return;
    force.turns_with = *with;
  }
  const auto bearer = at ? bearer_of(table, *at, names) : std::nullopt;
  if (!at || !newton || !bearer) return;
  force.at = *at;
  force.link = *bearer;
  force.newton = *newton;
  file.loads.forces.push_back(std::move(force));
}

void read_moment(const LinkageTable& table, LinkageNames& names, LinkageFile& file) {
  const auto on = names.link(table, "on");
  const auto against =
      table.has("against") ? names.link(table, "against") : std::optional<std::string>("ground");
  const auto moment = table.number("newton_m");
  if (!table.has("newton_m")) table.missing("newton_m");
  if (!on || !against || !moment) return;
  if (*on == "ground") return table.refuse("on", "the ground");
  if (*on == *against) return table.refuse("against", fmt::format("{} twice", *on), "another link");
  file.loads.moments.push_back({*on, *against, *moment * mm_a_metre});
}

void read_mass(const LinkageTable& table, const NameAt& name, LinkageNames& names, LinkageFile& file) {
  FileMass mass;
  const auto kg = table.positive("kg");
  if (!table.has("kg")) table.missing("kg");
  if (names.is_link(name.name)) {
    mass.link = name.name;
    const auto inertia = table.number("kg_m2");
    if (inertia && *inertia < 0) return table.refuse("kg_m2", fmt::format("{:g}", *inertia));
    mass.inertia = inertia.value_or(0) * mm_a_metre * mm_a_metre;
    const auto centre = names.place_on(table, "at", name.name);
    if (!centre) return;
    mass.centre = *centre;
  } else {
    for (const std::string_view key : {"at", "kg_m2"})
      forbid_beside(table, key, "kg", "`kg` alone: the mass of a point");
    if (!names.require_point(name, "masses." + name.name)) return;
    if (names.local_place(name.name, "ground"))
      return table.refuse("kg", fmt::format("the mass of {}, a point of the ground", name.name),
                          "a link, or a point that can move");
    mass.point = name.name;
  }
  if (!kg) return;
  mass.kg = *kg;
  file.loads.masses.push_back(std::move(mass));
}

void read_gravity(const LinkageTable& root, LinkageFile& file) {
  const auto gravity = root.point("gravity");
  if (!gravity) return;
  file.loads.gravity = *gravity;
  if (file.loads.masses.empty())
    root.refuse("gravity", "gravity without masses", "a table [masses] for it to act on");
}

}  // namespace kempe
