#include "gearwright/catalogue/drive_quantities.hpp"

#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/contact_quantities.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/drive/drive_forces.hpp"

namespace gearwright {

namespace {

constexpr const char* kMotion = "Motion";
constexpr const char* kPower = "Power";
constexpr const char* kGeometry = "Geometry";

bool flows(const Drive& d) { return d.flow && !d.flow->self_locking(); }

Value rating_of(const DriveMeshView& v) {
  const auto record = mesh_rating(*v.drive, v.mesh);
  return record ? Value(*record) : Value();
}

template <class View, class List>
ValueMap by_name(const Quantities<View>& quantities, const Drive& d, const List& list) {
  ValueMap map;
  for (std::size_t i = 0; i < list.size(); ++i)
    map.emplace_back(list[i].name, Value(quantities.of({&d, i})));
  return map;
}

ValueMap shifts_of(const Drive& d) {
  ValueMap map;
  for (std::size_t g = 0; g < d.graph.gears.size(); ++g)
    if (const auto& x = d.geometry.shift[g]) map.emplace_back(d.graph.gears[g].name, Value(*x));
  return map;
}

// Returns the centre distance of the first mesh of the first planetary set. Returns none if the
// drive has no set, or if the set has no geometry.
std::optional<double> set_distance(const Drive& d) {
  if (d.sets.empty() || d.sets.front().group.meshes.empty()) return std::nullopt;
  return d.geometry.distance[d.sets.front().group.meshes.front()];
}

// These functions convert the motion of a body, which is given in rad. rotation() returns the
// rotation of a body that turns, and none for a rack. travel() returns the travel of a rack in mm,
// and none for a body that turns. `lever` is DriveError::lever.
std::optional<Angle> rotation(double motion, const std::optional<double>& lever) {
  return lever ? std::nullopt : std::optional(Angle::radians(motion));
}
std::optional<double> travel(double motion, const std::optional<double>& lever) {
  return lever ? std::optional(*lever * motion) : std::nullopt;
}

const Quantities<DriveBacklash>& drive_backlash_quantities() {
  using B = DriveBacklash;
  return define("drive.backlash", [](Quantities<B>& q) {
    q.number("input_deg", "backlash of the input with the output held", "",
             "[T13.20]; null for a rack",
             [](const B& b) { return rotation(b.input, b.input_lever); });
    q.number("input_mm", "backlash of the rack with the output held", "",
             "backlash along the travel of an input that is a rack",
             [](const B& b) { return travel(b.input, b.input_lever); });
    q.number("output_deg", "backlash of the output with the input held", "",
             "[T13.20]; null for a rack",
             [](const B& b) { return rotation(b.output, b.output_lever); });
    q.number("output_mm", "backlash of the rack with the input held", "",
             "backlash along the travel of an output that is a rack",
             [](const B& b) { return travel(b.output, b.output_lever); });
  });
}

const Quantities<DriveError>& drive_error_quantities() {
  using E = DriveError;
  return define("drive.transmission_error", [](Quantities<E>& q) {
    q.number("output_arcsec_peak_to_peak", "transmission error of the output", "",
             "greatest value minus least value; for several mesh frequencies, the sum of these "
             "differences [T13.21]",
             [](const E& e) {
               return e.lever ? Value() : Value(Angle::radians(e.peak_to_peak).arcsec());
             })
        .unit(Unit::arcsec);
    q.number("output_peak_to_peak_um", "transmission error of the rack", "",
             "transmission error along the travel of an output that is a rack",
             [](const E& e) { return travel(kUmPerMm * e.peak_to_peak, e.lever); });
    q.record<drive_error_line_quantities>("lines", "harmonics of the mesh frequencies [T13.22]",
                                          error_lines)
        .doors(kJson);
  });
}

const PlanetSet* first_set(const Drive& d) { return d.sets.empty() ? nullptr : &d.sets.front(); }

Value locks(const std::optional<PowerFlow>& flow) {
  return flow ? Value(flow->self_locking()) : Value();
}
Value efficiency_of(const std::optional<PowerFlow>& flow) {
  if (!flow) return {};
  return flow->self_locking() ? Value(0.0) : Value(flow->efficiency);
}

void add_motion(Quantities<Drive>& q) {
  q.under(kMotion);
  q.term("ratio", "n_in/n_out, signed; null with several inputs [T13.3]",
         [](const Drive& d) { return d.motion.ratio ? Value(d.motion.ratio->value()) : Value(); });
  q.term("ratio_exact", "[p, q] in lowest terms",
         [](const Drive& d) { return d.motion.ratio ? exact_fraction(*d.motion.ratio) : Value(); })
      .fraction()
      .doors(kJson | kListing)
      .shown([](const Drive& d) { return d.motion.ratio && !d.motion.ratio->whole(); });
  q.whole("degrees_of_freedom", "degrees of freedom", "f", "[T13.2]",
          [](const Drive& d) { return d.motion.freedom; });
  q.whole("period_input_turns", "period in turns of the input", "",
          "number of turns after which all bodies are again in their initial positions [T13.5]",
          [](const Drive& d) -> Value {
            if (!d.motion.period) return {};
            const auto turns = d.motion.period->numerator();
            return turns ? Value(*turns) : Value();
          });
}

void add_power(Quantities<Drive>& q) {
  q.under(kPower);
  q.term("efficiency",
         "if the input drives, including the losses of the teeth; 0 if the drive is self-locking "
         "[T13.9]",
         [](const Drive& d) { return efficiency_of(d.flow); });
  q.term("efficiency_backward", "0 if the output cannot drive the input",
         [](const Drive& d) { return efficiency_of(d.backward); });
  q.add(Type::flag, "self_locking", "self-locking", "", "true if the input cannot drive the output",
        [](const Drive& d) { return locks(d.flow); });
  q.add(Type::flag, "self_locking_backward", "self-locking, output driving", "",
        "true if the output cannot drive the input",
        [](const Drive& d) { return locks(d.backward); });
  q.add(Type::flag, "circulating", "circulating power", "",
        "true if a branch carries more power than the inputs supply",
        [](const Drive& d) { return flows(d) ? Value(d.flow->circulating) : Value(); });
}

void add_drive(Quantities<Drive>& q) {
  q.groups({kMotion, kPower, kGeometry});
  add_motion(q);
  add_power(q);
  q.under(kGeometry);
  q.term("center_distance_mm", "for the meshes of the first set", set_distance);
  q.add(Type::map, "bodies", "bodies", "", "speeds, torque and power of each body, by name",
        [](const Drive& d) { return by_name(drive_body_quantities(), d, d.graph.bodies); })
      .doors(kJson);
  q.add(Type::map, "meshes", "meshes", "", "frequency, losses and pair of each mesh, by name",
        [](const Drive& d) { return by_name(drive_mesh_quantities(), d, d.graph.meshes); })
      .doors(kJson);
  q.record<assembly_quantities>(
       "assembly", "positions of the planets of the first set; null without planets", first_set)
      .doors(kJson);
  q.record<coaxial_quantities>(
       "coaxial", "centre distance and profile shifts of the first set; null without a set",
       [](const Drive& d) { return d.sets.empty() ? nullptr : &d; })
      .doors(kJson);
  q.record<phasing_quantities>("phasing", "relative phases of the meshes of the first set",
                               first_set)
      .doors(kJson);
  q.record<drive_backlash_quantities>(
      "backlash",
      "backlash of input and output; null with several inputs, with redundant meshes, or if a mesh "
      "between input and output has no geometry",
      &Drive::backlash);
  q.record<drive_error_quantities>(
      "transmission_error",
      "rotation error of the output while the input rotates uniformly; 0 if there are no "
      "modifications and no [errors]. The value is null for a drive with several inputs or with "
      "redundant meshes. It is also null if the output is moved by a mesh without geometry or with "
      "lost contact, by a rack with several pinions or with errors of its teeth, or by a measured "
      "gear that is loaded on the flank without readings",
      &Drive::error);
  q.record<drive_load_quantities>("load", "the drive under load; only with `[load]`")
      .when([](const Drive& d) { return d.loaded.has_value(); })
      .doors(kJson);
  q.record<drive_quantities>(
       "stages", "the stages of a train, each as a separate drive; null for other drives",
       [](const Drive& d) { return d.stages.empty() ? nullptr : &d.stages; })
      .list({0})
      .doors(kJson);
}

}  // namespace

const Quantities<DriveErrorLine>& drive_error_line_quantities() {
  using L = DriveErrorLine;
  return define("drive.transmission_error.line", [](Quantities<L>& q) {
    q.number("frequency_ratio", "waves per turn of the input", "", "",
             [](const L& l) { return l.line->frequency_ratio; });
    q.number("arcsec", "amplitude", "", "amplitude of the rotation of the output; null for a rack",
             [](const L& l) {
               return l.lever ? Value() : Value(Angle::radians(l.line->amplitude).arcsec());
             })
        .unit(Unit::arcsec);
    q.number("amplitude_um", "amplitude of the rack", "",
             "amplitude of the travel of an output that is a rack",
             [](const L& l) { return travel(kUmPerMm * l.line->amplitude, l.lever); });
  });
}

std::vector<DriveErrorLine> error_lines(const DriveError& error) {
  std::vector<DriveErrorLine> lines;
  for (const DriveError::Line& line : error.lines) lines.push_back({&line, error.lever});
  return lines;
}

const Quantities<DriveBodyView>& drive_body_quantities() {
  using V = DriveBodyView;
  return define("drive.body", [](Quantities<V>& q) {
    q.number("speed_ratio", "speed ratio", "",
             "absolute speed divided by the speed of the first input; for a rack, pitches per turn "
             "of the input",
             [](const V& v) { return v.drive->speed_ratio(v.body); });
    q.whole("speed_ratio_exact", "exact speed ratio", "", "[p, q]; null with several inputs",
            [](const V& v) -> Value {
              if (v.drive->graph.inputs.size() != 1) return {};
              return exact_fraction(v.drive->motion.speeds[v.body][0]);
            })
        .fraction()
        .doors(kJson);
    q.number("travel_per_input_turn_mm", "travel per turn of the input", "",
             "travel of a rack while the first input turns once, computed with the module of its "
             "pinion; null for a body that turns",
             [](const V& v) -> Value {
               const auto pitch = v.drive->rack_pitch(v.body);
               const auto pitches = v.drive->speed_ratio(v.body);
               return pitch && pitches ? Value(*pitch * *pitches) : Value();
             });
    q.number("relative_speed_ratio", "speed ratio relative to the carrier", "",
             "speed ratio of the body minus the speed ratio of the carrier in whose frame the body "
             "meshes; equal to the speed ratio if the body meshes in the frame of the housing",
             [](const V& v) { return v.drive->relative_speed_ratio(v.body); })
        .shown([](const V& v) { return !v.drive->sets.empty(); });
    const auto turns = [](const V& v) { return !v.drive->graph.moves(v.body); };
    q.term("speed_rpm", "absolute speed; null for a rack", [turns](const V& v) -> Value {
      return turns(v) ? Value(v.drive->speed_rpm(v.body)) : Value();
    });
    q.number("speed_m_per_s", "speed of the rack", "v",
             "computed with the module of its pinion; null for a body that turns",
             [](const V& v) { return v.drive->linear_speed(v.body); });
    q.number("torque_ratio", "torque ratio", "",
             "external torque divided by the torque of the first input; for a rack, F p_t/2π "
             "replaces its torque",
             [](const V& v) {
               return flows(*v.drive) ? Value(v.drive->flow->torque[v.body]) : Value();
             });
    q.number("torque_Nm", "external torque", "T", "null for a rack", [turns](const V& v) -> Value {
      if (!turns(v) || !flows(*v.drive) || !v.drive->graph.torque_Nm) return {};
      return v.drive->flow->torque[v.body] * *v.drive->graph.torque_Nm;
    });
    q.number("force_N", "external force on the rack", "F", "null for a body that turns",
             [](const V& v) { return v.drive->force(v.body); });
    const auto forces = [&q](const char* key, const char* words, const char* symbol,
                             const char* meaning, double (*value)(const BodyForces&)) {
      q.number(key, words, symbol, meaning, [value](const V& v) -> Value {
        const auto found = body_forces(*v.drive, v.body);
        return found ? Value(value(*found)) : Value();
      });
    };
    forces("radial_force_N", "radial force of the teeth", "F_r",
           "resultant of all meshes of the body; for planets, the value of a single planet "
           "[T13.31]; null without torque_Nm",
           [](const BodyForces& f) { return f.radial; });
    forces("axial_force_N", "axial force of the teeth", "F_z",
           "sum over all meshes of the body along +z; for planets, the value of a single planet "
           "[T13.31]; null without torque_Nm",
           [](const BodyForces& f) { return f.axial; });
    forces("tilting_moment_Nm", "tilting moment of the axial forces", "M",
           "moment of the axial forces of the teeth about an axis perpendicular to the axis of the "
           "body; for planets, the value of a single planet [T13.31]; null without torque_Nm",
           [](const BodyForces& f) { return newton_metres(f.tilting); });
    const auto play = [&q](const char* deg, const char* mm, const char* words,
                           std::size_t (*held)(const DriveGraph&)) {
      q.number(deg, words, "",
               "rotation of the body between the two contacts of the teeth [T13.20]; null for a "
               "rack, or if the `backlash` of the drive is null",
               [held](const V& v) -> std::optional<Angle> {
                 if (v.drive->lever(v.body)) return std::nullopt;
                 const auto motion = v.drive->play(v.body, held(v.drive->graph));
                 return motion ? std::optional(Angle::radians(*motion)) : std::nullopt;
               });
      q.number(mm, words, "",
               "travel of a rack between the two contacts of the teeth; null for a body that turns",
               [held](const V& v) -> std::optional<double> {
                 const auto lever = v.drive->lever(v.body);
                 if (!lever) return std::nullopt;
                 const auto motion = v.drive->play(v.body, held(v.drive->graph));
                 return motion ? travel(*motion, lever) : std::nullopt;
               });
    };
    play("backlash_input_held_deg", "backlash_input_held_mm", "backlash with the input held",
         [](const DriveGraph& graph) { return graph.inputs.front(); });
    play("backlash_output_held_deg", "backlash_output_held_mm", "backlash with the output held",
         [](const DriveGraph& graph) { return graph.output; });
    q.term("power_kW", "> 0 if the power flows into the drive", [](const V& v) -> Value {
      const auto n = v.drive->speed_rpm(v.body);
      if (!flows(*v.drive) || !v.drive->graph.torque_Nm || !n) return {};
      return kilowatts(v.drive->flow->torque[v.body] * *v.drive->graph.torque_Nm, *n);
    });
  });
}

const Quantities<DriveMeshView>& drive_mesh_quantities() {
  using V = DriveMeshView;
  return define("drive.mesh", [](Quantities<V>& q) {
    q.text("frame", "name of the carrier in whose frame the gears roll, or `housing`",
           [](const V& v) {
             const auto frame = v.drive->graph.frame(v.drive->graph.meshes[v.mesh]);
             return frame ? v.drive->graph.bodies[*frame].name : std::string("housing");
           });
    q.term("frequency_ratio", "|z (n − n_c)| [T13.4]",
           [](const V& v) { return v.drive->frequency_ratio(v.mesh); });
    q.number(
         "phases", "phases of the planets", "γ",
         "phase, in periods, by which the mesh of each planet follows the mesh of the first "
         "planet; given only for meshes of planets with a central gear, otherwise null [T13.16]",
         [](const V& v) { return phase_list(v.drive->phases(v.mesh)); })
        .list({0});
    q.number("frequency_hz", "mesh frequency", "f", "", [](const V& v) -> Value {
      const auto teeth = v.drive->frequency_ratio(v.mesh);
      const auto n = v.drive->speed_rpm(v.drive->graph.inputs.front());
      if (!teeth || !n) return {};
      return *teeth * std::abs(*n) / 60.0;
    });
    q.term("efficiency", "efficiency with the frame at rest", [](const V& v) -> Value {
      const auto& eta = v.drive->efficiencies[v.mesh];
      if (!eta) return {};
      const bool second = flows(*v.drive) && v.drive->flow->driver[v.mesh] == 1;
      return second ? eta->second_drives : eta->first_drives;
    });
    q.text("driver",
           "the gear that drives the other gear in the frame of the mesh; null if the mesh carries "
           "no power",
           [](const V& v) -> Value {
             if (!flows(*v.drive) || v.drive->flow->driver[v.mesh] < 0) return {};
             const DriveMesh& mesh = v.drive->graph.meshes[v.mesh];
             return v.drive->graph.gear(mesh, v.drive->flow->driver[v.mesh]).name;
           });
    q.number("power_ratio", "rolling power", "",
             "P_m/P_in in the frame of the mesh, at the driving gear", [](const V& v) -> Value {
               if (!flows(*v.drive) || !(v.drive->flow->power_in > 0.0)) return {};
               return v.drive->flow->mesh_power[v.mesh] / v.drive->flow->power_in;
             });
    const auto forces = [&q](const char* key, const char* words, const char* symbol,
                             const char* meaning, double (*value)(const MeshForces&)) {
      q.number(key, words, symbol, meaning, [value](const V& v) -> Value {
        const auto found = mesh_forces(*v.drive, v.mesh);
        return found ? Value(value(*found)) : Value();
      });
    };
    forces("tangential_force_N", "tangential force", "F_t",
           "force on the first gear in one copy of the mesh, at the working pitch circle; > 0 "
           "counter-clockwise seen from +z [T13.29]; null without torque_Nm",
           [](const MeshForces& f) { return f.tangential; });
    forces("separating_force_N", "separating force", "F_r",
           "radial force on each gear in one copy of the mesh [T13.29]; null without torque_Nm",
           [](const MeshForces& f) { return f.separating; });
    forces("axial_force_N", "axial force", "F_z",
           "force on the first gear in one copy of the mesh, along +z [T13.29]; null without "
           "torque_Nm",
           [](const MeshForces& f) { return f.axial; });
    q.record<pair_quantities>(
         "pair", "the two gears as mounted; null without geometry",
         [](const V& v) -> const auto& { return v.drive->geometry.pairs[v.mesh]; })
        .doors(kJson);
    q.record<rack_pair_quantities>(
         "rack_pair", "the pinion and its rack as mounted; only for a mesh with a rack",
         [](const V& v) -> const auto& { return v.drive->geometry.racks[v.mesh]; })
        .when([](const V& v) { return v.drive->geometry.racks[v.mesh].has_value(); })
        .doors(kJson);
    q.record<contact_quantities>(
         "contact",
         "tooth contact of the mesh, as the verb `contact` computes it for the pair that `--take` "
         "prints; only with `[errors]` or `[contact]`, and always with the verb `run`; null if no "
         "teeth touch or if the teeth cannot be mounted",
         [](const V& v) -> const auto& { return v.drive->analyses[v.mesh]; })
        .when([](const V& v) { return !v.drive->analyses.empty(); })
        .doors(kJson);
    q.record<rating_quantities>(
         "rating", "rating of one copy of the mesh; only with the verb `rate`; null without power",
         rating_of)
        .when([](const V& v) { return !v.drive->ratings.empty(); })
        .doors(kJson);
  });
}

Value exact_fraction(const Rational& r) {
  const auto p = r.numerator(), q = r.denominator();
  if (!p || !q) return {};
  return ValueList{Value(*p), Value(*q)};
}

const Quantities<Drive>& coaxial_quantities() {
  return define("drive.coaxial", [](Quantities<Drive>& q) {
    q.term("center_distance_mm", "for the meshes of the first set [T13.15]", set_distance);
    q.add(Type::map, "profile_shift", "profile shifts", "x",
          "per gear, as given or as computed from the centre distance [T13.15]", shifts_of)
        .doors(kJson);
  });
}

const Quantities<Drive>& drive_quantities() { return define<add_drive>("drive"); }

std::optional<ValueRecord> mesh_rating(const Drive& drive, std::size_t mesh) {
  const auto& made = drive.ratings[mesh];
  if (!made) return std::nullopt;
  return rating_quantities().of({*made});
}

}  // namespace gearwright
