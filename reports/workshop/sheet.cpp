#include "reports/workshop/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kempe::workshop {
namespace {

/// Bytes of the first character of a UTF-8 text that is not empty.
std::size_t first_character(std::string_view text) {
  std::size_t bytes = 1;
  while (bytes < text.size() && (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80) ++bytes;
  return bytes;
}

/// The longest beginning of a word that fits, at least one character.
std::string_view fitting_start(std::string_view word, double height, double width,
                               const Lettering& lettering) {
  std::size_t bytes = first_character(word);
  while (bytes < word.size()) {
    const std::size_t next = bytes + first_character(word.substr(bytes));
    if (lettering(word.substr(0, next), height) > width) break;
    bytes = next;
  }
  return word.substr(0, bytes);
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t space = std::min(text.find(' ', from), text.size());
    if (space > from) words.push_back(text.substr(from, space - from));
    from = space + 1;
  }
  return words;
}

}  // namespace

void Sheet::line(const Point& from, const Point& to, Pen pen) {
  marks.emplace_back(SheetPath{{{from}, {to}}, false, pen});
}

void Sheet::rectangle(const Box& box, Pen pen, Fill fill) {
  outline({{box.lower}, {{box.upper.x(), box.lower.y()}}, {box.upper}, {{box.lower.x(), box.upper.y()}}}, pen,
          fill);
}

void Sheet::outline(const ArcRing& ring, Pen pen, Fill fill) {
  marks.emplace_back(SheetPath{ring, true, pen, fill});
}

void Sheet::circle(const Point& centre, double radius, Pen pen, Fill fill) {
  outline(kempe::circle(centre, radius), pen, fill);
}

void Sheet::text(std::string text, const Point& at, double height, Align align, double turn) {
  if (!text.empty()) marks.emplace_back(SheetText{std::move(text), at, height, align, turn});
}

std::string shortened(const std::string& text, double height, double width, const Lettering& lettering) {
  if (lettering(text, height) <= width) return text;
  const double rest = width - lettering("...", height);
  return std::string(fitting_start(text, height, rest, lettering)) + "...";
}

std::vector<std::string> wrapped(const std::string& text, double height, double width,
                                 const Lettering& lettering) {
  std::vector<std::string> lines;
  for (std::string word : words_of(text)) {
    if (!lines.empty() && lettering(lines.back() + " " + word, height) <= width) {
      lines.back() += " " + word;
      continue;
    }
    while (lettering(word, height) > width && word.size() > first_character(word)) {
      const std::string start(fitting_start(word, height, width, lettering));
      lines.push_back(start);
      word.erase(0, start.size());
    }
    if (!word.empty()) lines.push_back(word);
  }
  return lines.empty() ? std::vector<std::string>{""} : lines;
}

std::string figure(double value) {
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

ArcRing View::at(const ArcRing& ring) const {
  ArcRing result = ring;
  for (ArcVertex& vertex : result) vertex.at = at(vertex.at);
  return result;
}

double fitting_scale(const Point& size, const Point& room, double most) {
  const double wanted = std::min({most, room.x() / size.x(), room.y() / size.y()});
  double best = std::pow(10, std::floor(std::log10(wanted)));
  for (const double step : {5.0, 2.0})
    if (best * step <= wanted) return best * step;
  return best;
}

std::string scale_text(double scale) {
  return scale >= 1 ? fmt::format("{:.6g}:1", scale) : fmt::format("1:{:.6g}", 1 / scale);
}

}  // namespace kempe::workshop
