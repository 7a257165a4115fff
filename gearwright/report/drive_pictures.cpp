#include "gearwright/report/drive_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/drive_figures.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/rack_mesh.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/page_parts.hpp"

namespace gearwright {

namespace {

constexpr double kSectionEdge = 12.0;  // px, margin of a section
// px, least width of a section that is taller than it is wide.
constexpr double kLeastWidth = 320.0;
// Greatest shown length of a rack to either side of its pinion, in tip radii of the pinion.
constexpr double kBarRadii = 8.0;
constexpr double kPhaseTall = 0.82;    // height of a picture divided by its width
constexpr double kPhaseModules = 6.5;  // modules, size of the area in a picture of a phase
// Teeth per second in the fastest mesh while the gears turn.
constexpr double kTeethPerSecond = 1.2;
constexpr int kSliderSteps = 240;  // number of positions of the slider

// Returns the angle by which a body turns during the motion, while t runs from 0 to 1. The angle is
// in degrees, positive clockwise as in SVG. `ratio` is the speed of the body divided by the speed
// of the input.
double turn_of(double ratio, double input_turns) { return -360.0 * ratio * input_turns; }

class Pictures {
 public:
  Pictures(const Drive& drive, const DriveLayout& layout, UnitSystem units)
      : drive_(drive), graph_(drive.graph), layout_(layout), units_(units) {
    const auto alike = turns_until_alike(drive);
    const auto swayed = turns_of_racks();
    sways_ = swayed.has_value();
    turns_ = sways_ ? *swayed : alike ? alike->value() : 1.0;
    Bounds all;
    for (const PlacedGear& p : layout.gears) {
      if (const RackPair* rack = rack_pair_of(drive, p.gear)) {
        cover_bar(*rack, p, all);
        continue;
      }
      const Vec2 r = Vec2::Constant(drawn_radius(*drive.geometry.gears[p.gear]));
      all.cover(p.axis - r);
      all.cover(p.axis + r);
      // Planets move, so the picture contains the whole circle on which they move.
      if (const auto carrier = graph_.bodies[graph_.gears[p.gear].body].carrier) {
        const Vec2 about = layout.places.axes[*carrier];
        const Vec2 reach = r + Vec2::Constant((p.axis - about).norm());
        all.cover(about - reach);
        all.cover(about + reach);
      }
    }
    const double px = all.size().maxCoeff() / (kWideFigure - 2 * kSectionEdge);  // mm per px
    width_ = std::clamp(all.size().x() / px + 2 * kSectionEdge, kLeastWidth, kWideFigure);
    const Vec2 half(width_ / 2 * px, all.size().y() / 2 + kSectionEdge * px);
    const Vec2 middle = (all.lo + all.hi) / 2;
    window_ = {middle - half, middle + half};
  }

  std::string all() {
    std::string figures;
    for (std::size_t k = 0; k < layout_.sections.size(); ++k) figures += section(k);
    return "<div class=\"figures drive\">\n" + figures + phases() + "</div>\n";
  }

 private:
  double ratio(std::size_t body) const { return drive_.speed_ratio(body).value_or(0.0); }
  std::size_t body_of(const PlacedGear& placed) const { return graph_.gears[placed.gear].body; }
  // Returns the distance, mm, that a rack moves in the direction along_rack() while t runs from 0
  // to 1.
  double travel_of(const PlacedGear& rack) const {
    return -ratio(body_of(rack)) * turns_ * drive_.rack_pitch(body_of(rack)).value_or(0.0);
  }

  // Returns the turns of the input during the motion of a drive with racks. The motion is one turn
  // of the input, or less if a rack would move by more than half its length. If the input is a
  // rack, only the lengths of the racks limit the motion. Returns none without a rack.
  std::optional<double> turns_of_racks() const {
    std::optional<double> turns;
    for (const PlacedGear& p : layout_.gears) {
      const RackPair* rack = rack_pair_of(drive_, p.gear);
      if (!rack) continue;
      if (!turns) turns = graph_.moves(graph_.inputs.front()) ? kInfinity : 1.0;
      if (const double pitches = std::abs(ratio(body_of(p))); pitches > 0.0)
        turns = std::min(*turns, rack->rack.teeth / (2 * pitches));
    }
    // If there are several inputs without speeds, the speed ratios of the racks are unknown, and
    // the lengths of the racks do not limit the turns.
    if (turns && !std::isfinite(*turns)) turns = 1.0;
    return turns;
  }

