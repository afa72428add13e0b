#include "geometry/fixed_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace kempe {
namespace {

TEST(FixedText, HasNoMinusSignBeforeZero) {
  for (const double zero : {0.0, -0.0, -1e-300, -0.0004, 0.0004}) {
    EXPECT_EQ(fixed_text(zero, 3), "0.000");
    EXPECT_EQ(short_text(zero, 3), "0");
  }
  EXPECT_EQ(fixed_text(-0.4, 0), "0");
  EXPECT_EQ(fixed_text(-0.0006, 3), "-0.001");
}

TEST(FixedText, IsOtherwiseWhatFormatSays) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    const double value = std::ldexp(static_cast<double>(random()) - 9e18, -static_cast<int>(random() % 120));
    const int decimals = static_cast<int>(random() % 20);
    const std::string told = fmt::format("{:.{}f}", value, decimals);
    const bool is_zero = told.find_first_not_of("-0.") == std::string::npos;
    EXPECT_EQ(fixed_text(value, decimals), is_zero && told[0] == '-' ? told.substr(1) : told);
  }
}

TEST(ShortText, CutsZerosAtTheEnd) {
  EXPECT_EQ(short_text(12.5, 4), "12.5");
  EXPECT_EQ(short_text(1200, 4), "1200");
  EXPECT_EQ(short_text(1200, 0), "1200");
  std::string text = "1.00 ";
  append_short_text(text, 3, 2);
  EXPECT_EQ(text, "1.00 3");
  EXPECT_EQ(short_text(1e300, 300).size(), 301u);
}

}  // namespace
}  // namespace kempe
