// The module's functions, one binding each: values in, values out, no exception and no formula.
//
// engine.js gives them the shape that engine.d.ts describes: default arguments, and a catch around
// each call for what only JavaScript sees, a trap.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <new>
#include <nlohmann/json.hpp>

#include "apps/web/engine/answering.hpp"
#include "apps/web/engine/catalogue_json.hpp"
#include "apps/web/engine/js_values.hpp"
#include "apps/web/engine/load_work.hpp"
#include "apps/web/engine/search_session.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/catalogue/spec_schema.hpp"
#include "gearwright/job/result_schema.hpp"
#include "gearwright/spec/edit_text.hpp"

namespace gearwright::web {

namespace {

using emscripten::val;

val failed(const Error& error, const SpecText* text = nullptr, const GivenKeys& given = {}) {
  return parsed(refusal(error, text, given));
}

// What work gives, or a Failed.
template <class Work>
val guarded(const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return failed({"", "", "out of memory; a coarser tolerance or fewer teeth would help"});
  } catch (const std::exception& e) {
    return failed({"", "", e.what()});
  }
}
template <class Work>
std::string guarded_text(const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return refusal({"", "", "out of memory; a coarser tolerance or fewer teeth would help"});
  } catch (const std::exception& e) {
    return refusal({"", "", e.what()});
  }
}

// Turns a value of a session into JavaScript's, its error with the line in the session's text.
template <class T, class Show>
val shown(const Session& session, const Result<T>& result, const Show& show) {
  if (result) return show(*result);
  return failed(result.error(), &session.text(), session.job().spec.given);
}

val text_or_failed(const Result<std::string>& text, const SpecText* of = nullptr) {
  return text ? val(*text) : failed(text.error(), of);
}

// What a page holds on to.
struct SessionDoor {
  std::shared_ptr<Session> at;

  int gears() const { return at->gears(); }
  bool has_pair() const { return at->has_pair(); }
  std::string json(const std::string& verb) const {
    return guarded_text([&] { return at->json(verb); });
  }
  val section(int gear, double tolerance) const {
    return guarded([&] { return shown(*at, at->section(gear, tolerance), section_val); });
  }
  val mesh(int gear, double tolerance) const {
    return guarded([&] { return shown(*at, at->mesh(gear, tolerance), mesh_val); });
  }
  val lines() const {
    return guarded([&] { return shown(*at, at->lines(), lines_val); });
  }
  val pose(int gear, double rotation1_deg, bool nominal) const {
    return guarded(
        [&] { return shown(*at, at->pose(gear, rotation1_deg, nominal), copied<double>); });
  }
  val contact_curve(int positions) const {
    return guarded([&] { return shown(*at, at->contact_curve(positions), curve_val); });
  }
  val contact_point(double rotation1_deg) const {
    return guarded([&] { return shown(*at, at->contact_point(rotation1_deg), parsed); });
  }
  val gap_map(double rotation1_deg, int k, int rows, int columns) const {
    return guarded([&] {
      return shown(*at, at->gap_map(rotation1_deg, k, {rows, columns}), raster_val);
    });
  }
  val pattern(int positions, int rows, int columns) const;
  val error_map(const std::string& x, double x_from, double x_to, int nx, const std::string& y,
                double y_from, double y_to, int ny, int positions) const;
  val load(const std::string& accuracy) const;
  val shift_region() const {
    return guarded([&] { return shown(*at, at->shift_region(), chart_val); });
  }
  val file(const std::string& kind, int gear, double tolerance) const {
    return guarded([&] {
      return shown(*at, at->file(kind, gear, tolerance),
                   [](const std::string& bytes) { return copied(bytes); });
    });
  }
};

struct PatternDoor {
  std::shared_ptr<Session> session;
  std::shared_ptr<PatternWork> at;
  val step(double) const {
    return guarded([&] { return shown(*session, at->step(), steps_val); });
  }
  val result() const {
    return guarded([&] {
      if (!at->result()) return val::null();
      val both = val::array();
      for (const FlankRaster& r : *at->result()) both.call<void>("push", raster_val(r));
      return both;
    });
  }
};

struct ErrorMapDoor {
  std::shared_ptr<Session> session;
  std::shared_ptr<ErrorMapWork> at;
  val step(double milliseconds) const {
    return guarded([&] { return shown(*session, at->step(milliseconds), steps_val); });
  }
  val result() const {
    return guarded([&] {
      val o = val::object();
      o.set("x", copied(at->result().x));
      o.set("y", copied(at->result().y));
      o.set("peakToPeakArcsec", copied(at->result().peak_to_peak_arcsec));
      return o;
    });
  }
};

val SessionDoor::pattern(int positions, int rows, int columns) const {
  return guarded([&] {
    const RasterSize size{rows, columns};
    if (positions < 2 || rows < 2 || columns < 2 || positions > 1024 || rows * columns > 1'000'000)
      return failed({"", "", "a pattern has 2 to 1024 positions and 2 x 2 to 10^6 nodes"});
    return val(PatternDoor{at, std::make_shared<PatternWork>(at, positions, size)});
  });
}

