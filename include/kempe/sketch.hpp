#pragma once
// A design at the speed of a hand: for a spec that differs a little from one whose design is known.

#include <array>
#include <memory>
#include <optional>
#include <variant>

#include "kempe/design.hpp"
#include "kempe/export.hpp"

namespace kempe {

struct SketchedDesign;  // what is inside

/// A design found in milliseconds from one for a spec that differs a little; what a page shows while a handle is dragged.
///
/// It keeps every limit, evaluated anew, its contact and its obstacles certified, as a design of design() does. What it lacks is
/// the search: another design may be better, by proven_bound() at most. And it has no map, no verification and no files: where the
/// hand rests, call design(). A value, cheap to copy. Lengths mm, angles rad, places in the table's frame.
class KEMPE_EXPORT Sketch {
 public:
  /// Where a drag begins: the sketch that a searched design is.
  explicit Sketch(const FinishedDesign& design);

  /// True if there is a design. Without one the functions below, up to pose_with_tracer_at(), are undefined: ask first.
  explicit operator bool() const;

  Grounding grounding() const;        ///< what stands at V
  int assembly_mode() const;          ///< which usable interval of the opening, from 0
  Point pole() const;                 ///< mm
  LinkLengths lengths() const;        ///< mm
  std::array<int, 4> layers() const;  ///< of the links VA, VB, ACX, BCY; 1 is next to the table
  OpeningInterval opening() const;    ///< certified usable opening, rad
  double size() const;                ///< mm, half the perimeters of the links' hulls, summed
  double transmission_min() const;    ///< rad, smallest over the region
  double value() const;  ///< of the spec's objective: mm, rad (transmission), mm^2 (footprint) or kg (mass)
  /// Where the six points are when the tracer stands at a place, mm; or why it cannot be reached (on the pole: too near).
  std::variant<Pose, Unreachable> pose_with_tracer_at(const Point& tracer) const;

  /// No design can be better than this, in the unit of value(): proven, rounded outwards with the slack that
  /// docs/proven-bound.md states, obstacles and the linkage's contact with itself left out. Absent for objectives other than size and transmission.
  std::optional<double> proven_bound() const;
  /// True if it is proven that no design exists. Without a design and without this none was found near the last one.
  bool proven_none() const;
  /// What is wrong with the spec; then there is no design.
  const std::optional<InputError>& fault() const { return fault_; }

 private:
  friend Sketch sketch(const Spec& spec, const Sketch& previous, const Options& options);
  explicit Sketch(std::shared_ptr<const SketchedDesign> inside) : inside_(std::move(inside)) {}
  std::shared_ptr<const SketchedDesign> inside_;
  std::optional<InputError> fault_;
};

/// The sketch of a spec from that of one that differs a little. Where nothing is found the next call goes on from the last design
/// that was, and looks at one more choice of grounding, assembly mode and layers each time. Lengths of a grid or a stock, locked
/// lengths, a choice of several sections and robust designs are not sketched: the answer is then without a design, without a proof that there is none, and
/// without a fault. Of the options only time limit and stop play a part. The same arguments give the same sketch, unless
/// stopped. Source: docs/search.md, "Sketches".
KEMPE_EXPORT Sketch sketch(const Spec& spec, const Sketch& previous, const Options& options = {});

}  // namespace kempe
