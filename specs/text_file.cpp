#include "specs/text_file.hpp"

#include <fstream>
#include <system_error>

namespace kempe {

tl::expected<std::string, InputError> read_text_file(const std::filesystem::path& path) {
  const auto refuse = [&](const char* found, const std::string& allowed) {
    return tl::unexpected(InputError{path.string(), 0, "", found, allowed});
  };
  std::error_code failure;
  const auto status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status)) return refuse("no such file", "a file that can be read");
  if (std::filesystem::is_directory(status)) return refuse("a folder", "a file that can be read");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return refuse("a file that cannot be opened", "a file that can be read");

  // In pieces, since a pipe has no length and a device no end.
  std::string contents, piece(1u << 20, '\0');
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0) {
    contents.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
    if (contents.size() > largest_input_file) {
      return refuse("a larger file", std::to_string(largest_input_file >> 20) + " megabytes at most");
    }
  }
  if (stream.bad()) return refuse("a file that breaks off while it is read", "a file that can be read");
  return contents;
}

}  // namespace kempe
