// The engine's plain values as JavaScript's: objects and arrays as engine.d.ts describes them.
#pragma once

#include <emscripten/val.h>

#include <string>
#include <vector>

#include "apps/web/engine/load_work.hpp"
#include "apps/web/engine/shapes.hpp"

namespace gearwright::web {

/// An array of JavaScript's own: a copy, which no growth of our memory detaches.
template <class T>
emscripten::val copied(const std::vector<T>& v) {
  return emscripten::val(emscripten::typed_memory_view(v.size(), v.data()))
      .template call<emscripten::val>("slice");
}
emscripten::val copied(const std::string& bytes);

/// JSON read.
emscripten::val parsed(const std::string& json);

emscripten::val raster_val(const FlankRaster& r);
emscripten::val steps_val(const Steps& s);
emscripten::val section_val(const Section& s);
emscripten::val mesh_val(const Mesh& m);
emscripten::val lines_val(const MeshLines& l);
emscripten::val curve_val(const ContactCurve& c);
emscripten::val chart_val(const ShiftChart& c);
emscripten::val load_val(const LoadPicture& p);

}  // namespace gearwright::web
