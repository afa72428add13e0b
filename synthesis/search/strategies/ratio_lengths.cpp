#include "synthesis/search/strategies/ratio_lengths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "kinematics/copying_linkage.hpp"
#include "synthesis/search/steps/slack.hpp"

namespace kempe {
namespace {

using slack::same_length;

std::vector<double> all_lengths(const StockLengths& stock_lengths, double longest) {
  std::vector<double> lengths = stock_lengths.stock;
  if (stock_lengths.grid)
    for (int i = 1; i * *stock_lengths.grid <= longest * (1 + same_length); ++i)
      lengths.push_back(i * *stock_lengths.grid);
  std::sort(lengths.begin(), lengths.end());
  lengths.erase(std::remove_if(lengths.begin(), lengths.end(),
                               [&](double x) { return x > longest * (1 + same_length); }),
                lengths.end());
  return lengths;
}

/// The one of these lengths that is this one up to rounding.
std::optional<double> among(const std::vector<double>& sorted, double length) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), length * (1 - same_length));
  return at != sorted.end() && *at <= length * (1 + same_length) ? std::optional(*at) : std::nullopt;
}

/// What the locked lengths leave of VA, or of VB: `all`, one of them, or none.
std::vector<double> left_by_locks(const StockLengths& stock_lengths, const std::vector<double>& all,
                                  Complex shape, bool of_VA) {
  const std::array<double, 8> per_bar = lengths_of_links(shape, 1, 1).values();
  std::optional<std::vector<double>> left;
  for (std::size_t i = 0; i < per_bar.size(); ++i) {
    if (!stock_lengths.locked[i] || is_multiple_of_VA[i] != of_VA) continue;
    const auto only = among(left ? *left : all, *stock_lengths.locked[i] / per_bar[i]);
    if (!only) return {};
    left = {*only};
  }
  return left.value_or(all);
}

RatioLengths lengths_for_shape(const StockLengths& stock_lengths, const std::vector<double>& lengths,
                               Complex shape) {
  RatioLengths found{.ratio = std::abs(shape)};
  for (const double VA : left_by_locks(stock_lengths, lengths, shape, true))
    if (among(lengths, VA * found.ratio)) found.VA.push_back(VA);
  if (found.VA.empty()) return found;
  for (const double VB : left_by_locks(stock_lengths, lengths, shape, false))
    if (among(lengths, VB / found.ratio)) found.VB.push_back(VB);
  return found;
}

}  // namespace

RatioLengths stock_lengths_for(const StockLengths& stock_lengths, Complex shape, double longest) {
  return lengths_for_shape(stock_lengths, all_lengths(stock_lengths, longest), shape);
}

std::vector<RatioLengths> nearest_stock_lengths(const StockLengths& stock_lengths, Complex shape,
                                                double longest, int count) {
  const std::vector<double> lengths = all_lengths(stock_lengths, longest);
  const double scale = std::abs(shape);
  const bool any_locked = std::any_of(stock_lengths.locked.begin(), stock_lengths.locked.end(),
                                      [](const auto& length) { return length.has_value(); });
  const std::ptrdiff_t each_side = any_locked ? 16 : 1;  // most ratios do not keep a locked length
  std::vector<double> ratios;
  for (const double VA : lengths) {  // for each VA the lengths next to |s| VA
    const auto above = std::lower_bound(lengths.begin(), lengths.end(), VA * scale);
    const auto first = above - std::min(each_side, above - lengths.begin());
    const auto last = above + std::min(each_side, lengths.end() - above);
    for (auto BY = first; BY != last; ++BY) ratios.push_back(*BY / VA);
  }
  const auto off = [&](double ratio) { return std::abs(ratio - scale); };
  std::sort(ratios.begin(), ratios.end(),
            [&](double a, double b) { return off(a) < off(b) || (off(a) == off(b) && a < b); });
  std::vector<RatioLengths> found;
  for (const double ratio : ratios) {
    if (static_cast<int>(found.size()) == count) break;
    if (!found.empty() && std::abs(found.back().ratio - ratio) <= same_length * ratio) continue;
    RatioLengths here = lengths_for_shape(stock_lengths, lengths, shape / scale * ratio);
    if (here.VA.empty() || here.VB.empty()) continue;
    here.ratio = ratio;
    found.push_back(std::move(here));
  }
  return found;
}

}  // namespace kempe
