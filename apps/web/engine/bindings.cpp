// Makes each function of the module available in JavaScript. The functions take and return values,
// throw no exceptions and contain no formulas.
//
// The file engine.js adapts the functions to engine.d.ts. It adds default arguments, and catches
// traps in every call, because only JavaScript can detect a trap.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <functional>
#include <new>
#include <nlohmann/json.hpp>

#include "apps/web/engine/answering.hpp"
#include "apps/web/engine/catalogue_json.hpp"
#include "apps/web/engine/search_session.hpp"
#include "apps/web/engine/shapes.hpp"
#include "apps/web/engine/work.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/cad/figure_files.hpp"
#include "gearwright/catalogue/spec_schema.hpp"
#include "gearwright/figure/designs.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/spec_text.hpp"

namespace gearwright::web {

namespace {

using emscripten::val;

// Returns a typed array of JavaScript. It is a copy, which remains valid when the memory grows.
template <class T>
val array_of(const std::vector<std::uint8_t>& bytes) {
  const auto* data = reinterpret_cast<const T*>(bytes.data());
  return val(emscripten::typed_memory_view(bytes.size() / sizeof(T), data)).call<val>("slice");
}
val array_of(const Json::binary_t& row) {
  switch (static_cast<RowType>(row.subtype())) {
    case RowType::float64: return array_of<double>(row);
    case RowType::float32: return array_of<float>(row);
    case RowType::uint32: return array_of<std::uint32_t>(row);
    case RowType::uint8: return array_of<std::uint8_t>(row);
  }
  return val::null();
}

val js(const Json& tree) {
  if (tree.is_binary()) return array_of(tree.get_binary());
  if (tree.is_object()) {
    val object = val::object();
    for (const auto& [key, value] : tree.items()) object.set(key, js(value));
    return object;
  }
  if (tree.is_array()) {
    val list = val::array();
    for (const Json& value : tree) list.call<void>("push", js(value));
    return list;
  }
  if (tree.is_string()) return val(tree.get_ref<const std::string&>());
  if (tree.is_boolean()) return val(tree.get<bool>());
  return tree.is_null() ? val::null() : val(tree.get<double>());
}
val js(const std::string& json) { return val::global("JSON").call<val>("parse", json); }
val js(const FlankRaster& raster) { return js(shape(raster)); }
val js(const Steps& s) {
  return js(Json{{"done", s.done}, {"of", s.of}, {"finished", s.finished}});
}
template <class T>
val js(const std::shared_ptr<T>& handle) {
  return val(handle);
}

val failed(const Error& error, const SpecText* text = nullptr, const GivenKeys& given = {}) {
  return js(refusal(error, text, given));
}

// Converts the current exception to an error. It may be called only inside a catch block.
Error caught() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return {"", "", "out of memory; a coarser tolerance or fewer teeth would help"};
  } catch (const std::exception& e) {
    return {"", "", e.what(), FailureKind::defect};
  }
}

// Returns the result of the work. If the work fails, returns an object of the type Failed
// (engine.d.ts).
template <class Work>
val guarded(const Work& work) {
  try {
    return work();
  } catch (...) {
    return failed(caught());
  }
}
template <class Work>
std::string guarded_text(const Work& work) {
  try {
    return work();
  } catch (...) {
    return refusal(caught());
  }
}

const Session& session_of(const Session& session) { return session; }
const Session& session_of(const Work& work) { return work.session(); }

// Calls a method of a Session or a Work. Returns its result, or its error with the line in the text
// of the spec.
template <auto method, class Of, class... Arguments>
val call(Of& of, Arguments... arguments) {
  return guarded([&] {
    const auto result = std::invoke(method, of, arguments...);
    if (result) return js(*result);
    const Session& session = session_of(of);
    return failed(result.error(), &session.text(), session.job().spec.given);
  });
}

