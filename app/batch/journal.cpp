#include "app/batch/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <condition_variable>
#include <cstring>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "specs/text/json_text.hpp"
#include "specs/text/printable.hpp"

namespace kempe::app {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> journals_of(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const bool regular = fs::is_regular_file(entry.symlink_status(error));
    if (regular && name.starts_with("journal-") && name.ends_with(".jsonl")) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Opens a journal to append to it, made if absent. The number, or an error sentence.
tl::expected<int, std::string> open_journal(const fs::path& path) {
  // A pipe nobody reads must not be waited for; a link leads to somebody else's file.
  const int file =
      ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  const int error = errno;
  if (file < 0)
    return tl::unexpected("cannot write " + printable(path.string()) + ": " +
                          (error == ELOOP ? "a link" : std::strerror(error)));
  struct stat status {};
  if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode)) return file;
  ::close(file);
  return tl::unexpected("cannot write " + printable(path.string()) + ": no regular file");
}

/// A journal that ends in the middle of a line gets a line end, so that the next record stands alone.
bool ends_whole(int file) {
  const off_t size = ::lseek(file, 0, SEEK_END);
  char last = '\n';
  return size <= 0 || (::pread(file, &last, 1, size - 1) == 1 && last == '\n');
}

/// Of the lines themselves: raised when what stands in them changes its meaning.
constexpr std::string_view format = "kempe-batch/3";

/// As a journal's line holds it.
std::string in_hexadecimal(std::uint64_t key) { return fmt::format("{:016x}", key); }

struct Record {
  std::string version, key, result;
};

std::string checksum(const Record& record) {
  const std::string version = record.version.empty() ? "" : record.version + "\n";  // the first had none
  return in_hexadecimal(text_key(version + record.key + "\n" + record.result));
}

