#pragma once
// What an earlier design or front left in a folder: its parts must not be taken for those of what is written there now.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace kempe {

/// The folder of a front's point, by its index from 0: "01", "02", ...
std::string point_folder(std::size_t index);

/// The files of a design or a front that lie in a folder, by the names that they have (design_package.hpp, certificate.hpp, front_folder.hpp);
/// none where there is neither a design.json nor a front.csv. The studio's page is not among them: it is a tool, whatever spec it holds.
std::vector<std::string> design_files_in(const std::filesystem::path& folder);

/// Removes those of the `earlier` files that are not among the `written` ones, and folders that are empty then. The names of those
/// that are gone.
std::vector<std::string> remove_left_over(const std::filesystem::path& folder,
                                          const std::vector<std::string>& earlier,
                                          const std::vector<std::string>& written);

/// "Removed, left by an earlier design: nested.dxf, parts/VA.dxf, 3 files of 04/." Of a front's points the files are counted.
std::string removed_sentence(const std::vector<std::string>& names);

}  // namespace kempe
