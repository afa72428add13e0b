// Parts list and cutting list.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "reports/drawings/making_notes.hpp"
#include "reports/drawings/parts_fault.hpp"
#include "reports/workshop/sheets.hpp"
#include "reports/workshop/table.hpp"
#include "specs/hardware.hpp"

namespace kempe::workshop {
namespace {

/// "Ø8 x 12", "120.5 x 15 x 4": what the bill says of an item's size.
std::string size_of(const BomItem& item) {
  std::string text;
  const auto times = [&](double value, const char* before = "") {
    if (value > 0) text += (text.empty() ? "" : " x ") + std::string(before) + figure(value);
  };
  if (item.item == "spacer") {
    times(item.width, "\u00d8");
    times(item.length);
    return text + fmt::format(", bore \u00d8{}", figure(item.diameter));
  }
  if (item.item == "nut" || (item.item == "washer" && item.length > 0)) return figure(item.length) + " high";
  times(item.diameter, "\u00d8");
  times(item.blank_length > 0 ? item.blank_length : item.length);
  times(item.blank_width > 0 ? item.blank_width : item.width);
  times(item.thickness);
  return text;
}

/// The sentence as a line of its own: "Hardware differs ...".
std::string begun(std::string sentence) {
  if (!sentence.empty())
    sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

/// What a maker should know first, the gravest first.
Table notes_list(const Task& task, double width) {
  Table table{"Before making", {{"No.", 12, Align::middle}, {"Note", width - 12}}};
  const auto add = [&](const std::string& note) {
    table.rows.push_back({fmt::format("{}", table.rows.size() + 1), begun(note)});
  };
  if (const std::string cannot = why_not_cut(task.design); !cannot.empty()) add(cannot);
  for (const std::string& note : making_notes(task.design)) add(note);
  return table;
}

Table parts_list(const Task& task, double width) {
  Table table{"Parts list",
              {{"Item", 12, Align::middle},
               {"Qty", 10, Align::middle},
               {"Part", 37},
               {"Size, mm", 39},
               {"Remark", width - 98}}};
  int number = 0;
  for (const BomItem& item : task.bill)
    table.rows.push_back({fmt::format("{}", ++number), fmt::format("{}", item.quantity),
                          item.item == "link" ? "link " + item.name : item.name, size_of(item), item.remark});
  return table;
}

Table cutting_list(const Task& task, double width) {
  const auto fault = parts_fault(task.design, task.design.cutting);
  Table table{"Cutting list" + (fault ? ": cannot be cut, " + fault->note : ""),
              {{"Item", 12, Align::middle},
               {"Link", 18},
               {"Blank, mm", 48},
               {"Thickness, mm", 30},
               {"Holes, mm", width - 108}}};
  const CuttingSpec as_to_be = finished(task.design.cutting);
  for (const BomItem& item : task.bill) {
    if (item.item != "link") continue;
    const Link link =
        *std::find_if(all_links.begin(), all_links.end(), [&](Link one) { return name(one) == item.name; });
    table.rows.push_back({fmt::format("{}", item_number(task.bill, item.name)), item.name,
                          figure(item.blank_length) + " x " + figure(item.blank_width),
                          figure(item.thickness), holes_text(cut_part(task.design, link, as_to_be))});
  }
  return table;
}

}  // namespace

std::vector<Sheet> list_sheets(const Task& task) {
  constexpr double between = 8;
  std::vector<Sheet> sheets;
  double y = 0;
  const Point size =
      sheet_size(task.paper, task.paper == Paper::A4 ? Orientation::portrait : Orientation::landscape);
  const Box room = room_of(size);
  const double width = std::min(room.upper.x() - room.lower.x(), 240.0);
  const auto new_sheet = [&] {
    sheets.push_back({size, {"Parts list and cutting list", stock_text(task.design), "-"}});
    y = room.upper.y();
  };
  new_sheet();
  std::vector<Table> tables{parts_list(task, width), cutting_list(task, width)};
  if (Table notes = notes_list(task, width); !notes.rows.empty())
    tables.insert(tables.begin(), std::move(notes));
  for (const Table& table : tables) {
    const bool keeps_together = table.height(task.lettering) <= room.upper.y() - room.lower.y();
    if (keeps_together && table.height(task.lettering) > y - room.lower.y()) new_sheet();
    for (std::size_t row = 0; row < table.rows.size();) {
      const std::size_t last = table.fitting_rows(row, y - room.lower.y(), task.lettering);
      table.draw(sheets.back(), {room.lower.x(), y}, task.lettering, row, last);
      row = last;
      if (row < table.rows.size()) new_sheet();
    }
    y -= table.height(task.lettering) + between;
  }
  return sheets;
}

int item_number(const std::vector<BomItem>& bill, std::string_view name) {
  const auto found =
      std::find_if(bill.begin(), bill.end(), [&](const BomItem& item) { return item.name == name; });
  return found == bill.end() ? 0 : 1 + static_cast<int>(found - bill.begin());
}

std::string holes_text(const CutPart& part) {
  std::vector<std::pair<double, int>> counted;
  for (const CutPart::Hole& hole : part.holes) {
    const auto same = std::find_if(counted.begin(), counted.end(),
                                   [&](const auto& one) { return one.first == hole.diameter; });
    if (same == counted.end())
      counted.emplace_back(hole.diameter, 1);
    else
      ++same->second;
  }
  std::string text;
  for (const auto& [diameter, count] : counted)
    text += fmt::format("{}{} x \u00d8{}", text.empty() ? "" : ", ", count, figure(diameter));
  return text;
}

std::string why_not_cut(const Design& design) {
  const auto fault = parts_fault(design, design.cutting);
  return fault ? "the links cannot be cut as they are: " + fault->sentence : "";
}

std::string stock_text(const Design& design) {
  return fmt::format("{}{} mm sheet, links {} mm wide", design.material ? design.material->name + ", " : "",
                     figure(design.style.thickness), figure(design.style.width));
}

}  // namespace kempe::workshop
