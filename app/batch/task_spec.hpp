#pragma once
// The spec of one task of a batch, read.

#include <string>
#include <tl/expected.hpp>

#include "app/batch/source.hpp"
#include "app/design_run.hpp"
#include "specs/spec.hpp"

namespace kempe::app {

/// A task's spec, and its text as TOML.
struct TaskSpec {
  std::string text;
  Spec spec;
};

/// The error: why the source has no text for the task, or the faults of its spec, which name the task. Those of a spec that stands on
/// one line of JSON have no line of their own.
tl::expected<TaskSpec, InputError> task_spec(const BatchTask& task);

/// The spec of the task that a batch calls `name` ("sign.toml", "line-17", "cell-2-1"), as if it had been given alone; its file is the
/// one that holds it. The error: as of task_spec(), or there is no such task.
tl::expected<LoadedSpec, InputError> spec_of_batch(const std::string& source, const std::string& name);

}  // namespace kempe::app
