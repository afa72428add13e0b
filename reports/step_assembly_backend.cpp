// STEP by OpenCASCADE. The plain STEP writer serves, its products named afterwards: the one that writes names itself
// draws OpenCASCADE's display libraries into every start of the program.

#include <unistd.h>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_PropertyDefinition.hxx>
#include <StepShape_ShapeDefinitionRepresentation.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeMapper.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pnt.hxx>

#include "reports/design_drawing.hpp"
#include "reports/part_drawings.hpp"
#include "reports/step_assembly.hpp"
#include "specs/text_file.hpp"

namespace kempe {
namespace {

gp_Pnt raised(const Point& point, double z) { return {point.x(), point.y(), z}; }

gp_Circ circle_about(const Point& centre, double radius, double z) {
  return {gp_Ax2(raised(centre, z), gp_Dir(0, 0, 1)), radius};
}

/// An edge of the outline; an arc through its middle point's circle.
TopoDS_Edge edge(const ArcVertex& from, const Point& to, double z) {
  if (from.bulge == 0) return BRepBuilderAPI_MakeEdge(raised(from.at, z), raised(to, z));
  const Complex a = as_complex(from.at), b = as_complex(to);
  const Complex centre =
      0.5 * (a + b) + Complex(0, 1) * (b - a) * (1 - from.bulge * from.bulge) / (4 * from.bulge);
  gp_Circ arc = circle_about(as_point(centre), std::abs(a - centre), z);
  if (from.bulge < 0)
    arc = gp_Circ(gp_Ax2(raised(as_point(centre), z), gp_Dir(0, 0, -1)), std::abs(a - centre));
  return BRepBuilderAPI_MakeEdge(arc, raised(from.at, z), raised(to, z));
}

TopoDS_Shape solid(const CutPart& part, const Placement& placement, double z) {
  const ArcRing ring = placed(part.outline, placement);
  BRepBuilderAPI_MakeWire outline;
  for (std::size_t i = 0; i < ring.size(); ++i) outline.Add(edge(ring[i], ring[(i + 1) % ring.size()].at, z));
  BRepBuilderAPI_MakeFace face(outline.Wire(), Standard_True);
  for (const CutPart::Hole& hole : part.holes) {
    const gp_Circ rim = circle_about(placed(hole.centre, placement), 0.5 * part.hole_diameter, z);
    TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(rim));
    wire.Reverse();
    face.Add(wire);
  }
  return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, part.thickness));
}

/// Where a part lies in the assembly: its first two holes on their joints.
Placement in_pose(const CutPart& part, const Pose& pose) {
  const Complex drawn = as_complex(part.holes[1].centre - part.holes[0].centre);
  const Complex there = as_complex(pose[part.holes[1].joint] - pose[part.holes[0].joint]);
  const double turn = std::arg(there / drawn);
  return {pose[part.holes[0].joint] - as_point(as_complex(part.holes[0].centre) * std::polar(1.0, turn)),
          turn};
}

/// OpenCASCADE tells its progress on stdout, which belongs to the program's own output.
class Quiet {
 public:
  Quiet() : messenger_(Message::DefaultMessenger()), printers_(messenger_->Printers()) {
    messenger_->ChangePrinters().Clear();
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
  ~Quiet() { messenger_->ChangePrinters() = printers_; }

 private:
  Handle(Message_Messenger) messenger_;
  Message_SequenceOfPrinters printers_;
};

/// Named solids, written as the products of one assembly.
class Assembly {
 public:
  Assembly() { builder_.MakeCompound(whole_); }

  void add(const std::string& name, const TopoDS_Shape& shape) {
    builder_.Add(whole_, shape);
    named_.push_back({name, shape});
  }

  bool write(const std::filesystem::path& path) {
    const Quiet quiet;
    STEPControl_Writer writer;  // before the settings: its first one makes the defaults
    Interface_Static::SetCVal("write.step.unit", "MM");
    Interface_Static::SetIVal("write.step.assembly", 1);
    if (writer.Transfer(whole_, STEPControl_AsIs) != IFSelect_RetDone) return false;
    set_name(writer, whole_, "copying linkage");
    for (const auto& [name, shape] : named_) set_name(writer, shape, name);
    name_uses(writer);
    APIHeaderSection_MakeHeader header(writer.Model());
    header.SetName(new TCollection_HAsciiString("assembly.step"));
    // The same design gives the same bytes: no time of writing.
    header.SetTimeStamp(new TCollection_HAsciiString("2000-01-01T00:00:00"));
    return writer.Write(path.c_str()) == IFSelect_RetDone;
  }

