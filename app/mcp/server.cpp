#include "app/mcp/server.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "app/mcp/rpc_codes.hpp"
#include "app/mcp/tool_process.hpp"
#include "app/program.hpp"
#include "specs/text/printable.hpp"
#include "synthesis/design/assemble.hpp"

namespace kempe::app {
namespace {

using Json = nlohmann::ordered_json;

/// Versions of the protocol, the newest first. Of these only one has batches.
constexpr std::array<std::string_view, 4> versions{"2025-11-25", "2025-06-18", "2025-03-26", "2024-11-05"};
constexpr std::string_view version_with_batches = "2025-03-26";

constexpr const char* instructions =
    "Kempe designs copying linkages (pantographs and plagiographs) and proves what it says. Lengths in mm, "
    "angles in degrees, places "
    "[x, y] on the table. Paths are relative to the served folder. Begin with design; where no design "
    "exists, its answer names the "
    "least change of each limit that is enough. Call only that proven which an answer calls proven.";

constexpr std::size_t longest_text = 16u << 10;     // bytes of an answer's text
constexpr std::size_t longest_object = 256u << 10;  // and of its object

Json rpc_error(const Json& id, int code, std::string message) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", std::move(message)}}}};
}

Json rpc_result(const Json& id, Json result) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}};
}

bool is_id(const Json& value) { return value.is_string() || value.is_number_integer(); }

std::string method_of(const Json& message) {
  if (!message.is_object()) return "";
  const auto method = message.find("method");
  return method != message.end() && method->is_string() ? method->get<std::string>() : "";
}

/// The lines without the program's name in front, whole up to the limit.
std::string told_text(const std::string& all, bool cut) {
  constexpr std::string_view name = "kempe: ";
  std::string text;
  for (std::size_t from = 0; from < all.size();) {
    const std::size_t end = std::min(all.find('\n', from), all.size());
    std::string_view line = std::string_view(all).substr(from, end - from);
    if (line.starts_with(name)) line.remove_prefix(name.size());
    text.append(line).append("\n");
    from = end + 1;
  }
  if (!text.empty()) text.pop_back();
  if (text.size() <= longest_text && !cut) return text;
  text.resize(std::min(text.size(), longest_text));
  return printable_lines(text) + "\n(cut: the answer is longer)";
}

Json tool_result(std::string text, Json object, bool is_error) {
  Json result{{"content", {{{"type", "text"}, {"text", std::move(text)}}}}};
  if (object.is_object()) result["structuredContent"] = std::move(object);
  result["isError"] = is_error;
  return result;
}

Json faults_result(const InputError& fault) {
  Json object = Json::parse(faults_json(fault), nullptr, false);
  object["exit_code"] = static_cast<int>(bad_input);
  return tool_result(fault.messages(), std::move(object), true);
}

/// A call that ended without an answer.
Json broken_off(ExitCode code, const std::string& sentence) {
  return tool_result(
      sentence, {{"error", "stopped"}, {"sentence", sentence}, {"exit_code", static_cast<int>(code)}}, true);
}

/// Whether a command with this exit code has answered: that no design exists is an answer too.
bool has_answered(const Tool& tool, int code) {
  return code == done || code == no_design || code == stopped ||
         (code == verification_failed && tool.four_is_answer);
}

Json result_of_output(const ToolOutput& output, const ToolRun& run) {
  if (output.late && (output.signal != 0 || output.object.empty()))
    return broken_off(stopped, fmt::format("stopped (time limit of {:.6g} s) before an answer", run.limit));
  if (output.signal != 0)
    return broken_off(failed, fmt::format("ended by signal {} before an answer", output.signal));
  Json object = Json::parse(output.object, nullptr, false);
  std::string text = told_text(output.text, output.text_cut);
  if (object.is_object()) {
    object["exit_code"] = output.code;
    if (text.empty()) text = object.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (output.object.size() > longest_object) object = nullptr;
  }
  return tool_result(std::move(text), std::move(object), !has_answered(*run.tool, output.code));
}