Result<FlankRaster> gap_map(Session& session, double rotation1_deg, int k, int rows, int columns) {
  return session.gap_map(rotation1_deg, k, {rows, columns});
}
Result<Json> contact_figures(Session& session, const val& of) {
  ContactFigureView view;
  view.width = of["width"].as<double>();
  view.positions = of["positions"].as<int>();
  view.index = of["index"].as<int>();
  view.curves = of["curves"].as<bool>();
  const val patterns = of["patterns"];
  const int rasters = patterns.isNull() ? 0 : patterns["length"].as<int>();
  for (int i = 0; i < rasters; ++i) {
    const val raster = patterns[i];
    const auto numbers = [&](const char* of) {
      return emscripten::convertJSArrayToNumberVector<double>(raster[of]);
    };
    view.patterns.push_back({numbers("diameter"), numbers("height"), numbers("gap")});
  }
  return session.contact_figures(view);
}
// Converts [x0, x1, y0, y1] to bounds.
std::optional<Bounds> window_of(const val& list) {
  if (list.isNull()) return std::nullopt;
  const auto ends = emscripten::convertJSArrayToNumberVector<double>(list);
  return Bounds{{ends[0], ends[2]}, {ends[1], ends[3]}};
}
Result<Json> mesh_figure(const Session& session, const val& of) {
  MeshView view;
  const std::string frame = of["frame"].as<std::string>();
  view.frame = frame == "whole"   ? MeshFrame::whole
               : frame == "flank" ? MeshFrame::flank
                                  : MeshFrame::mesh;
  view.width = of["width"].as<double>();
  view.height = of["height"].as<double>();
  view.bodies = of["bodies"].as<bool>();
  view.name = of["name"].as<std::string>();
  view.window = window_of(of["window"]);
  return session.mesh_figure(view);
}
Result<Json> shift_region(const Session& session, const val& of) {
  if (of.isNull()) return session.shift_region(std::nullopt);
  return session.shift_region(
      ShiftView{of["width"].as<double>(), of["aspect"].as<double>(), window_of(of["window"])});
}
MadeWork pattern(Session& session, int positions, int rows, int columns) {
  return pattern_work(session.shared_from_this(), positions, {rows, columns});
}
MadeWork error_map(Session& session, const val& x, const val& y, int positions) {
  const auto axis = [](const val& of) {
    return ErrorAxis{of["key"].as<std::string>(), of["from"].as<double>(), of["to"].as<double>(),
                     of["n"].as<int>()};
  };
  return error_map_work(session.shared_from_this(), {axis(x), axis(y)}, positions);
}
MadeWork load(Session& session, const std::string& accuracy,
              const std::shared_ptr<ToothTables>& tables) {
  std::optional<ComplianceAccuracy> wanted;
  if (accuracy == "draft") wanted = ComplianceAccuracy::draft;
  if (accuracy == "full") wanted = ComplianceAccuracy::full;
  return load_work(session.shared_from_this(), wanted, tables);
}
void show_in(Session& session, const std::string& unit) {
  session.show_in(unit == "in" ? UnitSystem::inch : UnitSystem::mm);
}
std::string session_json(Session& session, const std::string& verb) {
  return guarded_text([&] { return session.json(verb); });
}
val work_result(const Work& work) {
  return guarded([&] { return js(work.result()); });
}

// Converts the result of a function whose argument is a text. An error contains the line in
// this text.
template <class T>
val of_text(const Result<T>& result, const SpecText& text) {
  return result ? js(*result) : failed(result.error(), &text);
}
val of_text(const Result<std::string>& result, const SpecText& text) {
  return result ? val(*result) : failed(result.error(), &text);
}
val open_session(const std::string& text) {
  return guarded([&] {
    const SpecText of = spec_text(text);
    const auto session = Session::open(text);
    val opened = of_text(session, of);
    if (session) return opened;
    const auto spec = read(of);
    const auto finder = spec ? finder_of(*spec, session.error()) : std::string_view();
    if (!finder.empty()) opened["error"].set("finder", std::string(finder));
    return opened;
  });
}
val designs(const val& of) {
  return guarded([&] {
    const auto numbers = [](const val& list) {
      return emscripten::convertJSArrayToNumberVector<double>(list);
    };
    const auto axis = [&](const char* name) {
      const auto text = [axis = of[name]](const char* member) {
        return axis[member].as<std::string>();
      };
      const std::string better = text("better");
      return DesignAxis{{.words = text("words"), .unit = text("unit"), .symbol = text("symbol")},
                        better == "greater"   ? Better::greater
                        : better == "smaller" ? Better::smaller
                                              : Better::none};
    };
    const Numbers x = numbers(of["x"]["values"]), y = numbers(of["y"]["values"]);
    const val styles = of["styles"], names = of["names"];
    std::vector<DesignDot> dots;
    for (std::size_t i = 0; i < x.size(); ++i)
      dots.push_back({{x[i], y[i]}, styles[i].as<std::string>(), names[i].as<std::string>()});
    Figure figure = designs_figure(axis("x"), axis("y"), dots);
    figure.tall = of["tall"].as<double>();
    return js(shape(figure, of["width"].as<double>()));
  });
}
val open_search(const std::string& text, int most) {
  return guarded([&] { return of_text(SearchSession::open(text, most), spec_text(text)); });
}
val to_toml_val(const std::string& json) {
  return guarded([&] { return of_text(to_toml(json), {"", json, SpecFormat::json}); });
}
val metric_val(const std::string& text) {
  return guarded([&] { return of_text(metric(text), spec_text(text)); });
}
val to_json_val(const std::string& toml) {
  return guarded([&] { return of_text(to_json_text(toml), {"", toml}); });
}
val edit_val(const std::string& toml, const std::string& key, const std::string& value) {
  return guarded([&] { return of_text(with_key(toml, key, value), {"", toml}); });
}
std::string run(const std::string& verb, const std::string& spec) {
  return guarded_text([&] { return answered(verb, spec).json; });
}
std::string schema(const std::string& of) {
  return of == "spec" ? spec_schema() : json_text(result_schema(), 2) + "\n";
}
std::string version() { return std::string(kVersion); }

