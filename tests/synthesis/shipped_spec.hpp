#pragma once
// The specs that the project ships.

#include <stdexcept>
#include <string>
#include <utility>

#include "specs/spec_reader.hpp"

namespace kempe::test {

/// The spec `name` of specs/examples. Throws what is wrong with it if it cannot be read.
inline Spec shipped_spec(const std::string& name) {
  auto spec = read_spec_file(std::string(KEMPE_SOURCE_DIR "/specs/examples/") + name + ".toml");
  if (!spec) throw std::runtime_error(spec.error().message());
  return *std::move(spec);
}

}  // namespace kempe::test