/// In the process of its own.
int run_tool(const ToolRun& run) {
  Session session;
  session.json = session.both = true;
  session.given = run.given;
  if (const auto fault = files_fault(run)) return fail(session, *fault);
  return run_program(run.words, session);
}

}  // namespace

int Server::run() {
  while (can_write_) {
    if (!lines_.waiting().empty()) {
      const Message message = std::move(lines_.waiting().front());
      lines_.waiting().pop_front();
      if (const auto reply = answer(message)) send(*reply);
    } else if (lines_.ended()) {
      return done;
    } else {
      lines_.read_some();
    }
  }
  return cannot_write;
}

std::optional<Json> Server::answer(const Message& message) {
  if (message.error_code != 0) return rpc_error(nullptr, message.error_code, message.error);
  return message.value.is_array() ? answer_all(message.value) : answer_one(message.value);
}

std::optional<Json> Server::answer_all(const Json& batch) {
  if (version_ != version_with_batches)
    return rpc_error(nullptr, RpcCode::invalid_request, "found a list; allowed: one message a line");
  if (batch.empty())
    return rpc_error(nullptr, RpcCode::invalid_request, "found an empty list; allowed: messages");
  Json replies = Json::array();
  for (const Json& message : batch)
    if (auto reply = answer_one(message)) replies.push_back(std::move(*reply));
  return replies.empty() ? std::nullopt : std::optional(std::move(replies));
}

std::optional<Json> Server::answer_one(const Json& message) {
  const auto refuse = [](const Json& id, const std::string& found, const char* allowed) {
    return rpc_error(id, RpcCode::invalid_request, "found " + found + "; allowed: " + allowed);
  };
  if (!message.is_object()) return refuse(nullptr, "no object", "a message of JSON-RPC 2.0");
  const bool is_request = message.contains("id");
  const Json id = is_request && is_id(message["id"]) ? message["id"] : Json(nullptr);
  if (is_request && id.is_null()) return refuse(id, "an id of another kind", "a text or a whole number");
  const auto version = message.find("jsonrpc");
  if (version == message.end() || *version != "2.0")
    return refuse(id, "another version", "\"jsonrpc\": \"2.0\"");
  if (!message.contains("method")) {
    if (message.contains("result") || message.contains("error")) return std::nullopt;  // nothing was asked
    return refuse(id, "no method", "a request or a notification");
  }
  if (!message["method"].is_string()) return refuse(id, "a method that is no text", "a method's name");
  if (!is_request) return std::nullopt;  // a notification: there is nothing to do
  const std::string method = method_of(message);
  const Json params = message.value("params", Json::object());
  if (!params.is_object())
    return rpc_error(id, RpcCode::invalid_params, "found params of another kind; allowed: an object");
  if (method == "tools/call" && !version_.empty()) return call(id, params);
  return result_of(id, method, params);
}

Json Server::result_of(const Json& id, const std::string& method, const Json& params) {
  if (method == "ping") return rpc_result(id, Json::object());
  if (method == "initialize") return initialize(id, params);
  if (version_.empty())
    return rpc_error(id, RpcCode::invalid_request,
                     "found " + printable(method, 60) + " first; allowed: initialize, and ping at any time");
  if (method != "tools/list")
    return rpc_error(
        id, RpcCode::method_not_found,
        "found " + printable(method, 60) + "; allowed: initialize, ping, tools/list, tools/call");
  if (params.contains("cursor"))
    return rpc_error(id, RpcCode::invalid_params, "found a cursor; allowed: none, the list has one page");
  return rpc_result(id, {{"tools", tool_list(program_)}});
}

