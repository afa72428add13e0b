#pragma once
// What `kempe function` and `kempe inversor` ask and answer: the tasks of their specs, and the answers as JSON for programs.

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "specs/generator_spec.hpp"
#include "synthesis/functions/function_generator.hpp"
#include "synthesis/functions/inversor.hpp"

namespace kempe {

/// The task of a spec; `file` stands for it in the message about an expression that cannot be read.
tl::expected<FunctionTask, InputError> function_task(const FunctionSpec& spec, const std::string& file);

/// "y = log10(x)", or "the table".
std::string wanted_text(const FunctionSpec& spec);

/// Why no design came out: the sentence, or where the function stands against it the key that gives it, what was found and what is
/// allowed.
std::string why_none(const FunctionSpec& spec, const NoFunctionDesign& none);

/// What the answer does not claim; empty where it says all that is to be said.
std::string reservation(const FunctionDesign& design);

/// One JSON object: lengths, cranks, errors, transmission, the structural error's curve, "complete": false if the search was stopped, the reservation if there is one, and on
/// request the equations (function_equations.hpp).
std::string function_json(const FunctionTask& task, const FunctionDesign& design, bool with_equations);

/// The structural error's curve as SVG.
std::string function_plot(const FunctionDesign& design, const std::string& wanted);

InversorTask inversor_task(const InversorSpec& spec);

/// One JSON object: the lens, the best kind (null: none), and each kind's figures or why there is none.
std::string inversor_json(const InversorTask& task, const std::vector<InversorAnswer>& answers);

/// Why there is none of any kind.
std::string no_inversor_sentence(const std::vector<InversorAnswer>& answers);

}  // namespace kempe
