#include "reports/calibration/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/pictures/html_text.hpp"
#include "reports/pictures/mechanism_picture.hpp"
#include "reports/pictures/picture_extent.hpp"
#include "reports/pictures/svg_element.hpp"
#include "reports/pictures/svg_path.hpp"
#include "synthesis/calibration/plan.hpp"

namespace kempe {
namespace {

/// An error at a place.
struct Vector {
  Point at, error;
  bool outlier = false;
};

double round_down(double wanted) {
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  for (const double factor : {5.0, 2.0, 1.0})
    if (wanted >= factor * power) return factor * power;
  return power;
}

class ErrorVectorPicture {
 public:
  ErrorVectorPicture(const CalibrationRecord& record, ErrorVectors which) : record_(record), which_(which) {
    for (const ReadingRecord& reading : record.readings)
      vectors_.push_back({reading.wanted,
                          which == ErrorVectors::before ? reading.fit.departure : reading.fit.left,
                          reading.fit.outlier});
    if (which == ErrorVectors::before) field_ = field();
    frame();
  }

  VectorPicture draw() const {
    if (vectors_.empty()) return {};
    const PictureBox box = extent_.box();
    const Point lower = box.centre - box.half - Point::Constant(margin_),
                size = 2 * box.half + Point::Constant(2 * margin_);
    const SvgElement svg =
        SvgElement("svg")
            .with("class", "map")
            .with("viewBox", view_box(lower.x(), -lower.y() - size.y(), size.x(), size.y() + strip()))
            .with("font-size", 19 * unit_)
            .with("role", "img")
            .with("aria-label",
                  which_ == ErrorVectors::before ? "Error vectors as read" : "Error vectors that are left")
            .holding("\n" + linkage() + arrows() +
                     key(Point(lower.x() + margin_, lower.y() - 0.55 * strip())));
    return {svg.line(), magnification_};
  }

 private:
  /// Departures all over the reach by the fitted measures.
  std::vector<Vector> field() const {
    const Instrument& drawn = record_.setups.front();
    std::vector<Candidate> places;
    if (record_.design) {
      places = candidates_over_reach(*record_.design, false, 0, 7, 9);
    } else {
      CalibrationTask task;
      task.setups = {drawn};
      const ArmAngles& angles = record_.measurements.arm_angles;
      places =
          candidates_on_axis(task, 0, record_.measurements.instrument->arm, angles.lower, angles.upper, 21);
    }
    std::vector<Vector> all;
    for (const Candidate& place : places) {
      const auto output = output_at(drawn, drawn.drawn + record_.calibration.deviations, place.input);
      const Point wanted = wanted_output(drawn, place.input);
      if (output) all.push_back({wanted, output->at - wanted});
    }
    return all;
  }

  void frame() {
    double longest = 0;
    for (const Vector& vector : vectors_) {
      extent_.add(vector.at);
      if (!vector.outlier || which_ == ErrorVectors::before) longest = std::max(longest, vector.error.norm());
    }
    for (const Vector& vector : field_) extent_.add(vector.at);
    const auto pose = shown_pose();
    if (pose)
      for (const Joint joint : all_joints) extent_.add((*pose)[joint]);
    const Point size = 2 * extent_.box().half;
    unit_ = std::max(size.x(), 0.8 * size.y()) / 620;
    longest = std::max(longest, which_ == ErrorVectors::after ? record_.measurements.fit.target : 0.0);
    magnification_ = longest > 0 ? round_down(70 * unit_ / longest) : 1;
    margin_ = 90 * unit_;
  }

  tl::expected<Pose, ClosureFault> shown_pose() const {
    const Instrument& drawn = record_.setups.front();
    if (record_.design) {
      return pose_of(drawn, drawn.drawn, record_.design->place(0.5, 0.5));
    }
    return pose_of(drawn, drawn.drawn, Point(std::sqrt(2.0) * record_.measurements.instrument->arm, 0));
  }

  double strip() const { return 62 * unit_; }

  std::string linkage() const {
    const auto pose = shown_pose();
    if (!pose) return {};
    const auto bar = [&](std::initializer_list<Joint> joints) {
      std::vector<Point> line;
      for (const Joint joint : joints) line.push_back((*pose)[joint]);
      return SvgElement("g")
          .with("class", "link layer-2")
          .holding(rim_and_face(svg_line(line), 7 * unit_, 4.6 * unit_))
          .line();
    };
    std::string svg = bar({Joint::V, Joint::A}) + bar({Joint::V, Joint::B}) +
                      bar({Joint::C, Joint::A, Joint::X}) + bar({Joint::C, Joint::B, Joint::Y});
    const PictureBox box = extent_.box();
    LabelPlacer placer({box.centre, box.half + Point::Constant(margin_)}, unit_);
    for (const auto& [from, to] : {std::pair{Joint::V, Joint::A},
                                   {Joint::V, Joint::B},
                                   {Joint::A, Joint::C},
                                   {Joint::A, Joint::X},
                                   {Joint::B, Joint::C},
                                   {Joint::B, Joint::Y}})
      placer.avoid((*pose)[from], (*pose)[to], 3.5 * unit_);
    for (const Joint joint : all_joints) placer.avoid({(*pose)[joint], Point::Constant(5 * unit_)});
    for (const Joint joint : all_joints) svg += joint_svg(joint, (*pose)[joint], placer);
    return svg;
  }

