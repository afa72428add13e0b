// A free pole finds the place; a fixed one at that place, rounded to what is printed, must have a design too.

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "synthesis/problem/local_frame.hpp"
#include "synthesis/search/diagnosis/relaxation_words.hpp"
#include "synthesis/search/diagnosis/relaxations.hpp"

namespace kempe {
namespace {

/// The spec with a pole anywhere in the region's box grown all around.
Spec with_free_pole(Spec spec, double margin) {
  const Box box = bounding_box(spec.region);
  const Point grown(margin, margin);
  spec.pole.place = Region::rectangle(box.lower - grown, box.upper - box.lower + 2 * grown);
  return spec;
}

/// A place rounded on the table, and the corners of its square of the grid, the nearest first.
std::array<Point, 4> rounded_places(const Point& on_table, double step) {
  const Point nearest = (on_table / step).array().round() * step;
  const Point beside =
      nearest + step * Point(on_table.x() < nearest.x() ? -1 : 1, on_table.y() < nearest.y() ? -1 : 1);
  return {nearest, Point(beside.x(), nearest.y()), Point(nearest.x(), beside.y()), beside};
}

struct FixedPole {
  Point on_table;  ///< mm
  FoundDesign design;
};

/// A place of few digits next to that of a design, with its own design.
std::optional<FixedPole> fixed_near(Questions& questions, const Point& pole, double size) {
  Spec spec = questions.spec();
  const double unit = in_mm(questions.unit()), coarsest = std::floor(std::log10(size / unit)) - 2;
  for (int finer = 0; finer < questions.budget().pole_digits; ++finer)
    for (const Point& place :
         rounded_places(pole + questions.origin(), unit * std::pow(10, coarsest - finer))) {
      spec.pole.place = Point(place - questions.origin());
      if (auto design = questions.best_of(spec)) return FixedPole{place, *std::move(design)};
    }
  return std::nullopt;
}

std::optional<Relaxation> elsewhere(Questions& questions, double margin) {
  const auto free = questions.best_of(with_free_pole(questions.spec(), margin));
  if (!free) return std::nullopt;
  const bool was_fixed = questions.spec().pole.is_fixed();
  const SpecUnit unit = questions.unit();
  const std::string key = was_fixed ? "pole.at_mm" : "pole.within_mm", named = name_in(unit, key);
  if (auto fixed = fixed_near(questions, free->linkage.pole(), free->linkage.size()))
    return Relaxation{.key = key,
                      .sentence = fmt::format("{} is in the way; the pole at {} would do", named,
                                              place_text(fixed->on_table, unit)),
                      .design = std::move(fixed->design)};
  return Relaxation{
      .key = key,
      .sentence = fmt::format("{} is in the way; with the pole free to stand within {} {} of the region a "
                              "design exists",
                              named, six_digits(margin, unit), name(unit)),
      .design = *free};
}

}  // namespace

void relax_pole(Questions& questions) {
  if (questions.stopped() || questions.has("pole.within_mm")) return;
  questions.note(questions.spec().pole.is_fixed() ? "pole.at_mm" : "pole.within_mm");
  const Box box = bounding_box(questions.spec().region);
  const double beside = (box.upper - box.lower).norm(), farthest = 2 * questions.limits().longest;
  for (const double margin : {std::min(beside, farthest), farthest})
    if (auto found = elsewhere(questions, margin)) return questions.keep(std::move(found));
}

}  // namespace kempe
