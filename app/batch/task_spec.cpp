#include "app/batch/task_spec.hpp"

#include <utility>

#include "specs/json_spec.hpp"
#include "specs/spec_reader.hpp"
#include "specs/text/printable.hpp"

namespace kempe::app {

tl::expected<TaskSpec, InputError> task_spec(const BatchTask& task) {
  if (!task.text) return tl::unexpected(task.text.error());
  auto text = task.is_json ? toml_from_json(*task.text, task.name) : *task.text;
  auto spec = text.and_then([&](const std::string& toml) { return read_spec(toml, task.name, task.folder); });
  if (spec) return TaskSpec{std::move(*text), std::move(*spec)};
  // The lines of a text made from one line of JSON nobody sees.
  InputError error = std::move(spec.error());
  if (task.is_json && error.file == task.name) error.line = 0;
  return tl::unexpected(std::move(error));
}

tl::expected<LoadedSpec, InputError> spec_of_batch(const std::string& source, const std::string& name) {
  const auto opened = BatchSource::open(source);
  if (!opened) return tl::unexpected(opened.error());
  const auto task = (*opened)->named(name);
  if (!task)
    return tl::unexpected(InputError{source, 0, "--only", printable(name),
                                     "the name that the batch's results give a spec: its file's, line-N or "
                                     "cell-I-J-..."});
  auto read = task_spec(*task);
  if (!read) return tl::unexpected(std::move(read.error()));
  return LoadedSpec{task->file, std::move(read->text), std::move(read->spec)};
}

}  // namespace kempe::app
