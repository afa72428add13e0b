#include "app/output_check.hpp"

#include <system_error>

namespace kempe::app {
namespace {

namespace fs = std::filesystem;

bool are_one_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (a.empty() || b.empty()) return false;
  if (fs::exists(a, error) && fs::exists(b, error))
    return fs::is_regular_file(a, error) && fs::equivalent(a, b, error) && !error;
  return fs::weakly_canonical(fs::absolute(a), error) == fs::weakly_canonical(fs::absolute(b), error);
}

}  // namespace

std::optional<InputError> output_clash(const std::vector<fs::path>& inputs,
                                       const std::vector<fs::path>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const fs::path& input : inputs)
      if (are_one_file(input, outputs[i]))
        return InputError{outputs[i].string(), 0, "", "an output that is the input " + input.string(),
                          "another file"};
    for (std::size_t j = 0; j < i; ++j)
      if (are_one_file(outputs[j], outputs[i]))
        return InputError{outputs[i].string(), 0, "", "two outputs in one file", "a file for each"};
  }
  return std::nullopt;
}

std::optional<InputError> output_clash(const std::vector<fs::path>& inputs, const fs::path& folder,
                                       const std::vector<std::string>& names) {
  std::vector<fs::path> outputs;
  for (const std::string& name : names) outputs.push_back(folder / name);
  return output_clash(inputs, outputs);
}

}  // namespace kempe::app
