#include "app/mcp/message_lines.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "app/mcp/rpc_codes.hpp"
#include "specs/text/json_text.hpp"

namespace kempe::app {
namespace {

Message message_of(const std::string& line) {
  // The reader of files from outside, which refuses deep nesting and keys that stand twice.
  if (const auto sound = parse_json(line, ""); !sound)
    return {nullptr, RpcCode::parse_error,
            "found " + sound.error().found + "; allowed: " + sound.error().allowed};
  return {nlohmann::ordered_json::parse(line, nullptr, false), 0, ""};
}

}  // namespace

void MessageLines::read_some() {
  char piece[1u << 16];
  const ssize_t count = ::read(file_, piece, sizeof piece);
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (count <= 0) {
    ended_ = true;
    return end_line();
  }
  const char *from = piece, *const end = piece + count;
  while (from != end) {
    const char* const line_end = std::find(from, end, '\n');
    line_.append(from, line_end);
    if (line_.size() > largest_message) {
      too_long_ = true;
      line_.clear();
    }
    if (line_end == end) break;
    end_line();
    from = line_end + 1;
  }
}

void MessageLines::end_line() {
  const std::string line = std::move(line_);
  line_.clear();
  if (too_long_)
    waiting_.push_back(
        {nullptr, RpcCode::invalid_request, "found a longer message; allowed: 1 megabyte at most"});
  else if (line.find_first_not_of(" \t\r") != std::string::npos)
    waiting_.push_back(message_of(line));
  too_long_ = false;
}

}  // namespace kempe::app
