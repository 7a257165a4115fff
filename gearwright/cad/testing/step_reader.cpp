#include "gearwright/cad/testing/step_reader.hpp"

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_CheckIterator.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <sstream>

namespace gearwright::testing {
namespace {

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return "";
  const TCollection_ExtendedString& text = name->Get();
  std::string utf8(static_cast<std::size_t>(text.LengthOfCString()), '\0');
  char* begin = utf8.data();
  text.ToUTF8CString(begin);
  return utf8;
}

void add_part(ReadStep& result, const TDF_Label& part, const Handle(XCAFDoc_ColorTool) & colours) {
  result.names.push_back(name_of(part));
  Quantity_Color colour;
  std::array<double, 3> rgb{-1.0, -1.0, -1.0};
  if (colours->GetColor(part, XCAFDoc_ColorSurf, colour) ||
      colours->GetColor(part, XCAFDoc_ColorGen, colour))
    rgb = {colour.Red(), colour.Green(), colour.Blue()};
  result.colours.push_back(rgb);
}

}  // namespace

ReadStep read_step(const std::string& text) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const Handle(XCAFApp_Application) application = XCAFApp_Application::GetApplication();
  Handle(TDocStd_Document) document;
  application->NewDocument("BinXCAF", document);
  STEPCAFControl_Reader reader;
  reader.SetNameMode(Standard_True);
  reader.SetColorMode(Standard_True);
  ReadStep result;
  std::istringstream stream(text);
  if (reader.ChangeReader().ReadStream("gear.step", stream) != IFSelect_RetDone ||
      !reader.Transfer(document)) {
    result.refusals = 1;
    return result;
  }
  Interface_CheckIterator checks = reader.Reader().WS()->ModelCheckList(Standard_True);
  for (checks.Start(); checks.More(); checks.Next())
    result.refusals += checks.Value()->NbFails() + checks.Value()->NbWarnings();
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
  TDF_LabelSequence free;
  shapes->GetFreeShapes(free);
  result.free_shapes = free.Length();
  if (free.IsEmpty()) return result;
  const TDF_Label root = free.Value(1);
  TDF_LabelSequence components;
  if (XCAFDoc_ShapeTool::GetComponents(root, components)) {
    result.names.push_back(name_of(root));
    for (int i = 1; i <= components.Length(); ++i) {
      TDF_Label part;
      if (XCAFDoc_ShapeTool::GetReferredShape(components.Value(i), part))
        add_part(result, part, colours);
    }
  } else {
    add_part(result, root, colours);
  }
  result.shape = XCAFDoc_ShapeTool::GetShape(root);
  for (TopExp_Explorer solid(result.shape, TopAbs_SOLID); solid.More(); solid.Next())
    result.solids.push_back(TopoDS::Solid(solid.Current()));
  application->Close(document);
  return result;
}

double volume(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-10);
  return properties.Mass();
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found.Extent();
}

}  // namespace gearwright::testing