  // Extends `all` so that it contains a rack in every position of its motion. The rack moves to
  // both sides of its drawn position. The ends of a long rack may stay outside `all`.
  void cover_bar(const RackPair& rack, const PlacedGear& p, Bounds& all) const {
    const Vec2 along = along_rack(p), up(along.y(), -along.x());
    const Vec2 foot = layout_.places.axes[body_of(p)];
    const double most = kBarRadii * rack.pinion.tip_diameter / 2;
    const double half =
        rack.rack.teeth * rack.rack.transverse_pitch / 2 + std::abs(travel_of(p)) / 2;
    const double middle = (p.axis - foot).dot(along);
    for (const double x : {-rack.rack.height, rack.rack.addendum})
      for (const double end : {middle - half, middle + half})
        all.cover(foot + x * up + std::clamp(end, -most, most) * along);
  }

  void add_rack(Figure& f, const RackPair& rack, std::size_t placed, double height) const {
    const PlacedGear& p = layout_.gears[placed];
    const Vec2 at = layout_.axis_at(drive_, placed, height);
    FigureMark bar{FigureMark::Kind::shape,
                   "part " + body_style(body_of(p)),
                   {at, at + travel_of(p) * along_rack(p)},
                   shape_name(p.gear)};
    bar.radius = outline_unit_mm(rack.pinion);
    bar.turned = kDegPerRad * p.angle;
    f.marks.push_back(std::move(bar));
  }

  // Draws a gear whose axis is at the point `at`. `relative` is the speed of the gear within
  // its group, divided by the speed of the input.
  void add_gear(Figure& f, std::size_t placed, double height, const Vec2& at, double turned,
                double relative, int group = -1) {
    const PlacedGear& p = layout_.gears[placed];
    const Gear& gear = *drive_.geometry.gears[p.gear];
    const std::string style = body_style(graph_.gears[p.gear].body);
    if (has_outline(gear)) {
      f.marks.push_back({FigureMark::Kind::shape, "part " + style, {at}, shape_name(p.gear)});
      FigureMark& shape = f.marks.back();
      shape.radius = outline_unit_mm(gear);
      shape.turned = kDegPerRad * (layout_.angle_at(drive_, placed, height) + turned);
      shape.per_pitch = turn_of(relative, turns_);
    } else {
      f.circle(at, gear.tip_diameter / 2, "stick " + style, -1);
    }
    f.marks.back().group = group;
  }

  // Internal gears are drawn first, so that the gears inside them cover their rims.
  std::vector<std::size_t> drawn_order(const DriveSection& section) const {
    std::vector<std::size_t> order = section.gears;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return graph_.gears[layout_.gears[a].gear].is_ring() &&
             !graph_.gears[layout_.gears[b].gear].is_ring();
    });
    return order;
  }

  std::string section(std::size_t k) {
    const DriveSection& section = layout_.sections[k];
    Figure f = plane_figure(fmt::format("section-{}", k + 1),
                            "In section" + (k == 0 ? "" : fmt::format(" {}", k + 1)),
                            "All gears of this section in their places, true to scale, with all "
                            "planets.",
                            window_);
    f.caption = fmt::format(
        ", true to scale{}.",
        layout_.sections.size() > 1 ? fmt::format(", at z = {} mm", fixed(section.height, 1)) : "");
    std::set<std::size_t> carriers;
    for (const std::size_t i : drawn_order(section)) {
      const std::size_t body = body_of(layout_.gears[i]);
      if (const RackPair* rack = rack_pair_of(drive_, layout_.gears[i].gear)) {
        add_rack(f, *rack, i, section.height);
        continue;
      }
      if (const auto carrier = graph_.bodies[body].carrier) {
        carriers.insert(*carrier);
        continue;
      }
      add_gear(f, i, section.height, layout_.gears[i].axis, 0.0, ratio(body));
    }
    for (const std::size_t carrier : carriers) add_carrier(f, section, carrier);
    for (std::size_t b = 0; b < graph_.bodies.size(); ++b)
      if (!graph_.bodies[b].carrier && !graph_.moves(b)) f.cross(layout_.places.axes[b]);
    add_keys(f, section, carriers);
    return figure_html(in_units(units_, std::move(f)), width_, "", k == 0 ? control() : "");
  }

  // Adds the planets in a group that turns with the carrier, and a line from the axis of the
  // carrier to the axis of each planet.
  void add_carrier(Figure& f, const DriveSection& section, std::size_t carrier) {
    const int group = static_cast<int>(f.groups.size());
    const Vec2 center = layout_.places.axes[carrier];
    f.groups.push_back({center, turn_of(ratio(carrier), turns_)});
    std::vector<Vec2> pins;
    for (const std::size_t i : section.gears) {
      const std::size_t body = body_of(layout_.gears[i]);
      if (graph_.bodies[body].carrier != carrier) continue;
      add_gear(f, i, section.height, layout_.gears[i].axis, 0.0, ratio(body) - ratio(carrier),
               group);
      pins.push_back(layout_.gears[i].axis);
    }
    for (const Vec2& at : pins) {
      f.line({center, at}, "stick " + body_style(carrier));
      f.marks.back().group = group;
      f.dot(at, 4.0, "stick " + body_style(carrier));
      f.marks.back().group = group;
    }
  }

