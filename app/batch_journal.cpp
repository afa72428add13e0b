#include "app/batch_journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
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
constexpr std::string_view format = "kempe-batch/2";

struct Record {
  std::string version, key, result;
};

std::string checksum(const Record& record) {
  const std::string version = record.version.empty() ? "" : record.version + "\n";  // the first had none
  return text_key(version + record.key + "\n" + record.result);
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

tl::expected<BatchJournal, std::string> BatchJournal::open(const fs::path& folder, const std::string& name,
                                                           std::string_view program, IsResult is_result) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    return tl::unexpected("cannot make the folder " + printable(folder.string()) + ": " + error.message());
  const fs::path path = folder / ("journal-" + name + ".jsonl");
  const auto file = open_journal(path);
  if (!file) return tl::unexpected(file.error());
  BatchJournal journal(folder, *file, fmt::format("{} {}", format, program), is_result);
  if (!ends_whole(*file) && !write_all(*file, "\n"))
    return tl::unexpected("cannot write " + printable(path.string()) + ": " + std::strerror(errno));
  journal.read_all();
  return journal;
}

BatchJournal::BatchJournal(BatchJournal&& other) noexcept
    : folder_(std::move(other.folder_)), file_(other.file_), version_(std::move(other.version_)),
      is_result_(other.is_result_), foreign_line_(std::move(other.foreign_line_)),
      passed_over_(std::move(other.passed_over_)), results_(std::move(other.results_)) {
  other.file_ = -1;
}

BatchJournal::~BatchJournal() {
  if (file_ >= 0) ::close(file_);
}

const std::string* BatchJournal::result(const std::string& key) const {
  const auto found = results_.find(key);
  return found == results_.end() ? nullptr : &found->second;
}

tl::expected<void, std::string> BatchJournal::record(const std::string& key, const std::string& result) {
  const nlohmann::ordered_json line{
      {"version", version_}, {"key", key}, {"result", result}, {"check", checksum({version_, key, result})}};
  const std::lock_guard lock(mutex_);
  if (!write_all(file_, line.dump() + "\n") || ::fdatasync(file_) != 0)
    return tl::unexpected("cannot write the journal in " + printable(folder_.string()) + ": " +
                          std::strerror(errno));
  results_[key] = result;
  return {};
}

void BatchJournal::read_all() {
  passed_over_.clear();
  foreign_line_.reset();
  for (const fs::path& path : journals_of(folder_)) {
    std::ifstream stream(path, std::ios::binary);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      if (!line.empty()) read_line(line, path.string(), number);
    }
  }
}

void BatchJournal::read_line(const std::string& line, const std::string& file, int number) {
  const auto record = record_of(line);
  if (record && record->version != version_) {
    if (!foreign_line_)
      foreign_line_ =
          InputError{file, number, "version",
                     record->version.empty() ? "none, as older versions wrote" : record->version,
                     version_ + "; give another folder to -o, or remove the journals in this one"};
  } else if (record && is_result_(record->result)) {
    results_[record->key] = record->result;
  } else {
    passed_over_.push_back(fmt::format("{}:{}", file, number));
  }
}

std::string text_key(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return fmt::format("{:016x}", hash);
}

}  // namespace kempe::app
