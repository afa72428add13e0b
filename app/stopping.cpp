#include "app/stopping.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace kempe::app {

std::string Stopping::reason() const {
  return interrupted() ? "interrupted" : fmt::format("time limit of {:.6g} s", deadline_.limit());
}

CLI::Option* add_time_limit(CLI::App& command, double& seconds, const std::string& description) {
  const auto is_time = [](const std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0) return {};
    return "a number of seconds above 0 is allowed, not " + text;
  };
  return command.add_option("--time-limit", seconds, description)->check(CLI::Validator(is_time, "SECONDS"));
}

int tell_stopped(const Session& session, const Stopping& stopping, const std::string& known,
                 const std::optional<double>& proven_bound) {
  const std::string sentence = fmt::format("stopped ({}) {}", stopping.reason(), known);
  if (session.json) {
    nlohmann::ordered_json object{
        {"error", "stopped"}, {"reason", stopping.reason()}, {"sentence", sentence}};
    object["lower_bound"] = proven_bound ? nlohmann::ordered_json(*proven_bound) : nlohmann::ordered_json();
    print(json_text(object));
  }
  return fail_told(stopping.code(), sentence);
}

}  // namespace kempe::app