 private:
  static void set_name(STEPControl_Writer& writer, const TopoDS_Shape& shape, const std::string& name) {
    const Handle(Transfer_FinderProcess) transfer = writer.WS()->TransferWriter()->FinderProcess();
    Handle(StepShape_ShapeDefinitionRepresentation) shown;
    if (!transfer->FindTypedTransient(TransferBRep::ShapeMapper(transfer, shape),
                                      STANDARD_TYPE(StepShape_ShapeDefinitionRepresentation), shown))
      return;
    const Handle(StepBasic_Product) product =
        shown->Definition().PropertyDefinition()->Definition().ProductDefinition()->Formation()->OfProduct();
    product->SetId(new TCollection_HAsciiString(name.c_str()));
    product->SetName(new TCollection_HAsciiString(name.c_str()));
  }

  /// OpenCASCADE numbers the uses of parts by a counter of the whole process; here they begin at 1 and bear
  /// their parts' names.
  static void name_uses(STEPControl_Writer& writer) {
    const Handle(StepData_StepModel) model = writer.Model();
    int number = 0;
    for (int i = 1; i <= model->NbEntities(); ++i) {
      const auto use = Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model->Value(i));
      if (use.IsNull()) continue;
      use->SetId(new TCollection_HAsciiString(std::to_string(++number).c_str()));
      use->SetName(use->RelatedProductDefinition()->Formation()->OfProduct()->Name());
    }
  }

  BRep_Builder builder_;
  TopoDS_Compound whole_;
  std::vector<std::pair<std::string, TopoDS_Shape>> named_;
};

void add_cylinder(Assembly& assembly, const std::string& name, const Point& at, double diameter,
                  double bottom, double top) {
  assembly.add(name, BRepPrimAPI_MakeCylinder(gp_Ax2(raised(at, bottom), gp_Dir(0, 0, 1)), 0.5 * diameter,
                                              top - bottom));
}

void add_pins(Assembly& assembly, const Design& design, const Pose& pose) {
  const CopyingLinkage& linkage = design.linkage;
  const double thickness = design.style.thickness;
  for (const Joint joint : all_joints) {
    int lowest = design.layers.highest(), highest = 0;
    for (const Link link : all_links)
      if (has_joint(link, joint)) {
        lowest = std::min(lowest, design.layers[link]);
        highest = std::max(highest, design.layers[link]);
      }
    const std::string role = joint == linkage.pole_joint()     ? "pole post "
                             : joint == linkage.tracer_joint() ? "tracer "
                             : joint == linkage.pen_joint()    ? "pen "
                                                               : "pin ";
    const double bottom = role == "pin " ? (lowest - 1) * thickness : 0;  // posts reach down to the table
    add_cylinder(assembly, role + letter(joint), pose[joint], design.style.pin_diameter, bottom,
                 highest * thickness);
  }
}

tl::expected<std::string, std::string> written(Assembly& assembly) {
  // OpenCASCADE writes to files only.
  std::error_code none;
  std::string pattern = (std::filesystem::temp_directory_path(none) / "kempe-XXXXXX.step").string();
  const int file = ::mkstemps(pattern.data(), 5);
  if (file < 0) return tl::unexpected(std::string("no temporary file for STEP"));
  ::close(file);
  const bool done = assembly.write(pattern);
  auto text = read_text_file(pattern);
  std::filesystem::remove(pattern, none);
  if (!done || !text) return tl::unexpected(std::string("OpenCASCADE wrote no STEP"));
  return std::move(*text);
}

}  // namespace

bool can_write_step() { return true; }

tl::expected<std::string, std::string> step_assembly(const Design& design, const CuttingSpec& cutting) {
  try {
    Assembly assembly;
    const Pose pose = assembly_pose(design);
    for (const CutPart& part : cut_parts(design, cutting))
      assembly.add(part.name, solid(part, in_pose(part, pose), (part.layer - 1) * part.thickness));
    add_pins(assembly, design, pose);
    return written(assembly);
  } catch (const Standard_Failure& failure) {
    return tl::unexpected(std::string("OpenCASCADE: ") + failure.GetMessageString());
  }
}

}  // namespace kempe
