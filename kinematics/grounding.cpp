#include "kinematics/grounding.hpp"

#include <algorithm>

namespace kempe {
namespace {

/// What a grounding is, in a line.
struct Facts {
  Grounding grounding;
  std::string_view name;
  JointRoles roles;
  Complex (*shape)(Complex k);
  Complex (*ratio)(Complex shape);
  Complex (*chain)(Complex k);
  bool chain_is_scaled;  ///< by |k|
};

constexpr std::array<Facts, 3> table{{
    {Grounding::pole,
     "pole",
     {Joint::V, Joint::X, Joint::Y},
     [](Complex k) { return k; },
     [](Complex s) { return s; },
     [](Complex) { return Complex(1); },
     false},
    {Grounding::tracer,
     "tracer",
     {Joint::X, Joint::V, Joint::Y},
     [](Complex k) { return 1.0 - k; },
     [](Complex s) { return 1.0 - s; },
     [](Complex) { return Complex(-1); },
     false},
    {Grounding::pen,
     "pen",
     {Joint::X, Joint::Y, Joint::V},
     [](Complex k) { return 1.0 - 1.0 / k; },
     [](Complex s) { return 1.0 / (1.0 - s); },
     [](Complex k) { return -k; },
     true},
}};

const Facts& facts(Grounding grounding) { return table[static_cast<std::size_t>(grounding)]; }

template <typename Wanted>
std::optional<Grounding> first_with(const Wanted& wanted) {
  const auto found = std::find_if(table.begin(), table.end(), wanted);
  return found == table.end() ? std::nullopt : std::optional(found->grounding);
}

}  // namespace

char letter(Joint joint) { return "VABCXY"[static_cast<int>(joint)]; }

std::string_view name(Grounding grounding) { return facts(grounding).name; }

std::optional<Grounding> grounding_named(std::string_view word) {
  return first_with([&](const Facts& each) { return each.name == word; });
}

JointRoles roles_of(Grounding grounding) { return facts(grounding).roles; }

std::optional<Grounding> grounding_with(const JointRoles& roles) {
  return first_with([&](const Facts& each) { return each.roles == roles; });
}

bool pole_is_at_V(Grounding grounding) { return facts(grounding).roles.pole == Joint::V; }

bool pen_is_at_V(Grounding grounding) { return facts(grounding).roles.pen == Joint::V; }

Complex shape_of(Complex k, Grounding grounding) { return facts(grounding).shape(k); }

Complex ratio_of(Complex shape, Grounding grounding) { return facts(grounding).ratio(shape); }

Complex chain_per_tracer(Complex k, Grounding grounding) { return facts(grounding).chain(k); }

double chain_length_per_tracer(Complex k, Grounding grounding) {
  return facts(grounding).chain_is_scaled ? std::abs(k) : 1;
}

}  // namespace kempe
