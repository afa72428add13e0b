#pragma once
// What an earlier design left in a folder: its parts must not be taken for those of the design that is written there now.

#include <filesystem>
#include <string>
#include <vector>

namespace kempe {

/// The files of a design that lie in a folder, by the names that a design's files have (design_package.hpp, certificate.hpp); none where there
/// is no design.json. The studio's page is not among them: it is a tool, whatever spec it holds.
std::vector<std::string> design_files_in(const std::filesystem::path& folder);

/// Removes those of the `earlier` files that are not among the `written` ones, and folders that are empty then. The names of those
/// that are gone.
std::vector<std::string> remove_left_over(const std::filesystem::path& folder,
                                          const std::vector<std::string>& earlier,
                                          const std::vector<std::string>& written);

/// "Removed, of an earlier design: nested.dxf, parts/VA.dxf."
std::string removed_sentence(const std::vector<std::string>& names);

}  // namespace kempe