/// A journal's line as it was recorded, by whichever version; nothing if it is anything else.
std::optional<Record> record_of(const std::string& line) {
  const auto sound = parse_json(line, "journal");
  if (!sound || !sound->is_object()) return std::nullopt;
  const auto text_at = [&](const char* name) {
    const auto found = sound->find(name);
    return found != sound->end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  Record record{text_at("version"), text_at("key"), text_at("result")};
  if (text_at("check") != checksum(record)) return std::nullopt;
  return record;
}

std::optional<std::uint64_t> key_in(const std::string& hexadecimal) {
  std::uint64_t key = 0;
  const char* const end = hexadecimal.data() + hexadecimal.size();
  const auto [stop, fault] = std::from_chars(hexadecimal.data(), end, key, 16);
  if (fault != std::errc{} || stop != end) return std::nullopt;
  return key;
}

/// The line that begins at a place of a file, without its end; nothing if it has none.
std::optional<std::string> line_at(int file, std::int64_t offset) {
  std::string line;
  for (std::array<char, 4096> part;;) {
    const ssize_t size = ::pread(file, part.data(), part.size(), offset + std::ssize(line));
    if (size <= 0) return std::nullopt;
    const std::string_view read(part.data(), static_cast<std::size_t>(size));
    const std::size_t end = read.find('\n');
    line += read.substr(0, end);
    if (end != std::string_view::npos) return line;
  }
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

/// A file to which lines are appended, and the thread that brings them to the disk.
class BatchJournal::Writer {
 public:
  explicit Writer(int file) : file_(file) {
    try {
      syncing_ = std::thread([this] { sync(); });
    } catch (const std::system_error&) {
      // The system gives no more threads: who writes synchronises.
    }
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  ~Writer() {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    more_.notify_one();
    if (syncing_.joinable()) syncing_.join();
    ::close(file_);
  }

  /// 0 or errno, also of an earlier line.
  int append(const std::string& line) {
    std::unique_lock lock(mutex_);
    if (error_ == 0 && !write_all(file_, line)) error_ = errno;
    ++written_;
    if (syncing_.joinable())
      more_.notify_one();
    else
      sync_once(lock);
    return error_;
  }

  /// Waits until all lines are on disk. 0 or errno.
  int flush() {
    std::unique_lock lock(mutex_);
    synced_more_.wait(lock, [this] { return synced_ == written_; });
    return error_;
  }

 private:
  void sync() {
    std::unique_lock lock(mutex_);
    for (;;) {
      more_.wait(lock, [this] { return synced_ < written_ || ending_; });
      if (synced_ == written_) return;
      sync_once(lock);
    }
  }

  /// Unlocked meanwhile, so that others write.
  void sync_once(std::unique_lock<std::mutex>& lock) {
    const std::int64_t all = written_;
    lock.unlock();
    const int error = ::fdatasync(file_) == 0 ? 0 : errno;
    lock.lock();
    if (error_ == 0) error_ = error;
    synced_ = std::max(synced_, all);
    synced_more_.notify_all();
  }

  const int file_;
  std::mutex mutex_;
  std::condition_variable more_, synced_more_;
  std::int64_t written_ = 0, synced_ = 0;  ///< lines
  int error_ = 0;
  bool ending_ = false;
  std::thread syncing_;  ///< last: it uses what stands above
};

BatchJournal::BatchJournal(fs::path folder, std::unique_ptr<Writer> writer, std::string version,
                           IsResult is_result)
    : folder_(std::move(folder)), writer_(std::move(writer)), version_(std::move(version)),
      is_result_(is_result) {}

tl::expected<BatchJournal, std::string> BatchJournal::open(const fs::path& folder, const std::string& name,
                                                           std::string_view program, IsResult is_result) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    return tl::unexpected("cannot make the folder " + printable(folder.string()) + ": " + error.message());
  const fs::path path = folder / ("journal-" + name + ".jsonl");
  const auto file = open_journal(path);
  if (!file) return tl::unexpected(file.error());
  BatchJournal journal(folder, std::make_unique<Writer>(*file), fmt::format("{} {}", format, program),
                       is_result);
  if (!ends_whole(*file) && !write_all(*file, "\n"))
    return tl::unexpected("cannot write " + printable(path.string()) + ": " + std::strerror(errno));
  return journal;
}

BatchJournal::BatchJournal(BatchJournal&& other) noexcept
    : folder_(std::move(other.folder_)), writer_(std::move(other.writer_)),
      version_(std::move(other.version_)), is_result_(other.is_result_),
      readings_(std::move(other.readings_)), opened_(std::exchange(other.opened_, {})),
      foreign_line_(std::move(other.foreign_line_)), first_passed_over_(std::move(other.first_passed_over_)),
      passed_over_(other.passed_over_) {}

BatchJournal::~BatchJournal() {
  for (const auto& [journal, file] : opened_) ::close(file);
}

// Reading

void BatchJournal::read_on(const Found& found) {
  for (const fs::path& path : journals_of(folder_)) {
    auto reading = std::find_if(readings_.begin(), readings_.end(),
                                [&](const Reading& one) { return one.path == path; });
    if (reading == readings_.end()) reading = readings_.insert(reading, Reading{path});
    read_on(static_cast<int>(reading - readings_.begin()), found);
  }
}

void BatchJournal::read_on(int journal, const Found& found) {
  Reading& reading = readings_[static_cast<std::size_t>(journal)];
  std::ifstream stream(reading.path, std::ios::binary);
  stream.seekg(reading.offset);
  for (std::string line; std::getline(stream, line);) {
    ++reading.line;
    if (!line.empty()) judge(line, reading, journal, found);
    if (stream.eof())
      --reading.line;  // somebody may be writing it
    else
      reading.offset += std::ssize(line) + 1;
  }
}

void BatchJournal::judge(const std::string& line, const Reading& at, int journal, const Found& found) {
  const auto record = record_of(line);
  if (record && record->version != version_) {
    if (!foreign_line_)
      foreign_line_ =
          InputError{at.path.string(), at.line, "version",
                     record->version.empty() ? "none, as older versions wrote" : record->version,
                     version_ + "; give another folder to -o, or remove the journals in this one"};
    return;
  }
  const auto key = record && is_result_(record->result) ? key_in(record->key) : std::nullopt;
  if (key) return found(*key, {journal, at.offset});
  if (passed_over_++ == 0) first_passed_over_ = fmt::format("{}:{}", at.path.string(), at.line);
}

/// A journal opened for reading; of thousands of ranks' journals not all can be open at once.
int BatchJournal::opened(int journal) {
  constexpr std::size_t most_open = 64;
  if (const auto found = opened_.find(journal); found != opened_.end()) return found->second;
  if (opened_.size() >= most_open) {
    for (const auto& [other, file] : opened_) ::close(file);
    opened_.clear();
  }
  const fs::path& path = readings_[static_cast<std::size_t>(journal)].path;
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file >= 0) opened_[journal] = file;
  return file;
}

std::optional<std::string> BatchJournal::result_at(const JournalPlace& place, std::uint64_t key) {
  const int file = opened(place.journal);
  const auto line = file >= 0 ? line_at(file, place.offset) : std::nullopt;
  auto record = line ? record_of(*line) : std::nullopt;
  if (!record || record->key != in_hexadecimal(key) || record->version != version_) return std::nullopt;
  return std::move(record->result);
}

// Writing

std::string BatchJournal::failure(int error) const {
  return "cannot write the journal in " + printable(folder_.string()) + ": " + std::strerror(error);
}

tl::expected<void, std::string> BatchJournal::record(std::uint64_t key, const std::string& result) {
  const std::string name = in_hexadecimal(key);
  const nlohmann::ordered_json line{{"version", version_},
                                    {"key", name},
                                    {"result", result},
                                    {"check", checksum({version_, name, result})}};
  if (const int error = writer_->append(line.dump() + "\n"); error != 0)
    return tl::unexpected(failure(error));
  return {};
}

tl::expected<void, std::string> BatchJournal::flush() {
  if (const int error = writer_->flush(); error != 0) return tl::unexpected(failure(error));
  return {};
}

std::uint64_t text_key(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

}  // namespace kempe::app
