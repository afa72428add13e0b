#include "specs/text/text_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace kempe {
namespace {

/// How long a named pipe may bring nothing, ms.
constexpr int longest_silence = 10'000;

/// A file open for reading, closed with the object. A pipe without a writer is opened all the same.
class InputFile {
 public:
  explicit InputFile(const std::filesystem::path& path)
      : number_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {
    // One that has a name in a folder: of pipes that a shell made, the writer is there.
    struct stat status {};
    is_named_pipe_ = ::lstat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile() {
    if (number_ >= 0) ::close(number_);
  }

  bool is_open() const { return number_ >= 0; }

  enum class End { none, whole, broken, silent };
  /// Adds what comes next, at most as much as `piece` holds.
  End read_on(std::string& piece, std::string& contents) const {
    for (;;) {
      pollfd waiting{number_, POLLIN, 0};
      const int ready = ::poll(&waiting, 1, is_named_pipe_ ? longest_silence : -1);
      if (ready == 0) return End::silent;
      const ssize_t count = ready < 0 ? ready : ::read(number_, piece.data(), piece.size());
      if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
      if (count < 0) return End::broken;
      contents.append(piece, 0, static_cast<std::size_t>(count));
      return count == 0 ? End::whole : End::none;
    }
  }

 private:
  int number_;
  bool is_named_pipe_ = false;
};

}  // namespace

tl::expected<std::string, InputError> read_text_file(const std::filesystem::path& path) {
  const auto refuse = [&](const char* found, const std::string& allowed) {
    return tl::unexpected(InputError{path.string(), 0, "", found, allowed});
  };
  std::error_code failure;
  const auto status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status)) return refuse("no such file", "a file that can be read");
  if (std::filesystem::is_directory(status)) return refuse("a folder", "a file that can be read");
  const InputFile file(path);
  if (!file.is_open()) return refuse("a file that cannot be opened", "a file that can be read");

  // In pieces, since a pipe has no length and a device no end.
  using End = InputFile::End;
  std::string contents, piece(1u << 20, '\0');
  End end = End::none;
  while (end == End::none) {
    end = file.read_on(piece, contents);
    if (contents.size() > largest_input_file)
      return refuse("a larger file", std::to_string(largest_input_file >> 20) + " megabytes at most");
  }
  if (end == End::silent) return refuse("a pipe without data", "a file, or a pipe somebody writes to");
  if (end == End::broken)
    return refuse("a file that could not be read to its end", "a file that can be read");
  return contents;
}

}  // namespace kempe
