#include "gearwright/job/rexs_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/spec/rexs_file.hpp"

namespace gearwright {

namespace {

constexpr double kRigid = 1e20;  // N mm/rad, stiffness of a rigid coupling in the public samples

// Returns ρ_fP* of the rack. If the radius of a named rack does not fit, the full radius replaces
// it. The full radius is rounded down, because a file may not contain a radius that does not fit.
double fitting_radius(const CylindricalSpec& spec) {
  constexpr double kRounded = 1e12;  // 12 decimals
  const StraightRack& rack = spec.straight_rack();
  const double full =
      std::floor(full_radius(rack, spec.normal_pressure_angle) * kRounded) / kRounded;
  return rack.named ? std::min(rack.root_fillet_radius, full) : rack.root_fillet_radius;
}

class Writer {
 public:
  explicit Writer(const std::string& title) {
    model_.version = "1.7";
    model_.application = "Gearwright";
    unit_ = add("gear_unit", title.empty() ? "gear unit" : title);
  }

  std::string shaft(const std::string& name) {
    const std::string id = add("shaft", name);
    part_of_unit(id);
    return id;
  }

  /// Adds a gear on a shaft, with its flanks and its tool. Returns the id of the gear.
  std::string gear(const Gear& gear, const std::string& name, const std::string& shaft,
                   const BothFlanks& modifications) {
    const CylindricalSpec& s = gear.spec;
    const std::string id = add(gear.internal() ? "ring_gear" : "cylindrical_gear", name);
    RexsComponent& g = last();
    g.set("number_of_teeth", std::abs(s.teeth), "none");
    g.set("normal_module", s.normal_module, "mm");
    g.set("helix_angle_reference_diameter", s.helix_angle.deg(), "deg");
    g.set("face_width", s.face_width, "mm");
    g.set("tip_diameter", gear.tip_diameter, "mm");
    relate("assembly", {{"assembly", shaft}, {"part", id}});
    const std::string flank = add("cylindrical_gear_flank", name + ", flanks");
    RexsComponent& f = last();
    const double alpha = s.normal_pressure_angle.rad();
    f.set("normal_pressure_angle", s.normal_pressure_angle.deg(), "deg");
    f.set("addendum_modification_coefficient", s.profile_shift, "none");
    if (s.thickness_allowance != 0.0)
      f.set("generated_addendum_modification_coefficient",
            s.profile_shift + s.thickness_allowance / (2 * s.normal_module * std::tan(alpha)),
            "none");
    relate("flank", {{"gear", id}, {"left", flank}, {"right", flank}});
    add_tool(gear, name, flank);
    if (gear.bore) leave_out("bores");
    if (any_modification(modifications)) leave_out("flank modifications");
    return id;
  }

  void stage(const std::string& name, const std::string& gear_1, const std::string& gear_2,
             double distance) {
    const std::string id = add("cylindrical_stage", name);
    last().set("center_distance", distance, "mm");
    relate("stage", {{"stage", id}, {"gear_1", gear_1}, {"gear_2", gear_2}});
    part_of_unit(id);
  }

  /// Connects a shaft with the casing.
  void hold(const std::string& shaft) {
    if (casing_.empty()) part_of_unit(casing_ = add("gear_casing", "casing"));
    const std::string id = add("coupling", "held");
    last().set("rotational_stiffness", kRigid, "N mm / rad");
    relate("side", {{"assembly", id}, {"inner_part", shaft}, {"outer_part", casing_}});
  }

  std::string planetary_stage(const std::string& name) {
    const std::string id = add("planetary_stage", name);
    part_of_unit(id);
    return id;
  }

  /// Sets the speed of the shaft of an input. For the first input, also sets the torque.
  void input(const std::string& shaft, const std::optional<double>& torque,
             const std::optional<double>& speed) {
    for (RexsComponent& c : model_.components) {
      if (c.id != shaft) continue;
      if (speed) c.set("rotational_speed", *speed, "1 / min");
      c.flag("defines_speed");
    }
    load("input", shaft);
    if (torque) last().set("torque_around_u_axis", *torque, "N m");
    if (torque) last().flag("defines_torque");
  }
  void output(const std::string& shaft) { load("output", shaft); }

  void relate(std::string type, std::vector<std::pair<std::string, std::string>> refs) {
    model_.relations.push_back({std::move(type), std::move(refs)});
  }

  /// Adds to the note of the file that the part `what` of the spec is not in the file.
  void leave_out(const std::string& what) {
    if (note_.find(what) == std::string::npos) note_ += ", without " + what;
  }

  JobFile file(const std::filesystem::path& path) const {
    const auto back = spec_of_rexs(model_);
    const std::string other = back ? "" : "; Gearwright cannot read it: " + back.error().rule;
    return {path, "REXS", std::nullopt, "version 1.7" + note_ + other, rexs_bytes(model_, path)};
  }

