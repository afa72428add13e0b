#pragma once
// What WebAssembly lacks; cmake/wasm.cmake puts this before every source of the engine, and nothing else differs.

#if !defined(__wasm__)
#error "only for WebAssembly"
#endif
// There are no rounding modes: a change of mode is ignored, and intervals would have no width without a word.
#if !defined(CGAL_ALWAYS_ROUND_TO_NEAREST)
#error "WebAssembly has no rounding modes: intervals need CGAL_ALWAYS_ROUND_TO_NEAREST"
#endif
#if defined(__FAST_MATH__)
#error "intervals need every operation as it is written"
#endif

#include <fast_float/fast_float.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <complex>
#include <cstdio>
#include <system_error>

#include "complex_division.hpp"

namespace std {

/// This C++ library reads no doubles yet; fast_float is what others have inside. It refuses a leading plus and reads the nearest
/// double, as the standard says.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const auto read = fast_float::from_chars(first, last, value);
  return {read.ptr, read.ec};
}

/// Nor does it write them: general and fixed notation are printf's %g and %f, and there is no other locale than C's.
inline to_chars_result to_chars(char* first, char* last, double value, chars_format format, int precision) {
  if (format != chars_format::general && format != chars_format::fixed) return {last, errc::invalid_argument};
  const auto room = last - first;
  char text[512];  // the largest double has 309 digits before the point
  const int length =
      snprintf(text, sizeof text, format == chars_format::fixed ? "%.*f" : "%.*g", precision, value);
  if (length < 0 || length > room || length >= static_cast<int>(sizeof text))
    return {last, errc::value_too_large};
  for (int i = 0; i < length; ++i) first[i] = text[i];
  return {first + length, errc()};
}

/// Native programs divide as libgcc does. What has no finite quotient is left to this library.
inline complex<double> operator/(const complex<double>& z, const complex<double>& w) {
  const kempe::Quotient quotient = kempe::quotient_as_libgcc(z.real(), z.imag(), w.real(), w.imag());
  if (isfinite(quotient.re) && isfinite(quotient.im)) return {quotient.re, quotient.im};
  return operator/<double>(z, w);
}
inline complex<double> operator/(const double& z, const complex<double>& w) { return complex<double>(z) / w; }
template <>
inline complex<double>& complex<double>::operator/=(const complex<double>& w) {
  return *this = *this / w;
}

#if !defined(__cpp_lib_bit_cast)
/// The standard's.
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
#endif

}  // namespace std
