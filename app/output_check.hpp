#pragma once
// What a run writes may be neither what it reads nor the same file twice.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kempe/input_error.hpp"

namespace kempe::app {

/// The first of `outputs` that is one of `inputs` or another of `outputs`, by whatever name (links, "..", hard links); empty
/// names are passed over, and so is what is no regular file: a device may be read and written.
std::optional<InputError> output_clash(const std::vector<std::filesystem::path>& inputs,
                                       const std::vector<std::filesystem::path>& outputs);

/// The same for files of these names in a folder.
std::optional<InputError> output_clash(const std::vector<std::filesystem::path>& inputs,
                                       const std::filesystem::path& folder,
                                       const std::vector<std::string>& names);

}  // namespace kempe::app
