#pragma once
// Files that appear whole or not at all.

#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace kempe {

/// A file's name and whole contents.
struct OutputFile {
  std::filesystem::path name;  ///< relative to the output folder; may have one sub-folder
  std::string contents;
};

/// Writes `contents` beside `path` under a name of its own and renames it. On failure nothing is left behind and the
/// error is a sentence that names the path.
tl::expected<void, std::string> write_whole(const std::filesystem::path& path, std::string_view contents);

/// Writes all files into `folder` (made if absent): first every file beside its place, then the renames, so that a
/// failure before the first rename leaves the folder as it was.
tl::expected<void, std::string> write_whole(const std::filesystem::path& folder,
                                            const std::vector<OutputFile>& files);

}  // namespace kempe
