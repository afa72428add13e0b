#include "studio/complex_division.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <random>

namespace kempe {
namespace {

#if defined(__GLIBCXX__)  // whose complex numbers are libgcc's

TEST(ComplexDivision, RoundsAsLibgccDoes) {
  std::mt19937_64 random(1);
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  const auto any = [&] {  // of any size
    for (;;)
      if (const double value = std::bit_cast<double>(random()); std::isfinite(value)) return value;
  };
  const auto usual = [&] {
    return std::ldexp(static_cast<double>(random() >> 11) - std::ldexp(1.0, 52), -45);
  };
  int compared = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto one = [&] { return i % 2 == 0 ? any() : usual(); };
    const double a = one(), b = one(), c = one(), d = one();
    const std::complex<double> expected = std::complex<double>(a, b) / std::complex<double>(c, d);
    const Quotient found = quotient_as_libgcc(a, b, c, d);
    if (!std::isfinite(found.re) || !std::isfinite(found.im))
      continue;  // the engine leaves these to its library
    ++compared;
    ASSERT_EQ(bits(found.re), bits(expected.real())) << a << " " << b << " / " << c << " " << d;
    ASSERT_EQ(bits(found.im), bits(expected.imag())) << a << " " << b << " / " << c << " " << d;
  }
  EXPECT_GT(compared, 50000);
}

#endif

}  // namespace
}  // namespace kempe
