#include "app/mcp/served_folder.hpp"

#include <algorithm>
#include <system_error>

#include "specs/text/printable.hpp"

namespace kempe::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_path = 1000;  // bytes

/// The path without "." and "..", or what is wrong with it. Each folder on the way is looked at before ".." leaves it again: a
/// link would lead elsewhere.
struct Walked {
  fs::path path;
  const char* wrong = nullptr;
};

Walked walk(const fs::path& path) {
  Walked walked;
  std::error_code error;
  for (const fs::path& step : path) {
    if (step.empty() || step == ".") continue;
    if (step == "..") {
      if (walked.path.empty()) return {{}, "a path that leaves the folder"};
      walked.path = walked.path.parent_path();
      continue;
    }
    walked.path /= step;
    if (fs::is_symlink(fs::symlink_status(walked.path, error))) return {{}, "a path with a link on it"};
  }
  return walked;
}

bool holds_links(const fs::path& folder) {
  std::error_code error;
  for (const fs::path& place : {folder, folder / "parts"})
    for (fs::directory_iterator entry(place, error), end; !error && entry != end; entry.increment(error))
      if (entry->is_symlink(error)) return true;
  return false;
}

const char* allowed_of(PathUse use) {
  switch (use) {
    case PathUse::input: return "a file below the served folder, by its path from there, without links";
    case PathUse::output_file:
      return "a file below the served folder, by its path from there, without links, ending in .svg or .csv";
    case PathUse::output_folder: break;
  }
  return "a folder below the served one, by its path from there, without links in it";
}

const char* wrong_with(const std::string& text, PathUse use) {
  if (text.empty()) return "an empty path";
  if (text.size() > longest_path) return "a path of more than 1000 bytes";
  if (text.find('\0') != std::string::npos) return "a path with a zero byte";
  const fs::path path(text);
  if (path.is_absolute()) return "an absolute path";
  const Walked walked = walk(path);
  if (walked.wrong != nullptr) return walked.wrong;
  if (walked.path.empty()) return "the served folder itself";
  std::error_code error;
  const fs::file_status status = fs::symlink_status(walked.path, error);
  if (use == PathUse::output_folder) {
    if (fs::exists(status) && !fs::is_directory(status)) return "a file";
    return holds_links(walked.path) ? "a folder that holds links" : nullptr;
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) return "something that is no file";
  const fs::path ending = path.extension();
  return use == PathUse::output_file && ending != ".svg" && ending != ".csv" ? "a file of another kind"
                                                                             : nullptr;
}

}  // namespace

std::optional<InputError> path_fault(const std::string& key, const std::string& path, PathUse use) {
  const char* wrong = wrong_with(path, use);
  if (wrong == nullptr) return std::nullopt;
  return InputError{"", 0, key, printable(path, 200) + ", " + wrong, allowed_of(use)};
}

std::optional<InputError> named_path_fault(const std::string& key, const std::string& naming_file,
                                           const fs::path& named) {
  if (named.is_absolute())  // joined to a folder it would take its place
    return InputError{naming_file, 0, key, printable(named.string(), 200) + ", an absolute path",
                      allowed_of(PathUse::input)};
  auto fault = path_fault(key, (fs::path(naming_file).parent_path() / named).string(), PathUse::input);
  if (fault) fault->file = naming_file;
  return fault;
}

}  // namespace kempe::app
