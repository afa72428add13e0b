#pragma once
// What the fuzzers feed: one function a reader. Each must return for any bytes: a value or an error, never a crash. The
// same functions replay the stored corpus in the ordinary tests.

#include <span>
#include <string_view>

namespace kempe::fuzz {

struct Target {
  std::string_view name;  ///< the corpus folder's name too
  void (*run)(std::string_view input);
};

std::span<const Target> targets();

/// The target of a name, or nullptr.
const Target* find(std::string_view name);

}  // namespace kempe::fuzz
