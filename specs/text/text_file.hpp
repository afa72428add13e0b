#pragma once
// Files that come in, read whole.

#include <cstddef>
#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "kempe/input_error.hpp"

namespace kempe {

/// Input files may not be larger, bytes: a spec with a million corners has 30 million.
inline constexpr std::size_t largest_input_file = 256u << 20;

/// The whole contents of a file or a pipe. The error (with the path as `file`) says whether there is no such file, it
/// is a folder, it cannot be read, it is larger than `largest_input_file`, or it is a named pipe that brings nothing for
/// ten seconds.
tl::expected<std::string, InputError> read_text_file(const std::filesystem::path& path);

}  // namespace kempe
