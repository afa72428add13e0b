// STEP by OpenCASCADE.

#include <unistd.h>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Face.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>

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

/// A document of named shapes.
class Assembly {
 public:
  Assembly()
      : document_(new TDocStd_Document("XmlXCAF")),
        shapes_(XCAFDoc_DocumentTool::ShapeTool(document_->Main())) {
    top_ = shapes_->NewShape();
    TDataStd_Name::Set(top_, "copying linkage");
  }

  void add(const std::string& name, const TopoDS_Shape& shape) {
    const TDF_Label label = shapes_->AddShape(shape, Standard_False);
    TDataStd_Name::Set(label, name.c_str());
    TDataStd_Name::Set(shapes_->AddComponent(top_, label, TopLoc_Location()), name.c_str());
  }

  bool write(const std::filesystem::path& path) {
    shapes_->UpdateAssemblies();
    STEPCAFControl_Writer writer;
    Interface_Static::SetCVal("write.step.unit", "MM");
    if (!writer.Transfer(document_)) return false;
    APIHeaderSection_MakeHeader header(writer.ChangeWriter().Model());
    header.SetName(new TCollection_HAsciiString("assembly.step"));
    // The same design gives the same bytes: no time of writing.
    header.SetTimeStamp(new TCollection_HAsciiString("2000-01-01T00:00:00"));
    return writer.Write(path.c_str()) == IFSelect_RetDone;
  }

 private:
  Handle(TDocStd_Document) document_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  TDF_Label top_;
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
    const char* role = joint == linkage.pole_joint()     ? "pole post "
                       : joint == linkage.tracer_joint() ? "tracer "
                       : joint == linkage.pen_joint()    ? "pen "
                                                         : "pin ";
    const bool stands_on_table = role != std::string("pin ");
    add_cylinder(assembly, role + std::string(1, letter(joint)), pose[joint], design.style.pin_diameter,
                 stands_on_table ? 0 : (lowest - 1) * thickness, highest * thickness);
  }
}

tl::expected<std::string, std::string> written(Assembly& assembly) {
  // OpenCASCADE writes to files only.
  std::string pattern = (std::filesystem::temp_directory_path() / "kempe-XXXXXX.step").string();
  const int file = ::mkstemps(pattern.data(), 5);
  if (file < 0) return tl::unexpected(std::string("no temporary file for STEP"));
  ::close(file);
  const bool done = assembly.write(pattern);
  auto text = read_text_file(pattern);
  std::filesystem::remove(pattern);
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