  void add_keys(Figure& f, const DriveSection& section, const std::set<std::size_t>& carriers) {
    std::set<std::size_t> said;
    for (const std::size_t i : section.gears) {
      const DriveGear& gear = graph_.gears[layout_.gears[i].gear];
      if (!said.insert(layout_.gears[i].gear).second) continue;
      const int count = graph_.bodies[gear.body].count;
      const RackPair* rack = rack_pair_of(drive_, layout_.gears[i].gear);
      const int teeth = rack ? rack->rack.teeth : std::abs(gear.teeth);
      f.keys.push_back(
          key(gear.body, fmt::format("{}{} {}{}", count > 1 ? fmt::format("{} × ", count) : "",
                                     gear.name, teeth, rack ? ", rack" : "")));
    }
    for (const std::size_t c : carriers) f.keys.push_back(key(c, graph_.bodies[c].name));
  }

  FigureKey key(std::size_t body, const std::string& words) const {
    std::string speed;
    if (graph_.is_fixed(body))
      speed = ", held";
    else if (const auto v = drive_.linear_speed(body))
      speed = fmt::format(", {:.4g} m/s", *v);
    else if (const auto n = drive_.speed_rpm(body))
      speed = fmt::format(", {}/min", fixed(*n, 1));
    return {body_style(body), words + speed};
  }

  std::string control() const {
    double teeth = 0.0;
    for (std::size_t m = 0; m < graph_.meshes.size(); ++m)
      teeth = std::max(teeth, drive_.frequency_ratio(m).value_or(0.0));
    const double seconds = std::max(3.0, teeth * turns_ / kTeethPerSecond);
    // The position of the input is an angle, or a length if the input is a rack.
    const std::size_t input = graph_.inputs.front();
    const TextUnit unit(units_, "mm");
    const auto pitch = drive_.rack_pitch(input);
    const std::string shown = pitch ? " " + unit.text() : "°";
    const double least = sways_ ? -0.5 : 0.0;
    return fmt::format(
        "<div class=\"turn\" data-pitch=\"{:.12g}\" data-unit=\"{}\" data-seconds=\"{:.6g}\"{} "
        "hidden><button type=\"button\">Turn</button> <label>{} <input type=\"range\" "
        "min=\"{}\" max=\"{}\" step=\"{:.9g}\" value=\"0\"></label> "
        "<output>0.00{}</output></div>\n",
        turns_ * (pitch ? unit(*pitch) : 360.0), shown, seconds, sways_ ? " data-sways=\"\"" : "",
        escaped(graph_.bodies[input].name), least, least + 1.0, 1.0 / kSliderSteps, shown);
  }

  // Returns a picture of each planet in every mesh between planets and a central gear, for sets of
  // two or more planets. In every picture, the planet is above the central gear. A planet with
  // phase γ lags γ pitches behind the first planet.
  std::string phases() {
    std::string text;
    for (const PlanetSet& set : drive_.sets) {
      if (set.group.count < 2) continue;
      std::string pictures;
      for (const std::size_t m : set.group.meshes) {
        const DriveMesh& mesh = graph_.meshes[m];
        const bool first_rides = graph_.body(graph_.gear(mesh, 0)).carrier.has_value();
        const bool second_rides = graph_.body(graph_.gear(mesh, 1)).carrier.has_value();
        if (first_rides == second_rides) continue;
        const int central = first_rides ? 1 : 0;
        const auto list = mesh_phases(graph_.gear(mesh, central).teeth, set.assembly.turns);
        for (int copy = 0; copy < set.group.count; ++copy)
          pictures += phase(set, m, central, copy, list[static_cast<std::size_t>(copy)]);
      }
      if (pictures.empty()) continue;
      text += fmt::format(
          "<div class=\"phases\"><h3>Phases of the planets of {}</h3>\n<p>Each picture shows a "
          "planet in the frame of its carrier, turned so that the planet is at the top. The teeth "
          "of planets with equal pictures come into contact at the same time. γ is the part of a "
          "period by which the mesh of a planet lags behind the mesh of the first "
          "planet.</p>\n<div "
          "class=\"multiples\">\n{}</div>\n{}</div>\n",
          escaped(graph_.bodies[set.group.carrier].name), pictures, resultants(set));
    }
    return text;
  }

