#pragma once
// Messages as they come in: a line of JSON each.

#include <deque>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace kempe::app {

/// Longer messages are refused, bytes.
inline constexpr std::size_t largest_message = 1u << 20;

/// A line that came in: JSON, or what is wrong with it.
struct Message {
  nlohmann::ordered_json value;
  int error_code = 0;  ///< of JSON-RPC; 0: the line is JSON
  std::string error;
};

class MessageLines {
 public:
  explicit MessageLines(int file) : file_(file) {}

  /// False where no more is to be read now: enough messages wait, or there are no more.
  bool wants_more() const { return !ended_ && waiting_.size() < most_waiting; }
  bool ended() const { return ended_; }
  /// Reads once; waits if there is nothing.
  void read_some();
  /// What waits, the oldest first.
  std::deque<Message>& waiting() { return waiting_; }

 private:
  static constexpr std::size_t most_waiting = 64;
  void end_line();

  int file_;
  bool ended_ = false, too_long_ = false;
  std::string line_;
  std::deque<Message> waiting_;
};

}  // namespace kempe::app
