#include "reports/data/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <system_error>
#include <thread>
#include <utility>

#include "kinematics/parallel.hpp"
#include "specs/text/printable.hpp"

namespace kempe {
namespace {

namespace fs = std::filesystem;

std::string cannot(const fs::path& path, int error) {
  return "cannot write " + printable(path.string()) + ": " + std::strerror(error);
}

/// 0 or errno.
int write_all(int file, std::string_view contents) {
  while (!contents.empty()) {
    const ssize_t written = ::write(file, contents.data(), contents.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    contents.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// An open file, closed with the object.
class OpenFile {
 public:
  explicit OpenFile(int number) : number_(number) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  /// 0 or errno.
  int close() {
    const int number = std::exchange(number_, -1);
    return ::close(number) == 0 ? 0 : errno;
  }

 private:
  int number_;
};

/// What a path leads to once its links are followed: a place, or a file that this process holds open.
struct Target {
  fs::path place;
  std::optional<int> open_file;
};

/// The number N of a path /proc/self/fd/N.
std::optional<int> open_file_named(const fs::path& path) {
  std::error_code error;
  const fs::path folder = fs::canonical(path.parent_path(), error),
                 own = fs::canonical("/proc/self/fd", error);
  const std::string name = path.filename().string();
  int number = -1;
  const auto [end, fault] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error || folder != own || fault != std::errc{} || end != name.data() + name.size()) return std::nullopt;
  return number;
}

/// Follows links one by one: the system's own way would lose the names of open files.
Target target_of(fs::path path) {
  constexpr int most_links = 40;
  std::error_code error;
  for (int links = 0; links < most_links; ++links) {
    if (const auto number = open_file_named(path)) return {path, number};
    const fs::path next =
        fs::is_symlink(fs::symlink_status(path, error)) ? fs::read_symlink(path, error) : fs::path();
    if (next.empty() || error) break;
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return {path, std::nullopt};
}

constexpr auto pause = std::chrono::milliseconds(50);
constexpr int most_pauses = 200;  ///< ten seconds, counted and not measured: clocks leap

/// Opens a device or a pipe to write to it. Nothing is made. The number, or minus errno.
int open_to_write_through(const fs::path& path, bool is_pipe) {
  for (int i = 0;; ++i) {
    const int file = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC | (is_pipe ? O_NONBLOCK : 0));
    if (file >= 0 || errno != ENXIO || i == most_pauses) return file >= 0 ? file : -errno;
    std::this_thread::sleep_for(pause);  // a pipe that nobody reads yet
  }
}

/// Writes to what cannot be replaced: an open file, a device, a pipe.
tl::expected<void, std::string> write_through(const fs::path& path, const Target& target,
                                              const struct stat& status, std::string_view contents) {
  const bool is_pipe = S_ISFIFO(status.st_mode);
  const int number = target.open_file ? ::fcntl(*target.open_file, F_DUPFD_CLOEXEC, 0)
                                      : open_to_write_through(target.place, is_pipe);
  if (number == -ENXIO)
    return tl::unexpected("cannot write " + printable(path.string()) + ": a pipe without a reader");
  OpenFile file(number);
  if (!file.is_open()) return tl::unexpected(cannot(path, target.open_file ? errno : -number));
  if (is_pipe && !target.open_file) ::fcntl(number, F_SETFL, O_WRONLY);
  const int error = write_all(file.number(), contents);
  if (error != 0) return tl::unexpected(cannot(path, error));
  if (const int closing = file.close(); closing != 0) return tl::unexpected(cannot(path, closing));
  return {};
}

/// A file under a name of its own beside its final place; removed unless put in place.
class Draft {
 public:
  explicit Draft(fs::path target) : asked_(std::move(target)), target_(target_of(asked_)) {}
  Draft(Draft&& other) noexcept
      : asked_(std::move(other.asked_)), target_(std::move(other.target_)), draft_(std::move(other.draft_)),
        file_(std::move(other.file_)), gathered_(std::move(other.gathered_)),
        is_complete_(other.is_complete_) {
    other.draft_.clear();
  }
  Draft& operator=(Draft&&) = delete;
  ~Draft() {
    if (!draft_.empty()) ::unlink(draft_.c_str());
  }

  /// What stands at the target and cannot be replaced by a file.
  std::optional<struct stat> fixed() const {
    struct stat status {};
    const bool there = target_.open_file ? ::fstat(*target_.open_file, &status) == 0
                                         : ::stat(target_.place.c_str(), &status) == 0;
    if (there && (target_.open_file || !S_ISREG(status.st_mode))) return status;
    return std::nullopt;
  }

  const Target& target() const { return target_; }

  tl::expected<void, std::string> begin() {
    if (const auto status = fixed()) return tl::unexpected(cannot_replace(*status));
    std::string pattern = (target_.place.parent_path() / "kempe-XXXXXX.tmp").string();
    file_ = std::make_unique<OpenFile>(::mkstemps(pattern.data(), 4));
    if (!file_->is_open()) return tl::unexpected(cannot(asked_, errno));
    draft_ = pattern;
    return {};
  }

  tl::expected<void, std::string> append(std::string_view piece) {
    constexpr std::size_t enough = 1 << 16;
    gathered_ += piece;
    if (gathered_.size() < enough) return {};
    return write_gathered();
  }

  /// True from complete() to synchronise().
  bool waits_for_the_disk() const { return file_ && is_complete_; }

  /// Writes what is gathered, and gives the file its mode: no piece is to come. To be followed by synchronise().
  tl::expected<void, std::string> complete() {
    if (!file_ || is_complete_) return {};
    is_complete_ = true;
    if (auto written = write_gathered(); !written) return written;
    if (const int error = take_mode(file_->number()); error != 0)
      return tl::unexpected(cannot(asked_, error));
    return {};
  }

  /// Brings the file to the disk, for a rename may otherwise survive a crash that the contents do not, and closes it; nothing happens if
  /// that was done. May run beside the same of other drafts.
  tl::expected<void, std::string> synchronise() {
    if (!file_) return {};
    int error = ::fsync(file_->number()) == 0 || errno == EINVAL ? 0 : errno;
    const int closing = file_->close();
    file_.reset();
    if (error == 0) error = closing;
    if (error != 0) return tl::unexpected(cannot(asked_, error));
    return {};
  }

  tl::expected<void, std::string> fill(std::string_view contents) {
    if (auto begun = begin(); !begun) return begun;
    if (const int error = write_all(file_->number(), contents); error != 0)
      return tl::unexpected(cannot(asked_, error));
    return complete();
  }

  const fs::path& place() const { return draft_; }

  tl::expected<void, std::string> put_in_place() {
    if (::rename(draft_.c_str(), target_.place.c_str()) != 0) return tl::unexpected(cannot(asked_, errno));
    draft_.clear();
    return {};
  }

 private:
  tl::expected<void, std::string> write_gathered() {
    const int error = write_all(file_->number(), gathered_);
    gathered_.clear();
    if (error != 0) return tl::unexpected(cannot(asked_, error));
    return {};
  }

  std::string cannot_replace(const struct stat& status) const {
    if (S_ISDIR(status.st_mode)) return cannot(asked_, EISDIR);
    return "cannot write " + printable(asked_.string()) + ": it is no regular file and is not replaced";
  }

  /// Mode and owner of the file that is replaced, or those of any new file. Of one draft after the other: the mask of modes is one for
  /// the whole process. 0 or errno.
  int take_mode(int file) const {
    struct stat old {};
    if (::stat(target_.place.c_str(), &old) == 0) {
      [[maybe_unused]] const int kept = ::fchown(file, old.st_uid, old.st_gid);  // only root gives files away
      return ::fchmod(file, old.st_mode & 07777) == 0 ? 0 : errno;
    }
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return ::fchmod(file, 0666 & ~mask) == 0 ? 0 : errno;
  }

  fs::path asked_;
  Target target_;
  fs::path draft_;
  std::unique_ptr<OpenFile> file_;  ///< until it is on the disk
  std::string gathered_;
  bool is_complete_ = false;
};

/// While it lives, no other run puts files into this folder: two runs into one folder leave the files of one of them.
/// A file system without locks only loses this.
class FolderTurn {
 public:
  explicit FolderTurn(const fs::path& folder)
      : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {}

  /// Waits for other runs; false where one keeps the folder for longer than any run puts files in place.
  bool take() const {
    if (!folder_.is_open()) return true;
    for (int i = 0; i < most_pauses; ++i) {
      if (::flock(folder_.number(), LOCK_EX | LOCK_NB) == 0 || (errno != EWOULDBLOCK && errno != EINTR))
        return true;
      std::this_thread::sleep_for(pause);
    }
    return false;
  }

 private:
  OpenFile folder_;
};

}  // namespace

tl::expected<void, std::string> write_whole(const fs::path& path, std::string_view contents) {
  Draft draft(path);
  if (const auto status = draft.fixed())
    if (draft.target().open_file || S_ISCHR(status->st_mode) || S_ISFIFO(status->st_mode))
      return write_through(path, draft.target(), *status, contents);
  return draft.fill(contents).and_then([&] { return draft.synchronise(); }).and_then([&] {
    return draft.put_in_place();
  });
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
    if (error)
      return tl::unexpected("cannot make the folder " + printable(wanted.string()) + ": " + error.message());
    made.insert(made.end(), missing.rbegin(), missing.rend());
    return {};
  }

  /// Brings the drafts that are complete to the disk: many at once, for each of them waits for the disk's next turn.
  tl::expected<void, std::string> synchronise() {
    constexpr int at_once = 16;  // they wait and take no core
    std::vector<Draft*> open;
    for (Draft& draft : drafts)
      if (draft.waits_for_the_disk()) open.push_back(&draft);
    std::vector<tl::expected<void, std::string>> synchronised(open.size());
    run_parallel(open.size(), at_once, [&](std::size_t i) { synchronised[i] = open[i]->synchronise(); });
    for (auto& one : synchronised)
      if (!one) return std::move(one);
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
  constexpr std::size_t most_open = 64;  // a process may hold few files open
  if (state_->names.size() % most_open == 0) return state_->synchronise();
  return {};
}

tl::expected<void, std::string> FolderDraft::begin(const fs::path& name) {
  const fs::path target = state_->folder / name;
  if (auto made = state_->make(target.parent_path()); !made) return made;
  if (auto begun = state_->drafts.emplace_back(target).begin(); !begun) return begun;
  state_->names.push_back(name.string());
  return {};
}

tl::expected<void, std::string> FolderDraft::append(const fs::path& name, std::string_view piece) {
  for (std::size_t i = 0; i < state_->names.size(); ++i)
    if (state_->names[i] == name.string()) return state_->drafts[i].append(piece);
  return tl::unexpected("cannot write " + printable((state_->folder / name).string()) + ": not begun");
}

tl::expected<void, std::string> FolderDraft::synchronise() { return state_->synchronise(); }

tl::expected<void, std::string> FolderDraft::put_in_place() {
  for (Draft& draft : state_->drafts)
    if (auto completed = draft.complete(); !completed) return completed;
  if (auto synchronised = state_->synchronise(); !synchronised) return synchronised;
  const FolderTurn turn(state_->folder);
  if (!turn.take())
    return tl::unexpected("cannot write " + printable(state_->folder.string()) +
                          ": another program keeps the folder locked");
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
