// Sections through the joints: what lies on what.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/drawings/joint_stack.hpp"
#include "reports/drawings/spacers.hpp"
#include "reports/workshop/dimension.hpp"
#include "reports/workshop/sheets.hpp"
#include "specs/hardware.hpp"

namespace kempe::workshop {
namespace {

constexpr double washer_height = 1.2;  ///< mm on paper: washers are drawn, not measured
constexpr double widest = 15;          ///< mm on paper from the axis: wider links are broken off

/// A label that wants to stand beside a height.
struct SideLabel {
  std::string text;
  double height;
  double reach;  ///< of its part from the axis
};

/// Column by column: the section at one joint.
class Section {
 public:
  /// `table` is the table's height on paper; layer 1 begins `raised` mm above it.
  Section(Sheet& sheet, const Task& task, const JointStack& stack, const std::vector<Spacer>& spacers,
          double x, double table, double raised, double scale)
      : sheet_(sheet), task_(task), stack_(stack), spacers_(spacers), x_(x), table_(table), raised_(raised),
        scale_(scale), pin_(0.5 * stack.diameter * scale) {}

  void draw(double label_x) {
    for (const Spacer& spacer : spacers_)
      if (spacer.diameter > spacer.bore)
        draw_ring({StackItem::Kind::spacer, spacer.has_room() ? spacer.name : "collar", spacer.from,
                   spacer.to, spacer.diameter});
    for (const StackItem& item : stack_.items)
      if (item.kind == StackItem::Kind::link)
        draw_link(item);
      else if (item.kind != StackItem::Kind::spacer)
        draw_ring(item);
    if (!stack_.is_post && task_.design.hardware[stack_.joint].empty()) draw_washers();
    draw_pin();
    write_labels(label_x);
  }

 private:
  double y(double height) const { return table_ + scale_ * (raised_ + height); }
  Box half_box(double from, double to, double inner, double outer, bool left) const {
    return left ? Box{{x_ - outer, y(from)}, {x_ - inner, y(to)}}
                : Box{{x_ + inner, y(from)}, {x_ + outer, y(to)}};
  }

  /// Two halves beside the pin, hatched to one side or the other as the layer is odd or even.
  void draw_link(const StackItem& item) {
    const double full = 0.5 * item.diameter * scale_, outer = std::min(full, widest);
    const Hardware* hardware = hardware_named(task_.design.hardware[stack_.joint]);
    const double seat = hardware != nullptr ? std::min(0.5 * hardware->seat * scale_, outer) : 0;
    for (const bool left : {true, false}) {
      const Box box = half_box(item.from, item.to, std::max(pin_, seat), outer, left);
      hatch(box, std::lround(item.from / task_.design.style.thickness) % 2 == 0);
      outline_of_half(box, left, full > widest);
    }
    label(item);
    if (seat > 0) draw_seat(*hardware, item, seat);
  }

  /// The bearing or bush in a link's hole, in the middle of its thickness; a bearing crossed as ISO 8826 shows it. Labelled once a
  /// joint.
  void draw_seat(const Hardware& hardware, const StackItem& link, double outer) {
    const double width = hardware.seat_width > 0 ? hardware.seat_width : link.to - link.from;
    const double middle = 0.5 * (link.from + link.to);
    for (const bool left : {true, false}) {
      const Box box = half_box(middle - 0.5 * width, middle + 0.5 * width, pin_, outer, left);
      sheet_.rectangle(box, Pen::outline, Fill::paper);
      if (hardware.kind != HardwareKind::bearing) continue;
      sheet_.line(box.lower, box.upper, Pen::thin);
      sheet_.line({box.lower.x(), box.upper.y()}, {box.upper.x(), box.lower.y()}, Pen::thin);
    }
    if (link.name != name(stack_.links.front())) return draw_shim_rings(hardware, link, outer, false);
    const std::string text = seat_name(hardware);
    labels_.push_back({fmt::format("{}  {}", item_number(task_.bill, text), text), y(middle), outer});
    draw_shim_rings(hardware, link, outer, true);
  }

  /// Below and above a bearing's inner ring, which takes about a third of the bearing.
  void draw_shim_rings(const Hardware& hardware, const StackItem& link, double outer, bool is_labelled) {
    const auto ring = shim_ring(hardware, link.to - link.from);
    if (!ring) return;
    const double reach = pin_ + 0.3 * (outer - pin_);
    for (const double from : {link.from, link.to - ring->height})
      for (const bool left : {true, false})
        sheet_.rectangle(half_box(from, from + ring->height, pin_, reach, left), Pen::thin, Fill::shade);
    if (is_labelled)
      labels_.push_back({fmt::format("{}  {}", item_number(task_.bill, ring->name), ring->name),
                         y(link.from + 0.5 * ring->height), reach});
  }

