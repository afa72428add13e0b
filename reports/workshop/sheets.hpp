#pragma once
// The sheets of a design's drawings, each by a function of its own.

#include <string>
#include <string_view>
#include <vector>

#include "reports/drawings/bom.hpp"
#include "reports/drawings/part_drawings.hpp"
#include "reports/workshop/frame.hpp"
#include "reports/workshop/sheet.hpp"
#include "synthesis/design/design.hpp"

namespace kempe::workshop {

/// What every sheet is drawn from.
struct Task {
  const Design& design;
  const std::vector<BomItem>& bill;
  Paper paper;
  const Lettering& lettering;
};

/// The number of a thing in the parts list: its place in the bill, from 1; 0 if the bill lacks it.
int item_number(const std::vector<BomItem>& bill, std::string_view name);

/// "4 mm sheet".
std::string stock_text(const Design& design);

/// How many holes of a part have which diameter: "3 x Ø6.1"; "1 x Ø22, 2 x Ø6.1", in the order in which they are met.
std::string holes_text(const CutPart& part);

/// "the links cannot be cut as they are: ...", the sentence of parts_fault.hpp; empty if they can.
std::string why_not_cut(const Design& design);

/// The mechanism from above, upper links on lower ones, edges below something dashed; balloons with the items' numbers.
Sheet assembly_sheet(const Task& task);
/// Parts list and cutting list, before them what a maker should know (making_notes.hpp); as many sheets as they need.
std::vector<Sheet> list_sheets(const Task& task);
/// A section through each joint: links, spacers, washers, pins, with their heights above the table.
Sheet stack_sheet(const Task& task);
/// A link with its dimensions and its table of holes, at 1:1 if the paper takes it; else smaller, and tiles at 1:1 follow unless the links
/// cannot be cut, which the sheet then says.
std::vector<Sheet> link_sheets(const Task& task, Link link);
/// Where pole, region, copy and obstacles lie on the table: the plan, and the table of places below it or on sheets that follow.
std::vector<Sheet> bench_sheets(const Task& task);

}  // namespace kempe::workshop
