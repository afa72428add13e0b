#include "app/own_files.hpp"

#include <system_error>

#include "specs/text/printable.hpp"

namespace kempe::app {
namespace {

namespace fs = std::filesystem;

/// From the project's folder.
constexpr const char* checker = "proof/kempe_check.py";

}  // namespace

std::optional<OwnPlaces> own_places(const char* installed, const char* built) {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  if (error) return std::nullopt;
  OwnPlaces places{(folder / installed).lexically_normal(), std::nullopt};
  // Only of a build's own tree: the same steps from elsewhere lead to folders that have nothing to do with Kempe.
  if (fs::exists(folder / ".." / "CMakeCache.txt", error)) places.built = (folder / built).lexically_normal();
  return places;
}

std::string checker_command() {
  std::error_code error;
  const auto places = own_places(KEMPE_INSTALLED_CHECKER, checker);
  const bool is_installed = places && !places->built && fs::exists(places->installed, error);
  return "python3 " + (is_installed ? printable(places->installed.string()) : std::string(checker));
}

}  // namespace kempe::app
