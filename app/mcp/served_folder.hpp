#pragma once
// The folder that a server's tools may read and write: no path leads out of it.

#include <filesystem>
#include <optional>
#include <string>

#include "kempe/input_error.hpp"

namespace kempe::app {

/// What a tool does with a path.
enum class PathUse {
  input,         ///< a file to read
  output_file,   ///< a file to write, whose name ends in .svg or .csv
  output_folder  ///< a folder to write files into, below the served one
};

/// Why a tool may not use a path given as `key`, or nothing. Paths are relative to the working folder, which is the served one. A path
/// that leaves it by "..", an absolute one, and one on which a link stands are refused, so are inputs that are no regular files
/// and output folders that hold links. That a file is absent is not said here.
std::optional<InputError> path_fault(const std::string& key, const std::string& path, PathUse use);

/// The same for a file that the text of another names, by a path from that one's folder.
std::optional<InputError> named_path_fault(const std::string& key, const std::string& naming_file,
                                           const std::filesystem::path& named);

}  // namespace kempe::app
