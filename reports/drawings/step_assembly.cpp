#include "reports/drawings/step_assembly.hpp"

#include <complex>

#include "reports/drawings/design_drawing.hpp"
#include "reports/drawings/joint_stack.hpp"
#include "reports/drawings/part_drawings.hpp"
#include "reports/drawings/step_writer.hpp"

namespace kempe {
namespace {

/// Where a part lies in the assembly: its first two holes on their joints.
Placement in_pose(const CutPart& part, const Pose& pose) {
  const Complex drawn = as_complex(part.holes[1].centre - part.holes[0].centre);
  const Complex there = as_complex(pose[part.holes[1].joint] - pose[part.holes[0].joint]);
  const double turn = std::arg(there / drawn);
  return {pose[part.holes[0].joint] - as_point(as_complex(part.holes[0].centre) * std::polar(1.0, turn)),
          turn};
}

StepPlate plate(const CutPart& part, const Placement& placement, double raised) {
  const double bottom = raised + (part.layer - 1) * part.thickness;
  StepPlate plate{part.name, placed(part.outline, placement), {}, bottom, bottom + part.thickness};
  for (const CutPart::Hole& hole : part.holes)
    plate.holes.push_back({placed(hole.centre, placement), hole.diameter});
  return plate;
}

StepCylinder pin(const JointStack& stack, const Pose& pose, double raised) {
  const double bottom = stack.is_post ? 0 : raised + stack.from;
  return {stack.name, pose[stack.joint], stack.diameter, bottom, raised + stack.to};
}

StepParts parts_in_pose(const Design& design, const CuttingSpec& cutting) {
  StepParts parts{"copying linkage", {}, {}};
  const Pose pose = assembly_pose(design);
  const auto stacks = joint_stacks(design);
  const double raised = raised_by(stacks);
  for (const CutPart& part : cut_parts(design, finished(cutting)))
    parts.plates.push_back(plate(part, in_pose(part, pose), raised));
  for (const JointStack& stack : stacks) parts.cylinders.push_back(pin(stack, pose, raised));
  return parts;
}

}  // namespace

tl::expected<std::string, std::string> step_assembly(const Design& design, const CuttingSpec& cutting) {
  return step_text(parts_in_pose(design, cutting)).map_error([](const std::string& fault) {
    return "no parts/assembly.step: " + fault;
  });
}

}  // namespace kempe