  /// The broken edge of a half is a thin zigzag.
  void outline_of_half(const Box& box, bool left, bool broken) {
    if (!broken) return sheet_.rectangle(box, Pen::outline);
    const double inner = left ? box.upper.x() : box.lower.x(), outer = left ? box.lower.x() : box.upper.x();
    sheet_.line({inner, box.lower.y()}, {outer, box.lower.y()}, Pen::outline);
    sheet_.line({inner, box.upper.y()}, {outer, box.upper.y()}, Pen::outline);
    sheet_.line({inner, box.lower.y()}, {inner, box.upper.y()}, Pen::outline);
    const double middle = 0.5 * (box.lower.y() + box.upper.y()), tooth = 0.8;
    const Point points[] = {{outer, box.lower.y()},
                            {outer, middle - tooth},
                            {outer - tooth, middle - 0.5 * tooth},
                            {outer + tooth, middle + 0.5 * tooth},
                            {outer, middle + tooth},
                            {outer, box.upper.y()}};
    for (std::size_t i = 0; i + 1 < std::size(points); ++i) sheet_.line(points[i], points[i + 1], Pen::thin);
  }

  void hatch(const Box& box, bool rising) {
    constexpr double pitch = 1.5;
    sheet_.marks.emplace_back(ClipBegin{box});
    const double height = box.upper.y() - box.lower.y();
    const double from = std::floor((box.lower.x() - height) / pitch) * pitch;
    for (double x = from; x <= box.upper.x() + height; x += pitch)
      sheet_.line({x, rising ? box.lower.y() : box.upper.y()},
                  {x + height, rising ? box.upper.y() : box.lower.y()}, Pen::hatch);
    sheet_.marks.emplace_back(ClipEnd{});
  }

  /// A spacer, washer, shim, head or nut; above a shoulder round the thread.
  void draw_ring(const StackItem& item) {
    const double outer = std::min(0.5 * item.diameter * scale_, widest);
    label(item);
    if (item.kind == StackItem::Kind::head)
      return sheet_.rectangle({{x_ - outer, y(item.from)}, {x_ + outer, y(item.to)}}, Pen::outline,
                              Fill::shade);
    const bool on_thread = stack_.fastener && stack_.fastener->thread > 0 && item.from >= stack_.fastener->to;
    const double inner = on_thread ? 0.5 * stack_.fastener->thread * scale_ : pin_;
    for (const bool left : {true, false})
      sheet_.rectangle(half_box(item.from, item.to, inner, outer, left), Pen::outline, Fill::shade);
  }

  /// One over the upper link, one under the lower; where that slides on the table both lie above.
  void draw_washers() {
    const double outer = std::min(1.9 * pin_, widest + 1.0), top = y(stack_.to), foot = y(stack_.from);
    const bool has_room_below = raised_ + stack_.from > 0;
    const auto washer = [&](double low) {
      sheet_.rectangle({{x_ - outer, low}, {x_ + outer, low + washer_height}}, Pen::thin, Fill::shade);
    };
    washer(top);
    washer(has_room_below ? foot - washer_height : top + washer_height);
    labels_.push_back(
        {fmt::format("{}  2 washers", item_number(task_.bill, "washer")), top + washer_height, outer});
  }

  /// The bought length where the hardware is named; else the grip: heads and threads are the maker's choice.
  void draw_pin() {
    const double from = stack_.fastener ? stack_.fastener->from : stack_.from,
                 to = stack_.fastener ? stack_.fastener->to : stack_.to;
    const double low = stack_.is_post ? table_ - 8 : y(from), high = y(to);
    sheet_.rectangle({{x_ - pin_, low}, {x_ + pin_, high}}, Pen::outline, Fill::paper);
    if (stack_.fastener) {
      const double end = y(stack_.fastener->end()), thread = 0.5 * stack_.fastener->thread * scale_;
      if (end > high) sheet_.rectangle({{x_ - thread, high}, {x_ + thread, end}}, Pen::outline, Fill::paper);
      return sheet_.line({x_, low - 3}, {x_, end + 3}, Pen::centre);
    }
    const double head = high + (stack_.is_post ? 3 : 2 * washer_height + 3);
    for (const double side : {-pin_, pin_}) sheet_.line({x_ + side, high}, {x_ + side, head}, Pen::phantom);
    sheet_.line({x_, low - 3}, {x_, head + 2}, Pen::centre);
  }

  /// With the item's number, where the bill counts it by itself.
  void label(const StackItem& item) {
    const int number = item_number(task_.bill, item.name);
    labels_.push_back({number > 0 ? fmt::format("{}  {}", number, item.name) : item.name,
                       y(0.5 * (item.from + item.to)), std::min(0.5 * item.diameter * scale_, widest)});
  }

  /// The highest first, moved apart, each led to its part.
  void write_labels(double x) {
    constexpr double apart = 2 * text_height;
    std::sort(labels_.begin(), labels_.end(),
              [](const SideLabel& a, const SideLabel& b) { return a.height < b.height; });
    double free_from = table_ + 0.5 * text_height + 0.8;  // the table strikes no word through
    for (const SideLabel& one : labels_) {
      const double at = std::max(one.height, free_from);
      const Point on_part(x_ + std::max(0.8 * one.reach, 0.5 * (pin_ + one.reach)), one.height);
      sheet_.line(on_part, {x - 1, at}, Pen::thin);
      sheet_.circle(on_part, 0.4, Pen::thin, Fill::ink);
      sheet_.text(one.text, {x, at - 0.5 * text_height}, text_height);
      free_from = at + apart;
    }
  }

