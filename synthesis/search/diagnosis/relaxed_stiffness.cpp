// Where a limit on load error or sag is in the way: wider or thicker links, or a stiffer material. How much is estimated from what
// designs attain; then the spec is searched with it.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "specs/materials.hpp"
#include "synthesis/search/diagnosis/least_change.hpp"
#include "synthesis/search/diagnosis/relaxation_words.hpp"
#include "synthesis/search/diagnosis/relaxations.hpp"

namespace kempe {
namespace {

/// How many times what is demanded the best designs give way; 1 where no such limit is in the way.
struct TooSoft {
  double by_load = 1, by_sag = 1;
};

TooSoft too_soft(const Questions& questions) {
  TooSoft times;
  for (const Relaxation& one : questions.found()) {
    if (one.key == "limits.load_error_mm")
      times.by_load = std::max(1.0, one.design.attained.load_error / one.demanded);
    if (one.key == "limits.sag_mm") times.by_sag = std::max(1.0, *one.possible / one.demanded);
  }
  return times;
}

/// A dimension of the links' section, and the powers of it that a bar's deflections fall with: in the plane by a force, and out of it by the
/// bar's own weight.
struct Dimension {
  const char* key;
  double LinkStyle::*value;
  double power_in_plane, power_of_sag;
};
constexpr std::array<Dimension, 2> dimensions{
    {{"links.width_mm", &LinkStyle::width, 3, 1}, {"links.thickness_mm", &LinkStyle::thickness, 1, 2}}};

/// The least of a few sizes with which there is a design. Where the spec lists sections it is another one of them.
void larger(Questions& questions, const Dimension& dimension, const TooSoft& times) {
  const Spec& spec = questions.spec();
  const bool has_sections = !spec.links.sections.empty();
  const double given = spec.links.style.*dimension.value;
  const double estimate = given * std::max(std::pow(times.by_load, 1 / dimension.power_in_plane),
                                           std::pow(times.by_sag, 1 / dimension.power_of_sag));
  if (estimate > questions.budget().largest_section * given || questions.stopped()) return;
  const std::string key = has_sections ? "links.sections_mm" : dimension.key;
  questions.note(key);
  const auto section = [&](double size) {
    LinkStyle style = spec.links.style;
    style.*dimension.value = size;
    return LinkSection{style.width, style.thickness};
  };
  auto found = least_change(
      questions, given, [&](double share) { return share * estimate; },
      [&](double size) { return next_size(size, questions.unit()); },
      [&](double size) {
        Spec other = spec;
        use_section(other.links.style, section(size));
        if (has_sections) other.links.sections = {section(size)};
        return questions.best_of(other);
      });
  if (!found) return;
  if (has_sections) found->design.section = section(found->value);
  questions.keep(Relaxation{.key = key,
                            .sentence = has_sections
                                            ? section_would_do(section(found->value), questions.unit())
                                            : length_would_do(key, given, found->value, questions.unit()),
                            .design = std::move(found->design),
                            .is_least = found->is_least});
}

std::string known_would_do(const Material& given, const KnownMaterial& other) {
  return fmt::format("material.name = \"{}\" is in the way; \"{}\" would do", given.name, other.name);
}

std::string instead_of_own(const Material& given, const KnownMaterial& other) {
  return fmt::format(
      "the material \"{}\", with figures of its own, is in the way; \"{}\" without them would do", given.name,
      other.name);
}

/// The least stiff of the known materials with which there is a design.
void stiffer_material(Questions& questions, const TooSoft& times) {
  const Material& given = *questions.spec().material;
  const KnownMaterial* known = material_named(given.name);
  // Figures of the spec's own have to go with the name.
  const bool is_known = known != nullptr && as_material(*known) == given;
  const std::string key = is_known ? "material.name" : "material";
  std::vector<const KnownMaterial*> stiffer;
  for (const KnownMaterial& each : known_materials())
    if (each.name != given.name &&
        as_material(each).E > given.E * std::max(1.0, questions.budget().stiffer.front() * times.by_load))
      stiffer.push_back(&each);
  std::stable_sort(stiffer.begin(), stiffer.end(),
                   [](const auto* one, const auto* other) { return one->E_GPa < other->E_GPa; });
  for (const KnownMaterial* each : stiffer) {
    if (questions.stopped()) return;
    questions.note(key);
    Spec spec = questions.spec();
    spec.material = as_material(*each);
    if (auto design = questions.best_of(spec))
      return questions.keep(
          Relaxation{.key = key,
                     .sentence = is_known ? known_would_do(given, *each) : instead_of_own(given, *each),
                     .design = *std::move(design)});
  }
}

}  // namespace

void relax_stiffness(Questions& questions) {
  const TooSoft times = too_soft(questions);
  if (times.by_load == 1 && times.by_sag == 1) return;
  for (const Dimension& dimension : dimensions) larger(questions, dimension, times);
  stiffer_material(questions, times);
}

}  // namespace kempe
