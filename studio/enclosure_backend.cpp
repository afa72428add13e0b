#include "geometry/interval.hpp"
#include "studio/enclosure.hpp"

namespace kempe::studio {
namespace {

bool has_width(const Interval& value) { return value.inf() < value.sup(); }
bool holds(const Interval& value, double within) { return value.inf() <= within && within <= value.sup(); }

}  // namespace

bool intervals_hold() {
  const OutwardRounding upwards;
  volatile double one = 1, three = 3, two = 2, tenth = 0.1;  // not for the compiler to work out
  const Interval third = Interval(one) / Interval(three);
  const Interval root = CGAL::sqrt(Interval(two));
  const Interval sum = Interval(tenth) + Interval(three);  // 0.1 + 3 is no double
  return has_width(third) && holds(third * Interval(three), 1) && has_width(root) && holds(root * root, 2) &&
         has_width(sum) && has_width(Interval(tenth) * Interval(tenth));
}

}  // namespace kempe::studio
