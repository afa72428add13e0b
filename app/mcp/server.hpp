#pragma once
// A server of the Model Context Protocol over stdin and stdout: JSON-RPC 2.0, a message a line.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/mcp/message_lines.hpp"
#include "app/mcp/tools.hpp"

namespace kempe::app {

/// Reads messages until there are no more, and answers each request. Calls of tools run one at a time, in the order in which they
/// came, each in a process of its own; meanwhile pings are answered, and a call may be cancelled. The working folder is the one that tools may use.
class Server {
 public:
  /// `seconds` and `threads`: at most so much for a call.
  Server(CLI::App& program, double seconds, int threads)
      : program_(program), seconds_(seconds), threads_(threads) {}

  /// Returns `done` at the end of stdin, `cannot_write` once stdout is closed.
  int run();

 private:
  using Json = nlohmann::ordered_json;

  /// The answer to a message, or nothing: to notifications, answers and cancelled calls.
  std::optional<Json> answer(const Message& message);
  std::optional<Json> answer_all(const Json& batch);
  std::optional<Json> answer_one(const Json& message);
  Json result_of(const Json& id, const std::string& method, const Json& params);
  Json initialize(const Json& id, const Json& params);
  std::optional<Json> call(const Json& id, const Json& params);
  std::optional<Json> watch(class ToolProcess process, const Json& id, const ToolRun& run);
  /// Answers pings among what waits; true if the call with this id is to be cancelled. Forgets waiting calls that are cancelled.
  bool look_through(const Json& id);
  void send(const Json& message);

  CLI::App& program_;
  double seconds_;
  int threads_;
  MessageLines lines_{0};
  std::string version_;  ///< of the protocol, once agreed
  bool can_write_ = true;
};

}  // namespace kempe::app
