#include "specs/text/expression.hpp"

#include <muParser.h>

#include <boost/math/interpolators/barycentric_rational.hpp>
#include <cmath>
#include <limits>
#include <memory>

namespace kempe {
namespace {

struct Compiled {
  mu::Parser parser;
  double x = 0;
};

}  // namespace

tl::expected<std::function<double(double)>, std::string> compile_expression(const std::string& text) {
  auto compiled = std::make_shared<Compiled>();
  try {
    compiled->parser.DefineVar("x", &compiled->x);
    compiled->parser.SetExpr(text);
    compiled->parser.Eval();
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
