#include "specs/drawings/stroke_joining.hpp"

#include <algorithm>
#include <optional>

namespace kempe {
namespace {

/// End e of stroke i is number 2 i + e: 0 its first point, 1 its last.
class Ends {
 public:
  Ends(const std::vector<DrawnStroke>& strokes, double gap)
      : strokes_(strokes), partner_(2 * strokes.size()) {
    for (std::size_t end = 0; end < partner_.size(); ++end)
      if (!strokes[end / 2].closed) order_.push_back(end);
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return at(a).x() < at(b).x(); });
    for (std::size_t i = 0; i < order_.size(); ++i) meet(i, gap);
    for (std::size_t end = 0; end < partner_.size(); ++end)
      if (crowded_.size() > end && crowded_[end]) partner_[end].reset();
    for (std::size_t end = 0; end < partner_.size(); ++end)
      if (partner_[end] && partner_[*partner_[end]] != end) partner_[end].reset();
  }

  std::optional<std::size_t> partner(std::size_t end) const { return partner_[end]; }

 private:
  const Point& at(std::size_t end) const {
    const Stroke& points = strokes_[end / 2].points;
    return end % 2 == 0 ? points.front() : points.back();
  }

  void meet(std::size_t i, double gap) {
    crowded_.resize(partner_.size(), false);
    const std::size_t one = order_[i];
    for (std::size_t j = i + 1; j < order_.size() && at(order_[j]).x() <= at(one).x() + gap; ++j) {
      const std::size_t other = order_[j];
      if ((at(one) - at(other)).norm() > gap) continue;
      for (const auto& [end, with] : {std::pair{one, other}, std::pair{other, one}}) {
        if (partner_[end]) crowded_[end] = true;
        partner_[end] = with;
      }
    }
  }

  const std::vector<DrawnStroke>& strokes_;
  std::vector<std::optional<std::size_t>> partner_;
  std::vector<bool> crowded_;
  std::vector<std::size_t> order_;
};

void extend(Stroke& chain, const Stroke& points, bool reversed) {
  const auto add = [&](auto begin, auto end) {
    if (!chain.empty() && begin != end && chain.back() == *begin) ++begin;
    chain.insert(chain.end(), begin, end);
  };
  reversed ? add(points.rbegin(), points.rend()) : add(points.begin(), points.end());
}

}  // namespace

std::vector<DrawnStroke> joined(std::vector<DrawnStroke> strokes, double gap) {
  const Ends ends(strokes, gap);
  std::vector<bool> used(strokes.size(), false);
  std::vector<DrawnStroke> result;
  const auto follow = [&](std::size_t start) {
    DrawnStroke chain;
    std::optional<std::size_t> entry = start;
    while (entry && !used[*entry / 2]) {
      used[*entry / 2] = true;
      extend(chain.points, strokes[*entry / 2].points, *entry % 2 == 1);
      entry = ends.partner(*entry ^ 1);
    }
    chain.closed = entry.has_value() && *entry == start && chain.points.size() > 2;
    if (chain.closed && chain.points.front() == chain.points.back()) chain.points.pop_back();
    result.push_back(std::move(chain));
  };
  // Chains from their free ends first; what remains are circles.
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (strokes[i].closed) {
      result.push_back(strokes[i]);
      used[i] = true;
    }
    for (const std::size_t end : {2 * i, 2 * i + 1})
      if (!used[i] && !ends.partner(end)) follow(end);
  }
  for (std::size_t i = 0; i < strokes.size(); ++i)
    if (!used[i]) follow(2 * i);
  return result;
}

}  // namespace kempe
