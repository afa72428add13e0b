#include "reports/drawings/part_solid.hpp"

#include <Eigen/Geometry>
#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <tuple>

namespace kempe {
namespace {

constexpr std::size_t header_size = 80, triangle_size = 50;

template <class Word>
void append_little_endian(std::string& bytes, Word word) {
  for (std::size_t i = 0; i < sizeof(Word); ++i) bytes += static_cast<char>(word >> (8 * i) & 0xFF);
}

std::uint32_t word_at(std::string_view bytes, std::size_t place) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i)
    word |= std::uint32_t{static_cast<unsigned char>(bytes[place + i])} << (8 * i);
  return word;
}

void append_vector(std::string& bytes, const Eigen::Vector3d& v) {
  for (int i = 0; i < 3; ++i)
    append_little_endian(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(v[i])));
}

Eigen::Vector3d vector_at(std::string_view bytes, std::size_t place) {
  const auto number = [&](std::size_t i) {
    return static_cast<double>(std::bit_cast<float>(word_at(bytes, place + 4 * i)));
  };
  return {number(0), number(1), number(2)};
}

}  // namespace

double volume(const Solid& solid) {
  double sum = 0;
  for (const auto& [a, b, c] : solid) sum += a.dot(b.cross(c));
  return sum / 6;
}

bool is_closed(const Solid& solid) {
  using Corner = std::tuple<double, double, double>;
  const auto corner = [](const Eigen::Vector3d& v) { return Corner{v.x(), v.y(), v.z()}; };
  std::map<std::pair<Corner, Corner>, int> runs;
  for (const Triangle& triangle : solid)
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner from = corner(triangle[i]), to = corner(triangle[(i + 1) % 3]);
      if (++runs[{from, to}] > 1) return false;
    }
  for (const auto& [edge, count] : runs)
    if (runs.find({edge.second, edge.first}) == runs.end()) return false;
  return !solid.empty();
}

std::string stl_bytes(const Solid& solid, std::string_view name) {
  // A header that began with "solid" would be taken for a text STL.
  std::string bytes = "binary STL, mm: " + std::string(name.substr(0, 60));
  bytes.resize(header_size, ' ');
  append_little_endian(bytes, static_cast<std::uint32_t>(solid.size()));
  for (const auto& [a, b, c] : solid) {
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    append_vector(bytes, normal / normal.norm());
    for (const auto& corner : {a, b, c}) append_vector(bytes, corner);
    append_little_endian(bytes, std::uint16_t{0});
  }
  return bytes;
}

tl::expected<Solid, std::string> read_stl(std::string_view bytes) {
  if (bytes.size() < header_size + 4) return tl::unexpected(std::string("an STL cut short"));
  const std::size_t count = word_at(bytes, header_size);
  if (bytes.size() != header_size + 4 + count * triangle_size)
    return tl::unexpected(std::string("an STL of the wrong length"));
  Solid solid(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t corner = 0; corner < 3; ++corner)
      solid[i][corner] = vector_at(bytes, header_size + 4 + i * triangle_size + 12 * (corner + 1));
  return solid;
}

}  // namespace kempe