  std::string phase(const PlanetSet& set, std::size_t m, int central, int copy,
                    const Rational& gamma) {
    const DriveMesh& mesh = graph_.meshes[m];
    const std::size_t rider_gear = mesh.gears[static_cast<std::size_t>(1 - central)];
    const std::size_t central_gear = mesh.gears[static_cast<std::size_t>(central)];
    const auto find = [&](std::size_t gear, int which) {
      const auto it =
          std::find_if(layout_.gears.begin(), layout_.gears.end(),
                       [&](const PlacedGear& p) { return p.gear == gear && p.copy == which; });
      return static_cast<std::size_t>(it - layout_.gears.begin());
    };
    const std::size_t planet = find(rider_gear, copy), other = find(central_gear, 0);
    const Vec2 along = layout_.gears[planet].axis - layout_.gears[other].axis;
    const double upright = kHalfPi - std::atan2(along.y(), along.x());
    const double height =
        layout_.sections[static_cast<std::size_t>(layout_.places.mesh_slot[m])].height;
    const double sum = graph_.gears[rider_gear].teeth + graph_.gears[central_gear].teeth;
    const double pitch_radius = std::abs(along.norm() * graph_.gears[central_gear].teeth / sum);
    const double module = drive_.geometry.gears[rider_gear]->spec.normal_module;
    const Vec2 middle(0.0, pitch_radius), half = kPhaseModules / 2 * module * Vec2(1.0, kPhaseTall);
    Figure f = plane_figure(fmt::format("phase-{}-{}", m + 1, copy + 1),
                            fmt::format("{}, planet {}", mesh.name, copy + 1),
                            "The teeth of the planet and of the central gear about their pitch "
                            "point.",
                            {middle - half, middle + half});
    f.caption = fmt::format(": <var>γ</var> {}", fixed(gamma.value(), 4));
    const double carried = ratio(set.group.carrier);
    for (const bool ring : {true, false}) {
      for (const std::size_t i : {other, planet}) {
        const DriveGear& gear = graph_.gears[layout_.gears[i].gear];
        if (gear.is_ring() != ring) continue;
        const Vec2 at = i == planet ? Vec2(0.0, along.norm()) : Vec2(Vec2::Zero());
        add_gear(f, i, height, at, upright, ratio(gear.body) - carried);
      }
    }
    return figure_html(f, kSmallFigure);
  }

  static std::string resultants(const PlanetSet& set) {
    std::vector<std::vector<std::string>> rows;
    for (std::size_t k = 0; k < set.phasing.resultants.size(); ++k) {
      const Resultant& r = set.phasing.resultants[k];
      rows.push_back({fmt::format("{}", k + 1), fixed(r.torque, 4), fixed(r.force_forward, 4),
                      fixed(r.force_backward, 4)});
    }
    return value_table(
        "Resultant of each harmonic of the mesh frequency, relative to the resultant if all "
        "planets were in phase",
        {"Harmonic", "Torque, axial force", "Force turning with the sun",
         "Force turning against the sun"},
        rows);
  }

  const Drive& drive_;
  const DriveGraph& graph_;
  const DriveLayout& layout_;
  UnitSystem units_;
  double turns_ = 1.0;  // turns of the input while t runs from 0 to 1
  bool sways_ = false;  // true if t runs from −1/2 to 1/2 and back
  double width_ = 0.0;  // px, of a section
  Bounds window_;
};

}  // namespace

std::string shape_name(std::size_t gear) { return fmt::format("gear{}", gear + 1); }

std::string rack_shape_name(const Drive& drive, std::size_t mesh) {
  const std::size_t gear = drive.graph.meshes[mesh].gears[1];
  const auto& rack = drive.geometry.racks[mesh];
  const bool is_shared = !rack || rack_pair_of(drive, gear) == &*rack;
  return is_shared ? shape_name(gear) : fmt::format("mesh{}-{}", mesh + 1, shape_name(gear));
}

std::string drive_definitions(const Drive& drive) {
  std::string shapes;
  for (std::size_t g = 0; g < drive.geometry.gears.size(); ++g)
    if (const auto& gear = drive.geometry.gears[g]) {
      shapes += gear_definition(*gear, shape_name(g));
    } else if (const RackPair* rack = rack_pair_of(drive, g)) {
      if (auto bar = rack_definition(*rack, shape_name(g))) shapes += std::move(bar).take();
    }
  for (std::size_t m = 0; m < drive.graph.meshes.size(); ++m) {
    const auto& rack = drive.geometry.racks[m];
    const std::string name = rack_shape_name(drive, m);
    if (!rack || name == shape_name(drive.graph.meshes[m].gears[1])) continue;
    if (auto bar = rack_definition(*rack, name)) shapes += std::move(bar).take();
  }
  if (shapes.empty()) return {};
  return "<svg class=\"definitions\" aria-hidden=\"true\" focusable=\"false\"><defs>\n" + shapes +
         "</defs></svg>\n";
}

std::string drive_section_figures(const Drive& drive, const DriveLayout& layout, UnitSystem units) {
  return Pictures(drive, layout, units).all();
}

}  // namespace gearwright
