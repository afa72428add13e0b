#include "reports/data/links_csv.hpp"

#include <fmt/format.h>

#include "reports/data/link_shape.hpp"
#include "synthesis/design/rounding.hpp"

namespace kempe {
namespace {

/// The link whose two joints the length's name gives.
Link link_of_length(std::string_view length) {
  for (const Link link : all_links)
    if (name(link).find(length[0]) != std::string_view::npos &&
        name(link).find(length[1]) != std::string_view::npos)
      return link;
  return Link::VA;
}

}  // namespace

std::string links_csv(const Design& design) {
  std::string text = "link,length,mm,layer,shape,rounded_mm\n";
  const auto values = design.linkage.lengths().values();
  const RoundedLengths rounded = rounded_lengths(design);
  const auto as_made = rounded.lengths.values();
  const int decimals = decimals_of(rounded);
  // Twelve digits: more would be the rounding of doubles, 114.30000000000001 for 4.5 in. design.json has them all.
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Link link = link_of_length(LinkLengths::names[i]);
    text += fmt::format("{},{},{:.12g},{},{},{:.{}f}\n", name(link), LinkLengths::names[i], values[i],
                        design.layers[link], shape_as_made(link, design.style, design.linkage.shape()),
                        as_made[i], decimals);
  }
  return text;
}

}  // namespace kempe
