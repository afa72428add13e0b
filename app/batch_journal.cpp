#include "app/batch_journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

namespace kempe::app {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> journals_of(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("journal-") && name.ends_with(".jsonl")) found.push_back(entry.path());
  }
  return found;
}

/// A journal that ends in the middle of a line gets a line end, so that the next record stands alone.
bool ends_whole(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream || stream.tellg() == 0) return true;
  stream.seekg(-1, std::ios::end);
  return stream.get() == '\n';
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

tl::expected<BatchJournal, std::string> BatchJournal::open(const fs::path& folder, const std::string& name) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return tl::unexpected("cannot make the folder " + folder.string() + ": " + error.message());
  const fs::path path = folder / ("journal-" + name + ".jsonl");
  const bool whole = ends_whole(path);
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) return tl::unexpected("cannot write " + path.string() + ": " + std::strerror(errno));
  BatchJournal journal(folder, file);
  if (!whole && !write_all(file, "\n"))
    return tl::unexpected("cannot write " + path.string() + ": " + std::strerror(errno));
  journal.read_all();
  return journal;
}

BatchJournal::BatchJournal(BatchJournal&& other) noexcept
    : folder_(std::move(other.folder_)), file_(other.file_), results_(std::move(other.results_)) {
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
  const nlohmann::ordered_json line{{"key", key}, {"result", result}};
  const std::lock_guard lock(mutex_);
  if (!write_all(file_, line.dump() + "\n") || ::fdatasync(file_) != 0)
    return tl::unexpected("cannot write the journal in " + folder_.string() + ": " + std::strerror(errno));
  results_[key] = result;
  return {};
}

void BatchJournal::read_all() {
  for (const fs::path& path : journals_of(folder_)) {
    std::ifstream stream(path, std::ios::binary);
    for (std::string line; std::getline(stream, line);) {
      const auto object = nlohmann::json::parse(line, nullptr, false);
      if (!object.is_object() || !object.contains("key") || !object.contains("result")) continue;
      if (!object["key"].is_string() || !object["result"].is_string()) continue;
      results_[object["key"].get<std::string>()] = object["result"].get<std::string>();
    }
  }
}

std::string text_key(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return fmt::format("{:016x}", hash);
}

}  // namespace kempe::app
