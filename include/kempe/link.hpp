#pragma once
// The moving links of the copying linkage.

#include <array>

namespace kempe {

/// The four moving links, in the order of every array over links.
enum class Link { VA, VB, ACX, BCY };
inline constexpr std::array<Link, 4> all_links{Link::VA, Link::VB, Link::ACX, Link::BCY};

}  // namespace kempe