Json Server::initialize(const Json& id, const Json& params) {
  const auto wish = params.find("protocolVersion");
  if (!version_.empty())
    return rpc_error(id, RpcCode::invalid_request, "found initialize again; allowed: once");
  if (wish == params.end() || !wish->is_string())
    return rpc_error(id, RpcCode::invalid_params,
                     "found no protocolVersion; allowed: a text such as " + std::string(versions.front()));
  const std::string wanted = wish->get<std::string>();
  const bool known = std::find(versions.begin(), versions.end(), wanted) != versions.end();
  version_ = known ? wanted : std::string(versions.front());
  return rpc_result(id, {{"protocolVersion", version_},
                         {"capabilities", {{"tools", {{"listChanged", false}}}}},
                         {"serverInfo", {{"name", "kempe"}, {"title", "Kempe"}, {"version", KEMPE_VERSION}}},
                         {"instructions", instructions}});
}

std::optional<Json> Server::call(const Json& id, const Json& params) {
  const auto name = params.find("name");
  if (name == params.end() || !name->is_string())
    return rpc_error(id, RpcCode::invalid_params, "found no name; allowed: a tool's name");
  const Tool* tool = find_tool(name->get_ref<const std::string&>());
  if (tool == nullptr)
    return rpc_error(id, RpcCode::invalid_params,
                     "Unknown tool: " + printable(name->get_ref<const std::string&>(), 60));
  const Json arguments = params.value("arguments", Json::object());
  if (!arguments.is_object())
    return rpc_error(id, RpcCode::invalid_params, "found arguments of another kind; allowed: an object");
  const auto run = tool_run(program_, *tool, arguments, seconds_, threads_);
  if (!run) return rpc_result(id, faults_result(run.error()));
  // A command with --time-limit has some time more to write what it found; the others are ended.
  const double end = tool->takes_limit ? run->limit + grace_after(run->limit) + 1 : run->limit;
  auto process = ToolProcess::start([&] { return run_tool(*run); }, end);
  if (!process) return rpc_error(id, RpcCode::internal_error, process.error());
  return watch(std::move(*process), id, *run);
}

std::optional<Json> Server::watch(ToolProcess process, const Json& id, const ToolRun& run) {
  bool cancelled = false;
  const auto look = [&] {
    if (!look_through(id) || cancelled) return;
    cancelled = true;
    process.stop();
  };
  look();  // what came in together with the call
  while (process.runs()) {
    std::array<pollfd, 3> waiting{process.output(), process.errors(),
                                  pollfd{lines_.wants_more() ? STDIN_FILENO : -1, POLLIN, 0}};
    const int ready = ::poll(waiting.data(), waiting.size(), process.patience());
    if (ready > 0 && waiting[2].revents != 0) {
      lines_.read_some();
      look();
      if (!can_write_) return std::nullopt;  // and ends the process
    }
    process.read();
  }
  const ToolOutput output = process.finish();
  if (cancelled) return std::nullopt;
  return rpc_result(id, result_of_output(output, run));
}

bool Server::look_through(const Json& id) {
  auto& waiting = lines_.waiting();
  bool cancel = false;
  for (std::size_t i = 0; i < waiting.size();) {
    const Json& message = waiting[i].value;
    const std::string method = method_of(message);
    const auto take_out = [&](std::size_t at) {
      waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(at));
    };
    if (method == "ping" && message.contains("id")) {
      if (const auto reply = answer_one(message)) send(*reply);
      take_out(i);
      continue;
    }
    if (method != "notifications/cancelled" || message.contains("id")) {
      ++i;
      continue;
    }
    const Json params = message.value("params", Json());
    const Json which = params.is_object() ? params.value("requestId", Json()) : Json();
    take_out(i);
    if (!is_id(which)) continue;
    cancel = cancel || which == id;
    for (std::size_t k = 0; k < i; ++k)
      if (method_of(waiting[k].value) == "tools/call" && waiting[k].value.value("id", Json()) == which) {
        take_out(k);
        --i;
        break;
      }
  }
  return cancel;
}

void Server::send(const Json& message) {
  const std::string text = message.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  for (std::size_t sent = 0; can_write_ && sent < text.size();) {
    const ssize_t count = ::write(STDOUT_FILENO, text.data() + sent, text.size() - sent);
    if (count >= 0)
      sent += static_cast<std::size_t>(count);
    else if (errno != EINTR)
      can_write_ = false;
  }
}

}  // namespace kempe::app
