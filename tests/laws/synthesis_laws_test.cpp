// What must become of the design when the whole task is moved, enlarged or mirrored: the same worth, enlarged with it.
#include "synthesis/search/search.hpp"
#include "tests/laws/law.hpp"
#include "tests/laws/movement.hpp"
#include "tests/synthesis/search_specimens.hpp"

namespace kempe {
namespace {

/// Share by which a design's worth may differ in the moved task: the search is stopped as near to its bound.
constexpr double as_good = 2e-3;

laws::Movement draw_movement() {
  return {*laws::logarithmic(0.2, 5), *laws::angle(), *laws::point(300), *rc::gen::arbitrary<bool>()};
}

void same_worth(const Spec& spec, const laws::Movement& movement) {
  const SearchOutcome found = synthesize(spec, {.diagnose = false}),
                      moved = synthesize(movement(spec), {.diagnose = false});
  RC_ASSERT(found.index() == moved.index());
  const auto* design = std::get_if<FoundDesign>(&found);
  if (!design) return;
  const auto& other = std::get<FoundDesign>(moved);
  const double unit = design->goal == Goal::transmission ? 1 : movement.scale;
  RC_ASSERT(std::abs(other.value / unit - design->value) <= as_good * design->value);
}

TEST(SynthesisLaws, AMovedTaskHasAMovedDesignOfTheSameWorth) {
  laws::law(
      40,
      [] {
        test::SpecDice dice(static_cast<unsigned>(*laws::whole(0, 1 << 20)));
        same_worth(dice.spec(), draw_movement());
      },
      laws::Shrink::no);
}

}  // namespace
}  // namespace kempe