  /// Knight's letters on his instrument, ours on a design.
  std::string letter_of(Joint joint) const {
    if (record_.design) return std::string(1, letter(joint));
    switch (joint) {
      case Joint::V: return "E";
      case Joint::A: return "B";
      case Joint::B: return "D";
      case Joint::C: return "C";
      case Joint::X: return "A";
      case Joint::Y: break;
    }
    return "F";
  }

  std::string joint_svg(Joint joint, const Point& at, LabelPlacer& placer) const {
    const Mounting& mounting = record_.setups.front().mounting;
    const char* role = joint == mounting.pole     ? "mark pole"
                       : joint == mounting.input  ? "mark tracer"
                       : joint == mounting.output ? "mark pen"
                                                  : "pin";
    const Point words = placer.place_around(at, 5 * unit_, Point(6, 8) * unit_, Point(0, 1));
    const SvgElement letter = svg_words("letter", words).saying(letter_of(joint));
    return svg_disc(role, at, 5 * unit_).text() +
           SvgElement("g").with("class", "words").holding(letter.text()).line();
  }

  /// A shaft and two barbs as one open path.
  std::string arrow_path(const Vector& vector) const {
    const Point tip = vector.at + magnification_ * vector.error;
    const double length = (tip - vector.at).norm();
    std::string path = svg_line({vector.at, tip});
    if (length < 3 * unit_) return path;
    const Complex back = as_complex(vector.at - tip) / length * std::min(7 * unit_, 0.6 * length);
    return path + svg_line({tip + as_point(back * std::polar(1.0, 0.45)), tip,
                            tip + as_point(back * std::polar(1.0, -0.45))});
  }

  std::string arrows() const {
    const bool before = which_ == ErrorVectors::before;
    std::string svg = "\n";
    for (const Vector& vector : field_)
      svg += SvgElement("path")
                 .with("class", "curve worst")
                 .with("opacity", ".3")
                 .with("stroke-width", "1")
                 .with("d", arrow_path(vector))
                 .with("vector-effect", "non-scaling-stroke")
                 .line();
    const double target = record_.measurements.fit.target * magnification_;
    for (std::size_t i = 0; i < vectors_.size(); ++i) {
      const Vector& vector = vectors_[i];
      if (!before)
        svg += svg_disc("m-target", vector.at, target)
                   .with("fill", "none")
                   .with("stroke", "currentColor")
                   .with("stroke-opacity", ".3")
                   .with("vector-effect", "non-scaling-stroke")
                   .line();
      const SvgElement title =
          SvgElement("title").saying(record_.measurements.readings[record_.readings[i].reading].name + ": " +
                                     length_text(vector.error.norm()));
      svg += svg_shape(before || vector.outlier ? "curve worst" : "curve rss", arrow_path(vector))
                 .with("vector-effect", "non-scaling-stroke")
                 .holding(title.text())
                 .line();
      svg += svg_disc("core pen", vector.at, 2.4 * unit_).line();
    }
    return SvgElement("g").holding(svg).line();
  }

  /// Two scales: of the table, and of the arrows.
  std::string key(const Point& at) const {
    const double table = round_down(140 * unit_), error = round_down(140 * unit_ / magnification_);
    const auto bar = [&](double x, double length, const std::string& words) {
      const Point from(x, at.y()), tick(0, 4 * unit_);
      const std::string line = svg_line({from, from + Point(length, 0)}) +
                               svg_line({from - tick, from + tick}) +
                               svg_line({from + Point(length, 0) - tick, from + Point(length, 0) + tick});
      return svg_shape("scale-bar", line).text() + SvgElement("text")
                                                       .with("class", "tick strong")
                                                       .with("x", x + 0.5 * length)
                                                       .with("y", -at.y() + 20 * unit_)
                                                       .saying(words)
                                                       .line();
    };
    return SvgElement("g")
        .with("class", "m-scale")
        .holding("\n" + bar(at.x(), table, "table " + length_text(table)) +
                 bar(at.x() + 220 * unit_, error * magnification_, "arrows " + length_text(error)))
        .line();
  }

  const CalibrationRecord& record_;
  ErrorVectors which_;
  std::vector<Vector> vectors_, field_;
  PictureExtent extent_;
  double unit_ = 1, margin_ = 0, magnification_ = 1;
};

}  // namespace

VectorPicture vector_picture(const CalibrationRecord& record, ErrorVectors which) {
  return record.readings.empty() ? VectorPicture{} : ErrorVectorPicture(record, which).draw();
}

}  // namespace kempe
