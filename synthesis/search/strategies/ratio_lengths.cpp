#include "synthesis/search/strategies/ratio_lengths.hpp"

#include <algorithm>
#include <cmath>

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

bool is_among(const std::vector<double>& sorted, double length) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), length * (1 - same_length));
  return at != sorted.end() && *at <= length * (1 + same_length);
}

RatioLengths lengths_for_ratio(const std::vector<double>& lengths, double ratio) {
  RatioLengths found{.ratio = ratio};
  for (const double length : lengths) {
    if (is_among(lengths, length * ratio)) found.VA.push_back(length);
    if (is_among(lengths, length / ratio)) found.VB.push_back(length);
  }
  return found;
}

}  // namespace

RatioLengths stock_lengths_for(const StockLengths& stock_lengths, double scale_of_shape, double longest) {
  return lengths_for_ratio(all_lengths(stock_lengths, longest), scale_of_shape);
}

std::vector<RatioLengths> nearest_stock_lengths(const StockLengths& stock_lengths, double scale_of_shape,
                                                double longest, int count) {
  const std::vector<double> lengths = all_lengths(stock_lengths, longest);
  std::vector<double> ratios;
  for (const double VA : lengths) {  // for each VA the two lengths next to |s| VA
    const auto above = std::lower_bound(lengths.begin(), lengths.end(), VA * scale_of_shape);
    if (above != lengths.end()) ratios.push_back(*above / VA);
    if (above != lengths.begin()) ratios.push_back(*std::prev(above) / VA);
  }
  const auto off = [&](double ratio) { return std::abs(ratio - scale_of_shape); };
  std::sort(ratios.begin(), ratios.end(),
            [&](double a, double b) { return off(a) < off(b) || (off(a) == off(b) && a < b); });
  std::vector<RatioLengths> found;
  for (const double ratio : ratios) {
    if (static_cast<int>(found.size()) == count) break;
    if (!found.empty() && std::abs(found.back().ratio - ratio) <= same_length * ratio) continue;
    if (RatioLengths here = lengths_for_ratio(lengths, ratio); !here.VA.empty() && !here.VB.empty())
      found.push_back(std::move(here));
  }
  return found;
}

}  // namespace kempe
