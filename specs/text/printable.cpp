#include "specs/text/printable.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>

namespace kempe {
namespace {

/// One character of a text: its code point, and how many bytes it takes; `valid` is false for a byte that is no UTF-8.
struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
  bool valid = true;
};

/// The first character of a text that is not empty. Forms longer than needed, surrogates and codes beyond Unicode are not
/// valid (RFC 3629).
Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  const Character broken{lead, 1, false};
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return broken;
  std::uint32_t code = lead & (0xffU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return broken;
    code = (code << 6U) | (byte(i) & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  if (code < least[bytes] || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return broken;
  return {code, bytes, true};
}

bool is_within(std::uint32_t code, std::uint32_t lowest, std::uint32_t highest) {
  return code >= lowest && code <= highest;
}

/// Marks of direction, separators of lines, characters without width, the byte order mark.
bool misleads(std::uint32_t code) {
  return code == 0x061c || is_within(code, 0x200b, 0x200f) || is_within(code, 0x2028, 0x202e) ||
         is_within(code, 0x2060, 0x206f) || code == 0xfeff;
}

bool is_control(std::uint32_t code) { return code < 0x20 || is_within(code, 0x7f, 0x9f); }

std::string written_out(const Character& character) {
  if (!character.valid) return fmt::format("\\x{:02x}", character.code);
  if (character.code == '\n') return "\\n";
  if (character.code == '\r') return "\\r";
  if (character.code == '\t') return "\\t";
  return character.code < 0x80 ? fmt::format("\\x{:02x}", character.code)
                               : fmt::format("\\u{:04x}", character.code);
}

std::string shown(std::string_view text, std::string_view kept) {
  std::string result;
  while (!text.empty()) {
    const Character next = first_of(text);
    const bool plain = next.valid && !is_control(next.code) && !misleads(next.code);
    if (plain || (next.bytes == 1 && kept.find(text.front()) != std::string_view::npos))
      result += text.substr(0, next.bytes);
    else
      result += written_out(next);
    text.remove_prefix(next.bytes);
  }
  return result;
}

}  // namespace

std::string printable(std::string_view text) { return shown(text, ""); }

std::string printable(std::string_view text, std::size_t most) {
  std::size_t end = 0;
  while (end < text.size()) {
    const std::size_t next = end + first_of(text.substr(end)).bytes;
    if (next > most) break;
    end = next;
  }
  return printable(text.substr(0, end)) + (end < text.size() ? "..." : "");
}

std::string printable_lines(std::string_view text) { return shown(text, "\n\t"); }

}  // namespace kempe
