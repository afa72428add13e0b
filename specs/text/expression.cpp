#include "specs/text/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <boost/math/interpolators/barycentric_rational.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>

namespace kempe {
namespace {

struct Compiled {
  mu::Parser parser;
  double x = 0;
};

/// The place of a "=" that assigns; the parser would take it, and give x another value.
std::optional<std::size_t> assignment_in(const std::string& text) {
  for (std::size_t i = text.find('='); i != std::string::npos; i = text.find('=', i + 1)) {
    if (i + 1 < text.size() && text[i + 1] == '=')
      ++i;
    else if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos)
      return i;
  }
  return std::nullopt;
}

}  // namespace

tl::expected<std::function<double(double)>, std::string> compile_expression(const std::string& text) {
  if (text.find('\0') != std::string::npos)
    return tl::unexpected(std::string("a character without a sign, number 0"));
  if (const auto place = assignment_in(text))
    return tl::unexpected(fmt::format("an assignment at position {}; == compares", *place));
  auto compiled = std::make_shared<Compiled>();
  try {
    compiled->parser.DefineVar("x", &compiled->x);
    compiled->parser.SetExpr(text);
    compiled->parser.Eval();
    if (const int values = compiled->parser.GetNumResults(); values != 1)
      return tl::unexpected(fmt::format("{} values, separated by commas", values));
  } catch (const mu::ParserError& error) {
    return tl::unexpected(error.GetMsg());
  }
  return std::function<double(double)>([compiled](double x) {
    compiled->x = x;
    try {
      return static_cast<double>(compiled->parser.Eval());
    } catch (const mu::ParserError&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  });
}

std::function<double(double)> interpolated(const std::vector<std::pair<double, double>>& rows) {
  std::vector<double> x, y;
  for (const auto& [at, value] : rows) {
    x.push_back(at);
    y.push_back(value);
  }
  auto curve = std::make_shared<boost::math::barycentric_rational<double>>(std::move(x), std::move(y), 3);
  return [curve](double at) { return (*curve)(at); };
}

}  // namespace kempe
