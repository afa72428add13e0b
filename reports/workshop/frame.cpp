#include "reports/workshop/frame.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace kempe::workshop {
namespace {

constexpr double filing_margin = 20, frame_margin = 10, centring_mark = 5;  ///< mm
constexpr double block_width = 180, block_height = 30;                      ///< mm
constexpr double block_row = block_height / 3;

Box inside_of(const Point& size) {
  return {Point(filing_margin, frame_margin), Point(size.x() - frame_margin, size.y() - frame_margin)};
}

Box block_of(const Point& size) {
  const Box frame = inside_of(size);
  return {Point(frame.upper.x() - block_width, frame.lower.y()),
          Point(frame.upper.x(), frame.lower.y() + block_height)};
}

void draw_centring_marks(Sheet& sheet) {
  const Box frame = inside_of(sheet.size);
  const Point middle = 0.5 * (frame.lower + frame.upper);
  sheet.line({frame.lower.x() - centring_mark, middle.y()}, {frame.lower.x(), middle.y()}, Pen::frame);
  sheet.line({frame.upper.x(), middle.y()}, {frame.upper.x() + centring_mark, middle.y()}, Pen::frame);
  sheet.line({middle.x(), frame.upper.y()}, {middle.x(), frame.upper.y() + centring_mark}, Pen::frame);
  sheet.line({middle.x(), frame.lower.y()}, {middle.x(), frame.lower.y() - centring_mark}, Pen::frame);
}

/// Cells of a block_row of the title block from left to right, each a field's name above its value. A value that is too wide is written
/// smaller, and cut only where even small letters do not do.
class BlockRow {
 public:
  BlockRow(Sheet& sheet, const Point& lower_left, const Lettering& lettering)
      : sheet_(sheet), at_(lower_left), lettering_(lettering) {}

  void cell(const std::string& name, const std::string& value, double width, double height = text_height) {
    sheet_.rectangle({at_, at_ + Point(width, block_row)}, Pen::thin);
    sheet_.text(name, at_ + Point(1, block_row - 1.2 - small_text), small_text);
    const double room = width - 2, needed = lettering_(value, height);
    const double fitting = needed > room ? std::max(small_text, height * room / needed) : height;
    sheet_.text(shortened(value, fitting, room, lettering_), at_ + Point(1, 1.6), fitting);
    at_.x() += width;
  }

 private:
  Sheet& sheet_;
  Point at_;
  const Lettering& lettering_;
};

}  // namespace

Point sheet_size(Paper paper, Orientation orientation) {
  const Point portrait = paper == Paper::A4 ? Point(210, 297) : Point(297, 420);
  return orientation == Orientation::portrait ? portrait : Point(portrait.y(), portrait.x());
}

Box room_of(const Point& size) {
  constexpr double beside = 4;
  const Box frame = inside_of(size);
  return {frame.lower + Point(beside, block_height + beside), frame.upper - Point(beside, beside)};
}

void draw_ruler(Sheet& sheet) {
  constexpr int millimetres = 100;
  const Point foot = room_of(sheet.size).lower + Point(3, 6.5);
  for (int mm = 0; mm <= millimetres; ++mm) {
    const double tick = mm % 10 == 0 ? 4 : mm % 5 == 0 ? 3 : 2;
    const Point at = foot + Point(mm, 0);
    sheet.line(at, at + Point(0, tick), Pen::hatch);
    if (mm % 20 == 0)
      sheet.text(fmt::format("{}", mm), at - Point(0, 0.9 + text_height), text_height, Align::middle);
  }
  sheet.line(foot, foot + Point(millimetres, 0), Pen::hatch);
  sheet.text("100 mm: measure it on the print", foot + Point(millimetres + 6, 0.8), text_height);
}

void draw_frame(Sheet& sheet, const Job& job, std::size_t number, std::size_t count,
                const Lettering& lettering) {
  sheet.rectangle(inside_of(sheet.size), Pen::frame);
  draw_centring_marks(sheet);
  const Box block = block_of(sheet.size);
  const auto row_at = [&](int index) {
    return BlockRow(sheet, block.lower + Point(0, block_row * index), lettering);
  };
  BlockRow top = row_at(2), middle = row_at(1), bottom = row_at(0);
  top.cell("Title", job.title, 128, heading_height);
  top.cell("Sheet", fmt::format("{} of {}", number, count), 26, heading_height);
  top.cell("Scale", sheet.title.scale, 26, heading_height);
  middle.cell("Drawing", sheet.title.part, 90);
  middle.cell("Material", sheet.title.material, 90);
  bottom.cell("Copy", job.copy, 50);
  bottom.cell("Date", job.date, 30);
  bottom.cell("Design (SHA-1 of design.json)", job.hash.substr(0, 16), 46);
  bottom.cell("Drawn by", "Kempe " + job.version, 28);
  bottom.cell("Dimensions", "mm", 26);
  sheet.rectangle(block, Pen::frame);
}

}  // namespace kempe::workshop
