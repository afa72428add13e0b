#include "reports/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace kempe {
namespace {

namespace fs = std::filesystem;

std::string cannot(const fs::path& path, int error) {
  return "cannot write " + path.string() + ": " + std::strerror(error);
}

/// A file under a name of its own beside its final place; removed unless put in place.
class Draft {
 public:
  explicit Draft(fs::path target) : target_(std::move(target)) {}
  Draft(Draft&& other) noexcept : target_(std::move(other.target_)), draft_(std::move(other.draft_)) {
    other.draft_.clear();
  }
  Draft& operator=(Draft&&) = delete;
  ~Draft() {
    if (!draft_.empty()) ::unlink(draft_.c_str());
  }

  tl::expected<void, std::string> fill(std::string_view contents) {
    std::string pattern = target_.string() + ".XXXXXX.tmp";
    const int file = ::mkstemps(pattern.data(), 4);
    if (file < 0) return tl::unexpected(cannot(target_, errno));
    draft_ = pattern;
    const int error = write_all(file, contents);
    if (::close(file) != 0 && error == 0) return tl::unexpected(cannot(target_, errno));
    if (error != 0) return tl::unexpected(cannot(target_, error));
    return {};
  }

  const fs::path& place() const { return draft_; }

  tl::expected<void, std::string> put_in_place() {
    if (::rename(draft_.c_str(), target_.c_str()) != 0) return tl::unexpected(cannot(target_, errno));
    draft_.clear();
    return {};
  }

 private:
  /// 0 or errno. Synchronised to disk: a rename may otherwise survive a crash that the contents do not.
  static int write_all(int file, std::string_view contents) {
    while (!contents.empty()) {
      const ssize_t written = ::write(file, contents.data(), contents.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return errno;
      contents.remove_prefix(static_cast<std::size_t>(written));
    }
    // mkstemp makes files private; an output is an ordinary file.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    if (::fchmod(file, 0666 & ~mask) != 0) return errno;
    return ::fsync(file) == 0 || errno == EINVAL ? 0 : errno;
  }

  fs::path target_;
  fs::path draft_;
};

/// While it lives, no other run puts files into this folder: two runs into one folder leave the files of one of them.
/// A file system without locks only loses this.
class FolderTurn {
 public:
  explicit FolderTurn(const fs::path& folder)
      : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (folder_ < 0) return;
    while (::flock(folder_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  FolderTurn(const FolderTurn&) = delete;
  FolderTurn& operator=(const FolderTurn&) = delete;
  ~FolderTurn() {
    if (folder_ >= 0) ::close(folder_);
  }

 private:
  int folder_;
};

}  // namespace

tl::expected<void, std::string> write_whole(const fs::path& path, std::string_view contents) {
  Draft draft(path);
  return draft.fill(contents).and_then([&] { return draft.put_in_place(); });
}

struct FolderDraft::State {
  fs::path folder;
  std::vector<std::string> names;
  std::vector<Draft> drafts;
  std::vector<fs::path> made;  ///< folders, outer ones first

  /// Makes a folder and those around it.
  tl::expected<void, std::string> make(const fs::path& wanted) {
    std::error_code error;
    std::vector<fs::path> missing;
    for (fs::path one = wanted; !one.empty() && !fs::exists(one, error); one = one.parent_path())
      missing.push_back(one);
    fs::create_directories(wanted, error);
    if (error) return tl::unexpected("cannot make the folder " + wanted.string() + ": " + error.message());
    made.insert(made.end(), missing.rbegin(), missing.rend());
    return {};
  }
};

FolderDraft::FolderDraft(fs::path folder) : state_(std::make_unique<State>()) {
  state_->folder = std::move(folder);
}

FolderDraft::FolderDraft(FolderDraft&&) noexcept = default;

FolderDraft::~FolderDraft() {
  if (!state_) return;
  state_->drafts.clear();
  std::error_code ignored;  // a folder that holds something stays
  for (auto one = state_->made.rbegin(); one != state_->made.rend(); ++one) fs::remove(*one, ignored);
}

tl::expected<void, std::string> FolderDraft::add(const OutputFile& file) {
  const fs::path target = state_->folder / file.name;
  if (auto made = state_->make(target.parent_path()); !made) return made;
  if (auto filled = state_->drafts.emplace_back(target).fill(file.contents); !filled) return filled;
  state_->names.push_back(file.name.string());
  return {};
}

tl::expected<void, std::string> FolderDraft::put_in_place() {
  const FolderTurn turn(state_->folder);
  for (Draft& draft : state_->drafts)
    if (auto placed = draft.put_in_place(); !placed) return placed;
  state_->drafts.clear();
  state_->made.clear();
  return {};
}

std::vector<std::string> FolderDraft::names() const { return state_->names; }

std::optional<fs::path> FolderDraft::draft_of(const std::string& name) const {
  for (std::size_t i = 0; i < state_->names.size(); ++i)
    if (state_->names[i] == name && i < state_->drafts.size()) return state_->drafts[i].place();
  return std::nullopt;
}

tl::expected<void, std::string> write_whole(const fs::path& folder, const std::vector<OutputFile>& files) {
  FolderDraft draft(folder);
  for (const OutputFile& file : files)
    if (auto added = draft.add(file); !added) return added;
  return draft.put_in_place();
}

}  // namespace kempe