  Sheet& sheet_;
  const Task& task_;
  const JointStack& stack_;
  const std::vector<Spacer>& spacers_;
  double x_, table_, raised_, scale_, pin_;
  std::vector<SideLabel> labels_;
};

/// The height scale at the left of a row: where each layer lies.
void draw_layers(Sheet& sheet, const Task& task, double left, double right, double table, double raised,
                 double scale) {
  const int layers = task.design.layers.highest();
  const double pitch = task.design.style.thickness * scale;
  sheet.line({left, table}, {right, table}, Pen::outline);
  for (double x = left + 1.5; x < right; x += 4) sheet.line({x, table}, {x - 1.5, table - 1.5}, Pen::hatch);
  sheet.text("table", {left, table - 2.5 - text_height}, text_height);
  const double extension = left + 18;
  for (int layer = 1; layer <= layers; ++layer) {
    const double low = table + raised * scale + (layer - 1) * pitch;
    if (pitch < 2 * text_height) continue;
    sheet.line({left, low + pitch}, {extension, low + pitch}, Pen::hatch);
    sheet.text(fmt::format("layer {}", layer), {left, low + 0.5 * (pitch - text_height)}, text_height);
  }
  const double height = raised + layers * task.design.style.thickness;
  dimension_along_y(sheet, {extension, table}, {extension, table + height * scale}, left + 26, figure(height),
                    task.lettering, true);
}

/// Pins narrow enough for their column, layers low enough for their row.
double scale_of(const Task& task, const std::vector<JointStack>& stacks, double height) {
  double top = task.design.layers.highest() * task.design.style.thickness;
  for (const JointStack& stack : stacks) {
    for (const StackItem& item : stack.items) top = std::max(top, item.to);
    if (stack.fastener) top = std::max(top, stack.fastener->end());
  }
  return fitting_scale(Point(task.design.style.pin_diameter, raised_by(stacks) + top), Point(14, height), 50);
}

void write_heading(Sheet& sheet, const Task& task, const JointStack& stack, const Point& at) {
  const std::string heading = fmt::format("{}  {}", item_number(task.bill, stack.name), stack.name);
  const std::string grip = fmt::format("\u00d8{}, grip {}", figure(stack.diameter), figure(stack.grip()));
  const Point below = at - Point(0, line_pitch * text_height);
  sheet.text(heading, at, heading_height);
  if (!stack.fastener) return sheet.text(grip, below, text_height);
  sheet.text(grip, at + Point(task.lettering(heading, heading_height) + 4, 0), text_height);
  sheet.text(fmt::format("{}  {}", item_number(task.bill, stack.fastener->name), stack.fastener->name), below,
             text_height);
}

}  // namespace

Sheet stack_sheet(const Task& task) {
  constexpr std::size_t columns = 3, rows = 2;
  constexpr double heading = 12, below_table = 12, above = 4, left = 30;  // mm
  Sheet sheet{sheet_size(task.paper, Orientation::landscape),
              {"Stack at each joint, section", stock_text(task.design), ""}};
  const auto stacks = joint_stacks(task.design);
  const Box field = room_of(sheet.size);
  const double note = 3 * text_height;
  const double row_height = (field.upper.y() - field.lower.y() - note) / rows;
  const double column_width = (field.upper.x() - field.lower.x() - left) / columns;
  const double scale = scale_of(task, stacks, row_height - heading - below_table - above);
  const double raised = raised_by(stacks);
  const auto spacers = spacers_of(task.design, stacks);
  sheet.title.scale = scale_text(scale);
  for (std::size_t i = 0; i < stacks.size(); ++i) {
    const std::size_t row = i / columns;
    const double top = field.upper.y() - row_height * static_cast<double>(row);
    const double table = top - row_height + below_table;
    const double x = field.lower.x() + left + column_width * static_cast<double>(i % columns);
    if (i % columns == 0) draw_layers(sheet, task, field.lower.x(), field.upper.x(), table, raised, scale);
    const double axis = x + widest + 2;
    Section(sheet, task, stacks[i], spacers[i], axis, table, raised, scale).draw(axis + widest + 4);
    write_heading(sheet, task, stacks[i], {x, top - heading_height - 2});
  }
  sheet.text(task.design.hardware.none()
                 ? "Heads, nuts and threads are extra. A pin whose lowest link lies on the "
                   "table has a countersunk head."
                 : "Pins: " + words(task.design.hardware) + ". Posts are the maker's.",
             {field.lower.x(), field.lower.y()}, text_height);
  return sheet;
}

}  // namespace kempe::workshop
