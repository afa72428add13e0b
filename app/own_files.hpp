#pragma once
// Files that are installed with the program, seen from where it is: an installation can be moved.

#include <filesystem>
#include <optional>
#include <string>

namespace kempe::app {

/// Where a file is: below `installed`, relative to the program's folder, or, of a program in the tree of its build, at `built`. Whether
/// it is there is the caller's to look. Nothing where the system does not tell where the program is.
struct OwnPlaces {
  std::filesystem::path installed;
  std::optional<std::filesystem::path> built;
};
std::optional<OwnPlaces> own_places(const char* installed, const char* built);

/// The command that checks a proof's log, without the log: "python3 /usr/share/kempe/proof/kempe_check.py"; in the tree of a build as it is
/// called from the project's folder.
std::string checker_command();

}  // namespace kempe::app