val SessionDoor::error_map(const std::string& x, double x_from, double x_to, int nx,
                           const std::string& y, double y_from, double y_to, int ny,
                           int positions) const {
  return guarded([&] {
    const auto work =
        ErrorMapWork::begin(at, {x, x_from, x_to, nx}, {y, y_from, y_to, ny}, positions);
    return shown(*at, work, [&](const auto& made) { return val(ErrorMapDoor{at, made}); });
  });
}

struct LoadDoor {
  std::shared_ptr<Session> session;
  std::shared_ptr<LoadWork> at;
  val step(double milliseconds) const {
    return guarded([&] { return shown(*session, at->step(milliseconds), steps_val); });
  }
  val result() const {
    return guarded([&] {
      if (!at->picture()) return val::null();
      val o = load_val(*at->picture());
      o.set("json", at->json());
      return o;
    });
  }
};

val SessionDoor::load(const std::string& accuracy) const {
  return guarded([&] {
    std::optional<ComplianceAccuracy> wanted;
    if (accuracy == "draft") wanted = ComplianceAccuracy::draft;
    if (accuracy == "full") wanted = ComplianceAccuracy::full;
    const auto work = LoadWork::begin(at, wanted);
    return shown(*at, work, [&](const auto& made) { return val(LoadDoor{at, made}); });
  });
}

struct SearchDoor {
  std::shared_ptr<SearchSession> at;
  double trials() const { return static_cast<double>(at->trials()); }
  val step(double milliseconds) const {
    return guarded([&] { return steps_val(at->step(milliseconds)); });
  }
  val result() const {
    return guarded([&] {
      val o = val::object();
      o.set("json", at->json());
      o.set("tested", static_cast<double>(at->tested()));
      o.set("feasible", static_cast<double>(at->feasible()));
      return o;
    });
  }
  std::string best(int most) const {
    return guarded_text([&] { return at->best(most); });
  }
  val take(int design) const {
    return guarded([&] { return text_or_failed(at->take(design)); });
  }
  val report() const {
    return guarded([&] {
      const auto page = at->report();
      return page ? copied(*page) : failed(page.error());
    });
  }
};

val open_session(const std::string& text) {
  return guarded([&] {
    const auto session = Session::open(text);
    if (session) return val(SessionDoor{*session});
    const SpecText of = spec_text(text);
    return failed(session.error(), &of);
  });
}

val open_search(const std::string& text, int most) {
  return guarded([&] {
    const auto session = SearchSession::open(text, most);
    if (session) return val(SearchDoor{*session});
    const SpecText of = spec_text(text);
    return failed(session.error(), &of);
  });
}

std::string run(const std::string& verb, const std::string& spec) {
  return guarded_text([&] { return answer(verb, spec); });
}

std::string schema(const std::string& of) {
  return of == "spec" ? spec_schema() : json_text(result_schema(), 2) + "\n";
}

val to_toml_val(const std::string& json) {
  return guarded([&] {
    const SpecText of{"", json, SpecFormat::json};
    return text_or_failed(to_toml(json), &of);
  });
}
val to_json_val(const std::string& toml) {
  return guarded([&] {
    const SpecText of{"", toml};
    return text_or_failed(to_json_text(toml), &of);
  });
}
val edit_val(const std::string& toml, const std::string& key, const std::string& value) {
  return guarded([&] {
    const SpecText of{"", toml};
    return text_or_failed(with_key(toml, key, value), &of);
  });
}

std::string version() { return std::string(kVersion); }

}  // namespace

EMSCRIPTEN_BINDINGS(gearwright) {
  using emscripten::class_;
  emscripten::function("version", &version);
  emscripten::function("run", &run);
  emscripten::function("schema", &schema);
  emscripten::function("catalogue", &catalogue_json);
  emscripten::function("toToml", &to_toml_val);
  emscripten::function("toJson", &to_json_val);
  emscripten::function("edit", &edit_val);
  emscripten::function("open", &open_session);
  emscripten::function("openSearch", &open_search);
  class_<SessionDoor>("Session")
      .property("gears", &SessionDoor::gears)
      .property("hasPair", &SessionDoor::has_pair)
      .function("json", &SessionDoor::json)
      .function("section", &SessionDoor::section)
      .function("mesh", &SessionDoor::mesh)
      .function("lines", &SessionDoor::lines)
      .function("pose", &SessionDoor::pose)
      .function("contactCurve", &SessionDoor::contact_curve)
      .function("contactPoint", &SessionDoor::contact_point)
      .function("gapMap", &SessionDoor::gap_map)
      .function("pattern", &SessionDoor::pattern)
      .function("errorMap", &SessionDoor::error_map)
      .function("load", &SessionDoor::load)
      .function("shiftRegion", &SessionDoor::shift_region)
      .function("file", &SessionDoor::file);
  class_<PatternDoor>("Pattern")
      .function("step", &PatternDoor::step)
      .function("result", &PatternDoor::result);
  class_<ErrorMapDoor>("ErrorMap")
      .function("step", &ErrorMapDoor::step)
      .function("result", &ErrorMapDoor::result);
  class_<LoadDoor>("Load").function("step", &LoadDoor::step).function("result", &LoadDoor::result);
  class_<SearchDoor>("Search")
      .property("trials", &SearchDoor::trials)
      .function("step", &SearchDoor::step)
      .function("result", &SearchDoor::result)
      .function("best", &SearchDoor::best)
      .function("take", &SearchDoor::take)
      .function("report", &SearchDoor::report);
}

}  // namespace gearwright::web
