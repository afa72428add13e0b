#pragma once
// Expressions of one variable, as text.

#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace kempe {

/// y(x) for an expression such as "log10(x) + 2*x^2" (muParser's functions; angles in rad; pi is _pi). NaN where the
/// expression has no value. The error says where the text stops making sense, or that it assigns or has several values.
tl::expected<std::function<double(double)>, std::string> compile_expression(const std::string& text);

/// A smooth function through the rows (x rising, at least 4): barycentric rational interpolation, which has no poles
/// (Floater and Hormann, Numerische Mathematik 107, 2007).
std::function<double(double)> interpolated(const std::vector<std::pair<double, double>>& rows);

}  // namespace kempe