 private:
  std::string add(const std::string& type, const std::string& name) {
    model_.components.push_back({std::to_string(model_.components.size() + 1), type, name});
    return model_.components.back().id;
  }
  RexsComponent& last() { return model_.components.back(); }
  void load(const std::string& name, const std::string& shaft) {
    const std::string id = add("external_load", name);
    last().flag("transmits_torque");
    relate("assembly", {{"assembly", shaft}, {"part", id}});
  }
  void part_of_unit(const std::string& id) {
    relate("assembly", {{"assembly", unit_}, {"part", id}});
  }

  // Adds the tool of a gear. The default cutter of a ring is omitted, because Gearwright uses the
  // same default cutter when it reads the file. Its root is then that of the usual rack.
  void add_tool(const Gear& gear, const std::string& name, const std::string& flank) {
    const StraightRack& rack = gear.spec.straight_rack();
    if (gear.cut_by && gear.cut_by->by_default) {
      const StraightRack usual;
      if (rack.dedendum != usual.dedendum || rack.root_fillet_radius != usual.root_fillet_radius)
        leave_out("the basic rack of the internal gear");
      return;
    }
    const bool hob = !gear.cut_by;
    const std::string id = add(hob ? "rack_shaped_tool" : "cutter_wheel_tool", name + ", tool");
    RexsComponent& tool = last();
    tool.set("normal_module", gear.spec.normal_module, "mm");
    tool.set("normal_pressure_angle", gear.spec.normal_pressure_angle.deg(), "deg");
    if (hob) {
      tool.set("addendum_coefficient_reference_profile", rack.dedendum, "none");
      tool.set("tip_radius_factor", fitting_radius(gear.spec), "none");
    } else {
      const int z0 = gear.cut_by->cutter_teeth;
      const double reference =
          z0 * gear.spec.normal_module / std::cos(gear.spec.helix_angle.rad()) / 2;
      const double tip = std::abs(gear.root_diameter / 2 + gear.side() * gear.cut_by->distance);
      tool.set("number_of_teeth", z0, "none");
      tool.set("addendum_coefficient_reference_profile",
               (tip - reference) / gear.spec.normal_module, "none");
      tool.set("tip_radius_factor", gear.cut_by->tip_rounding / gear.spec.normal_module, "none");
    }
    relate("manufacturing_step", {{"workpiece", flank}, {"tool", id}});
    if (rack.protuberance != 0.0 || rack.tip_fillet_radius != 0.0 || rack.semi_topping_angle)
      leave_out("protuberance and rounding of the tips");
  }

