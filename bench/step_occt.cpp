#include "bench/step_occt.hpp"

#include <fmt/format.h>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <Standard_Failure.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <mutex>
#include <sstream>
#include <utility>

#include "bench/step_solid.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {
namespace {

constexpr const char* kUs = "Gearwright";
// A file says what it holds, not when it was made: same gears, same bytes.
constexpr const char* kTime = "1970-01-01T00:00:00";

// The kernel keeps its settings in statics, so one document at a time. Its messengers print to
// stdout, which belongs to the program.
void set_up_kernel() {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Controller::Init();  // before it the settings would be ignored without a word
  GW_ENSURES(Interface_Static::SetCVal("write.step.schema", "AP242DIS"));
  GW_ENSURES(Interface_Static::SetCVal("write.step.unit", "MM"));
  GW_ENSURES(Interface_Static::SetIVal("write.step.assembly", 2));  // as the document is built
}

gp_Trsf placement(const Eigen::Isometry3d& pose) {
  const auto m = pose.matrix();
  gp_Trsf result;
  result.SetValues(m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3), m(2, 0),
                   m(2, 1), m(2, 2), m(2, 3));
  return result;
}

void set_name(const TDF_Label& label, const std::string& name) {
  TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), Standard_True));
}

struct Part {
  std::string name;
  Eigen::Isometry3d pose;
  TopoDS_Solid solid;
};

void fill(const Handle(TDocStd_Document) & document, const std::vector<Part>& parts,
          const std::string& name) {
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  if (parts.size() == 1 && parts[0].pose.matrix() == Eigen::Matrix4d::Identity()) {
    set_name(shapes->AddShape(parts[0].solid, Standard_False), parts[0].name);
    return;
  }
  const TDF_Label assembly = shapes->NewShape();
  set_name(assembly, name);
  for (const Part& part : parts) {
    const TDF_Label label = shapes->AddShape(part.solid, Standard_False);
    set_name(label, part.name);
    const TopLoc_Location location(placement(part.pose));
    set_name(shapes->AddComponent(assembly, label, location), part.name);
  }
  shapes->UpdateAssemblies();
}

Handle(TCollection_HAsciiString) ascii(const std::string& text) {
  return new TCollection_HAsciiString(text.c_str());
}

void write_header(const Handle(StepData_StepModel) & model, const std::string& file_name) {
  APIHeaderSection_MakeHeader header(model);
  header.SetName(ascii(file_name));
  header.SetTimeStamp(ascii(kTime));
  header.SetAuthorValue(1, ascii(kUs));
  header.SetOrganizationValue(1, ascii(kUs));
  header.SetOriginatingSystem(ascii(kUs));
  header.SetAuthorisation(ascii(""));
  header.SetDescriptionValue(1, ascii("toothed bodies, mm"));
}

// The kernel numbers assembly links from a counter that outlives the document; here they count from
// 1 in every file.
void number_links(const Handle(StepData_StepModel) & model) {
  int link = 0;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto usage = Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model->Value(i));
    if (!usage.IsNull()) usage->SetId(ascii(std::to_string(++link)));
  }
}

std::string text_of(const std::vector<Part>& parts, const std::string& file_name) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  set_up_kernel();
  const Handle(XCAFApp_Application) application = XCAFApp_Application::GetApplication();
  Handle(TDocStd_Document) document;
  application->NewDocument("BinXCAF", document);
  fill(document, parts, std::filesystem::path(file_name).stem().string());

  STEPCAFControl_Writer writer;
  writer.SetNameMode(Standard_True);
  GW_ENSURES(writer.Transfer(document, STEPControl_AsIs));
  const Handle(XSControl_WorkSession) session = writer.ChangeWriter().WS();
  const auto model = Handle(StepData_StepModel)::DownCast(session->Model());
  write_header(model, file_name);
  number_links(model);
  StepData_StepWriter printer(model);
  printer.SendModel(Handle(StepData_Protocol)::DownCast(session->Protocol()));
  std::ostringstream stream;
  GW_ENSURES(printer.Print(stream));
  application->Close(document);
  return std::move(stream).str();
}

Result<StepDocument> make_document(const std::vector<ToothedBody>& bodies,
                                   const std::string& file_name) {
  StepReport report;
  std::vector<Part> parts;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const ToothedBody& body = bodies[i];
    const auto of_body = [&](Error error) { return within(body.name, std::move(error)); };
    const auto walls = make_walls(body);
    if (!walls) return of_body(walls.error());
    const std::size_t faces =
        walls->teeth.walls.size() * static_cast<std::size_t>(walls->teeth.slices);
    if (faces > kMaxStepFaces) {
      return of_body(
          {"faces", fmt::format("{}", faces),
           fmt::format("a STEP solid of {} faces; the most is {}: fewer teeth{} would help", faces,
                       kMaxStepFaces,
                       walls->teeth.slices > 1 ? ", a narrower face or a longer lead" : "")});
    }
    auto made = make_solid(body);
    if (!made) return of_body(made.error());
    for (StepFace face : made->faces) {
      face.body = i;
      report.max_deviation_mm = std::max(report.max_deviation_mm, face.max_deviation_mm);
      report.faces.push_back(face);
    }
    report.volume_mm3 += metal_area(body) * body.face_width;
    report.face_count += made->face_count;
    report.edge_count += made->edge_count;
    if (made->face_count <= 1000 && !BRepCheck_Analyzer(made->solid).IsValid()) {
      return of_body(
          {"faces", fmt::format("{}", faces), "the CAD kernel's check refuses the solid"});
    }
    parts.push_back({body.name, body.pose, made->solid});
  }
  return StepDocument{text_of(parts, file_name), std::move(report)};
}

}  // namespace

Result<StepDocument> occt_step_document(const std::vector<ToothedBody>& bodies,
                                        const std::string& file_name) {
  GW_EXPECTS(!bodies.empty());
  try {
    return make_document(bodies, file_name);
  } catch (const Standard_Failure& failure) {
    // The kernel's exceptions are of no standard kind; out of memory is the usual one.
    throw IoError(std::string("the CAD kernel gave up: ") + failure.DynamicType()->Name() + " " +
                  failure.GetMessageString());
  }
}

}  // namespace gearwright
