#pragma once
// The specs that the project ships.

#include <string>

#include "specs/spec_reader.hpp"

namespace kempe::test {

/// The spec `name` of specs/examples; throws if it cannot be read.
inline Spec shipped_spec(const std::string& name) {
  return read_spec_file(std::string(KEMPE_SOURCE_DIR "/specs/examples/") + name + ".toml").value();
}

}  // namespace kempe::test
