#include "app/output_check.hpp"

#include <sys/stat.h>

#include <system_error>

namespace kempe::app {
namespace {

namespace fs = std::filesystem;

/// Where a path leads, asked of the system once.
class Place {
 public:
  explicit Place(const fs::path& path) : is_named_(!path.empty()) {
    std::error_code error;
    there_ = is_named_ && ::stat(path.c_str(), &status_) == 0;
    if (is_named_) canonical_ = fs::weakly_canonical(fs::absolute(path, error), error);
  }

  bool is_one_file_with(const Place& other) const {
    if (!is_named_ || !other.is_named_) return false;
    if (there_ && other.there_)
      return S_ISREG(status_.st_mode) && status_.st_dev == other.status_.st_dev &&
             status_.st_ino == other.status_.st_ino;
    return canonical_ == other.canonical_;
  }

 private:
  bool is_named_, there_ = false;
  struct stat status_ {};
  fs::path canonical_;
};

}  // namespace

std::optional<InputError> output_clash(const std::vector<fs::path>& inputs,
                                       const std::vector<fs::path>& outputs) {
  const std::vector<Place> ins(inputs.begin(), inputs.end()), outs(outputs.begin(), outputs.end());
  for (std::size_t i = 0; i < outs.size(); ++i) {
    for (std::size_t j = 0; j < ins.size(); ++j)
      if (ins[j].is_one_file_with(outs[i]))
        return InputError{outputs[i].string(), 0, "", "an output that is the input " + inputs[j].string(),
                          "another file"};
    for (std::size_t j = 0; j < i; ++j)
      if (outs[j].is_one_file_with(outs[i]))
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
