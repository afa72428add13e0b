// The module that writes STEP by OpenCASCADE. The plain STEP writer serves, its products named afterwards: the one that
// writes names itself draws in OpenCASCADE's display libraries.

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
#include <cmath>
#include <complex>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pnt.hxx>

#include "reports/drawings/step_module.hpp"

namespace kempe {
namespace {

using Complex = std::complex<double>;

gp_Pnt raised(const Complex& at, double z) { return {at.real(), at.imag(), z}; }

gp_Circ circle_about(const Complex& centre, double radius, double z, double axis = 1) {
  return {gp_Ax2(raised(centre, z), gp_Dir(0, 0, axis)), radius};
}

/// An edge of the outline; an arc through its middle point's circle.
TopoDS_Edge edge(const StepCorner& from, const StepCorner& to, double z) {
  const Complex a(from.x, from.y), b(to.x, to.y);
  const double bulge = from.bulge;
  if (bulge == 0) return BRepBuilderAPI_MakeEdge(raised(a, z), raised(b, z));
  const Complex centre = 0.5 * (a + b) + Complex(0, 1) * (b - a) * (1 - bulge * bulge) / (4 * bulge);
  const gp_Circ arc = circle_about(centre, std::abs(a - centre), z, bulge < 0 ? -1 : 1);
  return BRepBuilderAPI_MakeEdge(arc, raised(a, z), raised(b, z));
}

TopoDS_Shape solid(const StepPlate& plate) {
  const auto& ring = plate.outline;
  BRepBuilderAPI_MakeWire outline;
  for (std::size_t i = 0; i < ring.size(); ++i)
    outline.Add(edge(ring[i], ring[(i + 1) % ring.size()], plate.bottom));
  BRepBuilderAPI_MakeFace face(outline.Wire(), Standard_True);
  for (const StepHole& hole : plate.holes) {
    const gp_Circ rim = circle_about({hole.x, hole.y}, 0.5 * hole.diameter, plate.bottom);
    TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(rim));
    wire.Reverse();
    face.Add(wire);
  }
  return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, plate.top - plate.bottom));
}

TopoDS_Shape solid(const StepCylinder& cylinder) {
  const gp_Ax2 axis(raised({cylinder.x, cylinder.y}, cylinder.bottom), gp_Dir(0, 0, 1));
  return BRepPrimAPI_MakeCylinder(axis, 0.5 * cylinder.diameter, cylinder.top - cylinder.bottom);
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
  explicit Assembly(std::string name) : name_(std::move(name)) { builder_.MakeCompound(whole_); }

  void add(const std::string& name, const TopoDS_Shape& shape) {
    builder_.Add(whole_, shape);
    named_.push_back({name, shape});
  }

  bool write(const char* file) {
    const Quiet quiet;
    STEPControl_Writer writer;  // before the settings: its first one makes the defaults
    Interface_Static::SetCVal("write.step.unit", "MM");
    Interface_Static::SetIVal("write.step.assembly", 1);
    if (writer.Transfer(whole_, STEPControl_AsIs) != IFSelect_RetDone) return false;
    set_name(writer, whole_, name_);
    for (const auto& [name, shape] : named_) set_name(writer, shape, name);
    name_uses(writer);
    APIHeaderSection_MakeHeader header(writer.Model());
    header.SetName(new TCollection_HAsciiString("assembly.step"));
    // The same design gives the same bytes: no time of writing.
    header.SetTimeStamp(new TCollection_HAsciiString("2000-01-01T00:00:00"));
    return writer.Write(file) == IFSelect_RetDone;
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

  std::string name_;
  BRep_Builder builder_;
  TopoDS_Compound whole_;
  std::vector<std::pair<std::string, TopoDS_Shape>> named_;
};

bool write_step(const StepParts& parts, const char* file, std::string& fault) {
  try {
    Assembly assembly(parts.name);
    for (const StepPlate& plate : parts.plates) assembly.add(plate.name, solid(plate));
    for (const StepCylinder& cylinder : parts.cylinders) assembly.add(cylinder.name, solid(cylinder));
    if (assembly.write(file)) return true;
    fault = "the file could not be written";
  } catch (const Standard_Failure& failure) {
    fault = failure.GetMessageString();
  }
  return false;
}

}  // namespace
}  // namespace kempe

extern "C" __attribute__((visibility("default"))) bool kempe_write_step(const kempe::StepParts& parts,
                                                                        const char* file,
                                                                        std::string& fault) {
  return kempe::write_step(parts, file, fault);
}