double trials(const SearchSession& search) { return static_cast<double>(search.trials()); }
val search_step(SearchSession& search, double milliseconds) {
  return guarded([&] { return js(search.step(milliseconds)); });
}
val search_result(const SearchSession& search) {
  return guarded([&] { return js(search.result()); });
}
std::string best(const SearchSession& search, int most) {
  return guarded_text([&] { return search.best(most); });
}
val take(const SearchSession& search, int design) {
  return guarded([&] {
    const auto spec = search.take(design);
    return spec ? val(*spec) : failed(spec.error());
  });
}
val report(const SearchSession& search) {
  return guarded([&] {
    const auto page = search.report();
    return page ? js(row(*page)) : failed(page.error());
  });
}
val picture_file(const std::string& svg, const std::string& title) {
  return guarded([&] { return js(row(picture_pdf(svg, title))); });
}

}  // namespace

EMSCRIPTEN_BINDINGS(gearwright) {
  using emscripten::class_;
  emscripten::function("version", &version);
  emscripten::function("run", &run);
  emscripten::function("schema", &schema);
  emscripten::function("catalogue", &catalogue_json);
  emscripten::function("toToml", &to_toml_val);
  emscripten::function("toJson", &to_json_val);
  emscripten::function("metric", &metric_val);
  emscripten::function("edit", &edit_val);
  emscripten::function("open", &open_session);
  emscripten::function("openSearch", &open_search);
  emscripten::function("designs", &designs);
  emscripten::function("picturePdf", &picture_file);
  class_<ToothTables>("ToothTables")
      .smart_ptr_constructor("ToothTablesHandle", &std::make_shared<ToothTables>);
  class_<Session>("Session")
      .smart_ptr<std::shared_ptr<Session>>("SessionHandle")
      .property("gears", &Session::gears)
      .property("hasPair", &Session::has_pair)
      .property("pitchDeg", &Session::pitch_deg)
      .function("json", &session_json)
      .function("rows", &call<&Session::rows, Session, std::string>)
      .function("showIn", &show_in)
      .function("mesh", &call<&Session::mesh, Session, int, double>)
      .function("driveSolids", &call<&Session::drive_solids, Session>)
      .function("driveFigures", &call<&Session::drive_figures, Session, double>)
      .function("driveLoadFigures", &call<&Session::drive_load_figures, Session, double>)
      .function("lines", &call<&Session::lines, Session>)
      .function("meshFigure", &call<&mesh_figure, const Session, val>)
      .function("pose", &call<&Session::pose, Session, int, double, bool>)
      .function("contactCurve", &call<&Session::contact_curve, Session, int>)
      .function("contactPoint", &call<&Session::contact_point, Session, double>)
      .function("contactFigures", &call<&contact_figures, Session, val>)
      .function("gapMap", &call<&gap_map, Session, double, int, int, int>)
      .function("pattern", &call<&pattern, Session, int, int, int>)
      .function("errorMap", &call<&error_map, Session, val, val, int>)
      .function("load", &call<&load, Session, std::string, std::shared_ptr<ToothTables>>)
      .function("scatterSketch", &call<&Session::scatter_sketch, Session, double>)
      .function("scatter", &call<&Session::scatter, Session, double>)
      .function("shiftRegion", &call<&shift_region, const Session, val>)
      .function("file", &call<&Session::file, Session, std::string, int, double>);
  class_<Work>("Work")
      .smart_ptr<std::shared_ptr<Work>>("WorkHandle")
      .function("step", &call<&Work::step, Work, double>)
      .function("figures", &call<&Work::figures, const Work, int, double>)
      .function("rows", &call<&Work::rows, const Work>)
      .function("result", &work_result);
  class_<SearchSession>("Search")
      .smart_ptr<std::shared_ptr<SearchSession>>("SearchHandle")
      .property("trials", &trials)
      .function("step", &search_step)
      .function("result", &search_result)
      .function("best", &best)
      .function("take", &take)
      .function("report", &report);
}

}  // namespace gearwright::web