  RexsModel model_;
  std::string unit_, casing_;
  std::string note_;
};

std::optional<Error> not_in_rexs(const Gear& gear, const std::string& name) {
  if (!gear.involute() || gear.spec.root_fillet || gear.spec.tip_fillet)
    return Error{name, "",
                 "has circular-arc teeth or circular fillets, but REXS describes only involute "
                 "gears cut by racks or pinion cutters"};
  return std::nullopt;
}

}  // namespace

Result<JobFile> make_rexs(const SolvedJob& job, const std::filesystem::path& path) {
  if (job.rack)
    return Error{"gear2.form", "rack",
                 "is not supported in a REXS file, whose cylindrical stages have two gears; "
                 "--step, --dxf and --svg write the rack"};
  if (!job.pair)
    return Error{"gear2", "", "is needed for a REXS file, which describes stages of two gears"};
  if (job.pair->crossed())
    return Error{"pair.shaft_angle", "",
                 "makes the axes cross, but a cylindrical stage of REXS has parallel axes"};
  if (job.halves[0])
    return Error{
        "gear1.double_helical", "",
        "cannot be described by a cylindrical stage of REXS, whose gears have a single helix"};
  Writer writer(job.spec.title);
  std::array<std::string, 2> gears, shafts;
  for (const int which : {1, 2}) {
    const Gear& gear = job.pair->gear(which);
    const std::string name = gear_field(which);
    if (auto error = not_in_rexs(gear, name)) return *error;
    const std::size_t i = which - 1;
    shafts[i] = writer.shaft("shaft " + std::to_string(which));
    gears[i] = writer.gear(gear, name, shafts[i], job.spec.gear(which).modifications);
  }
  writer.stage("stage", gears[0], gears[1], job.pair->center_distance());
  // The spec gives the torque and the speed of gear 1. They are converted to the driving gear.
  const std::size_t driver = job.spec.load.driver == 2 ? 1 : 0;
  const double ratio = driver == 1 ? job.pair->gear_ratio() : 1.0;
  auto speed = job.spec.pair.speed_rpm;
  if (speed) *speed /= ratio;
  std::optional<double> torque;
  if (!job.spec.load.torques.empty()) torque = job.spec.load.torques.front() * ratio;
  if (job.spec.load.torques.size() > 1) writer.leave_out("the other torques");
  writer.input(shafts[driver], torque, speed);
  writer.output(shafts[1 - driver]);
  return writer.file(path);
}

Result<JobFile> make_rexs(const DriveJob& job, const std::filesystem::path& path) {
  const DriveGraph& graph = job.drive.graph;
  const DriveGeometry& geometry = job.drive.geometry;
  for (std::size_t g = 0; g < graph.gears.size(); ++g) {
    const std::string& name = graph.gears[g].name;
    if (graph.gears[g].rack)
      return Error{name, "",
                   "is a rack, which a REXS file does not support, because its cylindrical stages "
                   "have two gears"};
    if (graph.gears[g].double_helical)
      return Error{
          name, "",
          "is double-helical, which a REXS file does not support, because its gears have a "
          "single helix"};
    if (!graph.gears[g].spec)
      return Error{name, "", "has no module; a REXS file needs `normal_module_mm` of every gear"};
    if (!geometry.gears[g])
      return Error{name, "",
                   "has no teeth that fit the drive, so the gear cannot be written to a REXS file; "
                   "`gearwright drive SPEC` prints the reason"};
    if (auto error = not_in_rexs(*geometry.gears[g], name)) return *error;
  }
  Writer writer(job.spec.title);
  // A body with several copies has a shaft for each copy.
  std::vector<std::vector<std::string>> shafts(graph.bodies.size());
  for (std::size_t b = 0; b < graph.bodies.size(); ++b) {
    const DriveBody& body = graph.bodies[b];
    for (int copy = 0; copy < body.count; ++copy)
      shafts[b].push_back(
          writer.shaft(body.count > 1 ? fmt::format("{} {}", body.name, copy + 1) : body.name));
  }
  // A carrier with its planets and the gears that mesh with them is a planetary stage.
  for (std::size_t carrier = 0; carrier < graph.bodies.size(); ++carrier) {
    std::vector<const char*> roles(graph.bodies.size(), nullptr);
    for (const DriveMesh& mesh : graph.meshes)
      for (const std::size_t g : mesh.gears)
        if (graph.frame(mesh) == carrier)
          roles[graph.gears[g].body] =
              graph.body(graph.gears[g]).carrier ? "planet_shaft" : "central_shaft";
    if (std::all_of(roles.begin(), roles.end(), [](auto* role) { return role == nullptr; }))
      continue;
    roles[carrier] = "planet_carrier_shaft";
    const std::string set = writer.planetary_stage("planetary stage");
    for (std::size_t b = 0; b < roles.size(); ++b)
      for (const std::string& shaft : shafts[b])
        if (roles[b] != nullptr)
          writer.relate(roles[b], {{"planetary_stage", set}, {"shaft", shaft}});
  }
  std::vector<std::vector<std::string>> gears(graph.gears.size());
  for (std::size_t g = 0; g < graph.gears.size(); ++g)
    for (const std::string& shaft : shafts[graph.gears[g].body])
      gears[g].push_back(writer.gear(*geometry.gears[g], graph.gears[g].name, shaft,
                                     graph.gears[g].modifications));
  for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
    const DriveMesh& mesh = graph.meshes[m];
    if (!geometry.distance[m]) continue;
    const auto& [a, b] = mesh.gears;
    const std::size_t copies = std::max(gears[a].size(), gears[b].size());
    for (std::size_t copy = 0; copy < copies; ++copy)
      writer.stage(mesh.name, gears[a][std::min(copy, gears[a].size() - 1)],
                   gears[b][std::min(copy, gears[b].size() - 1)], *geometry.distance[m]);
  }
  const auto placed = [](const DriveBody& b) {
    return b.spacing.value_or(Spacing::nearest) != Spacing::nearest || !b.positions_deg.empty();
  };
  const auto lossy = [](const DriveMesh& m) {
    return m.efficiency || m.friction.value_or(DriveGraph{}.friction) != DriveGraph{}.friction;
  };
  if (graph.spacing != Spacing::nearest ||
      std::any_of(graph.bodies.begin(), graph.bodies.end(), placed))
    writer.leave_out("the positions of the planets");
  if (graph.friction != DriveGraph{}.friction ||
      std::any_of(graph.meshes.begin(), graph.meshes.end(), lossy))
    writer.leave_out("friction and efficiencies");
  for (const std::size_t b : graph.fixed) writer.hold(shafts[b].front());
  for (std::size_t i = 0; i < graph.inputs.size(); ++i)
    writer.input(shafts[graph.inputs[i]].front(), i == 0 ? graph.torque_Nm : std::nullopt,
                 i < graph.speeds_rpm.size() ? std::optional(graph.speeds_rpm[i]) : std::nullopt);
  writer.output(shafts[graph.output].front());
  return writer.file(path);
}

}  // namespace gearwright
