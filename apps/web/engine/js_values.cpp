#include "apps/web/engine/js_values.hpp"

#include <variant>

namespace gearwright::web {

using emscripten::val;

namespace {

// What `each` makes of the items.
template <class Items, class Each>
val list_of(const Items& items, Each each) {
  val list = val::array();
  for (const auto& item : items) list.call<void>("push", each(item));
  return list;
}

template <class Items>
val list_of(const Items& items) {
  return list_of(items, [](const auto& item) { return item; });
}

}  // namespace

val copied(const std::string& bytes) {
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  return val(emscripten::typed_memory_view(bytes.size(), data)).call<val>("slice");
}

val parsed(const std::string& json) { return val::global("JSON").call<val>("parse", json); }

val raster_val(const FlankRaster& r) {
  val o = val::object();
  o.set("diameter", copied(r.diameter));
  o.set("height", copied(r.height));
  o.set("gap", copied(r.gap));
  return o;
}

val steps_val(const Steps& s) {
  val o = val::object();
  o.set("done", static_cast<double>(s.done));
  o.set("of", static_cast<double>(s.of));
  o.set("finished", s.finished);
  return o;
}

val section_val(const Section& s) {
  val o = val::object();
  o.set("teeth", s.teeth);
  o.set("internal", s.internal);
  o.set("outline", copied(s.outline));
  o.set("pieces", list_of(s.pieces, [](const Section::Piece& p) {
          val piece = val::object();
          piece.set("name", p.name);
          piece.set("tooth", p.tooth);
          piece.set("land", p.land);
          piece.set("from", p.from);
          piece.set("to", p.to);
          return piece;
        }));
  o.set("bore", copied(s.bore));
  o.set("circles", list_of(s.circles, [](const Section::Circle& c) {
          val circle = val::object();
          circle.set("key", c.key);
          circle.set("symbol", c.symbol);
          circle.set("words", c.words);
          circle.set("radius", c.radius);
          return circle;
        }));
  o.set("toleranceMm", s.tolerance);
  return o;
}

val mesh_val(const Mesh& m) {
  val o = val::object();
  o.set("positions", copied(m.positions));
  o.set("normals", copied(m.normals));
  o.set("indices", copied(m.indices));
  o.set("toleranceMm", m.tolerance);
  return o;
}

val lines_val(const MeshLines& l) {
  val o = val::object();
  o.set("kind", l.kind);
  o.set("centerDistance", l.center_distance);
  o.set("shaftAngleDeg", l.shaft_angle_deg);
  o.set("lineOfAction", copied(l.line_of_action));
  o.set("trailingLine", copied(l.trailing_line));
  o.set("pathOfContact", copied(l.path_of_contact));
  o.set("points", list_of(l.points, [](const MeshLines::Mark& m) {
          val point = val::object();
          point.set("name", m.name);
          point.set("x", m.at[0]);
          point.set("y", m.at[1]);
          point.set("z", m.at[2]);
          return point;
        }));
  return o;
}

val curve_val(const ContactCurve& c) {
  val o = val::object(), columns = val::object(), width = val::object();
  for (const auto& [key, column] : c.columns) {
    width.set(key, column.width);
    if (const auto* numbers = std::get_if<Numbers>(&column.values)) {
      columns.set(key, copied(*numbers));
    } else {
      columns.set(key, list_of(std::get<std::vector<std::string>>(column.values)));
    }
  }
  o.set("n", c.n);
  o.set("columns", columns);
  o.set("width", width);
  o.set("peakToPeakArcsec", c.peak_to_peak_arcsec);
  o.set("meanSlope", c.mean_slope);
  o.set("harmonicsArcsec", copied(c.harmonics_arcsec));
  o.set("contactLost", c.contact_lost);
  o.set("words", c.words);
  return o;
}

val chart_val(const ShiftChart& c) {
  val o = val::object(), borders = val::object();
  for (const auto& [name, words] : c.borders) borders.set(name, words);
  o.set("point", list_of(c.point));
  o.set("inside", c.inside);
  o.set("margin", c.margin);
  o.set("stoppedBy", c.stopped_by);
  o.set("area", c.area);
  o.set("pieces", list_of(c.pieces, [](const auto& loop) {
          return list_of(loop, [](const ShiftChart::Border& b) {
            val border = val::object();
            border.set("border", b.name);
            border.set("points", copied(b.points));
            return border;
          });
        }));
  o.set("borders", borders);
  o.set("window", list_of(c.window));
  o.set("chosen", c.chosen.empty() ? val::null() : list_of(c.chosen));
  o.set("whatKills", c.what_kills);
  return o;
}

val load_val(const LoadPicture& p) {
  val o = val::object();
  o.set("height", copied(p.height));
  o.set("torques", list_of(p.torques, [](const LoadPicture::Torque& t) {
          val torque = val::object();
          torque.set("stiffness", copied(t.stiffness));
          torque.set("teeth", list_of(t.teeth, [](const LoadPicture::Tooth& tooth) {
                       val one = val::object();
                       one.set("pair", tooth.pair);
                       one.set("share", copied(tooth.share));
                       one.set("pressure", copied(tooth.pressure));
                       one.set("diameter1", copied(tooth.diameter_1));
                       one.set("diameter2", copied(tooth.diameter_2));
                       return one;
                     }));
          return torque;
        }));
  return o;
}

}  // namespace gearwright::web
