#pragma once
// A fuzzer's bytes as numbers.

#include <string_view>

namespace kempe::fuzz {

/// Numbers from bytes, two each; zeros once the bytes are used up.
class Choices {
 public:
  explicit Choices(std::string_view bytes) : bytes_(bytes) {}

  double between(double lower, double upper) { return lower + (upper - lower) * next() / 65535.0; }
  int upto(int count) { return static_cast<int>(next()) % count; }

 private:
  unsigned next() {
    unsigned value = 0;
    for (int i = 0; i < 2; ++i) {
      value = value * 256;
      if (at_ < bytes_.size()) value += static_cast<unsigned char>(bytes_[at_++]);
    }
    return value;
  }
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace kempe::fuzz
