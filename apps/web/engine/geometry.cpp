// Computes figures in section, solids, lines and positions of the gears of a session.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/web/engine/session.hpp"
#include "gearwright/cad/bore_loop.hpp"
#include "gearwright/cad/contour.hpp"
#include "gearwright/cad/mesh.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/rack_mesh.hpp"

namespace gearwright::web {

namespace {

constexpr double kMinTolerance = 1e-6, kMaxTolerance = 10.0;  // mm

std::optional<Error> check_tolerance(double tolerance) {
  if (tolerance >= kMinTolerance && tolerance <= kMaxTolerance) return std::nullopt;
  return refused("tolerance", tolerance,
                 fmt::format("must lie between {} and {} mm", kMinTolerance, kMaxTolerance));
}

template <int n>
void append(Numbers& out, const Eigen::Matrix<double, n, 1>& p) {
  out.insert(out.end(), p.data(), p.data() + n);
}

void append_circles(std::vector<NamedCircle>& circles, const ValueRecord& record,
                    std::size_t gear) {
  for (const Member& m : record) {
    const QuantityInfo& info = *m.info;
    if (!info.key.ends_with("_diameter_mm")) continue;
    const ValueList* each = info.two == Two::gears ? m.value.list() : nullptr;
    const auto d = each ? (*each)[gear].number() : m.value.number();
    if (!d) continue;
    circles.push_back({std::string(info.symbol), std::abs(*d) / 2, style_of_circle(info.symbol),
                       std::string(info.words)});
  }
}

}  // namespace

Result<ToothedBody> Session::body(int gear) const {
  if (gear < 1 || gear > gears()) return absent_input("gear2", " from the spec");
  auto made = make_body(job_, gear);
  if (!made) return spelled(made.error(), job_.spec.given);
  return made;
}

std::optional<Error> Session::no_gear_2() const {
  if (auto error = two_gears_error(job_.spec)) return error;
  if (!job_.pair) return absent_input("gear2", ": there is no pair");
  return std::nullopt;
}

std::vector<NamedCircle> Session::circles(int gear) const {
  std::vector<NamedCircle> circles;
  const std::size_t which = gear - 1;
  if (which >= job_.gears.size()) return circles;  // gear 2 is a rack, which has no circles
  append_circles(circles, gear_quantities().of(job_.gears[which]), which);
  if (job_.pair) append_circles(circles, pair_quantities().of(*job_.pair), which);
  return circles;
}

Result<Json> Session::rack_figure(const MeshView& view) const {
  const auto shape_of = [&](int gear) { return view.name + "-gear" + std::to_string(gear); };
  const RackScene scene{&*job_.rack, {shape_of(1), shape_of(2)}, circles(1)};
  auto rack = rack_definition(*job_.rack, scene.shapes[1]);
  if (!rack) return rack.error();
  const Bounds window =
      view.window ? *view.window : rack_window(scene, view.frame, view.width / view.height);
  Figure figure = view.bodies ? rack_bodies_figure(scene, window) : rack_mesh_figure(scene, window);
  figure.definitions = gear_definition(job_.gears[0], scene.shapes[0]) + *rack;
  figure.id = view.name;
  return shape(figure, view.width);
}

Result<Json> Session::mesh_figure(const MeshView& view) const {
  if (job_.rack) return rack_figure(view);
  MeshScene scene;
  for (int gear = 1; gear <= gears(); ++gear) {
    // A gear that has no body has no figure either.
    const auto made = body(gear);
    if (!made) return made.error();
    const auto contour = closed_contour(made->outline);
    if (!contour) return contour.error();
    if (const auto bore = bore_contour(*made, contour->inner_radius, contour->outer_radius); !bore)
      return spelled(within(made->name, bore.error()), job_.spec.given);
    const std::size_t i = gear - 1;
    scene.gears.push_back(&job_.gears[i]);
    scene.shapes[i] = view.name + "-gear" + std::to_string(gear);
    scene.circles[i] = circles(gear);
  }
  if (job_.pair) {
    scene.pair = &job_.pair->mounted();
    scene.involute = job_.pair->involute();
  }
  const Bounds window =
      view.window ? *view.window : mesh_window(scene, view.frame, view.width / view.height);
  Figure figure =
      view.bodies ? bodies_figure(scene, window) : gearwright::mesh_figure(scene, window);
  for (std::size_t i = 0; i < scene.gears.size(); ++i)
    figure.definitions += gear_definition(*scene.gears[i], scene.shapes[i]);
  figure.id = view.name;
  return shape(figure, view.width);
}

Result<Json> Session::mesh(int gear, double tolerance) const {
  if (auto error = check_tolerance(tolerance)) return *error;
  const auto made = body(gear);
  if (!made) return made.error();
  const auto mesh = tessellate(*made, {.chord_tolerance_mm = tolerance});
  if (!mesh) return spelled(within(made->name, mesh.error()), job_.spec.given);
  return shape(*mesh, tolerance);
}

Result<Json> Session::lines() const {
  if (auto error = no_gear_2()) return *error;
  const Pair& pair = *job_.pair;
  Numbers line_of_action, trailing_line, path_of_contact;
  Json points = Json::array();
  // Only involute gears have a line of action. Circular-arc gears touch at points that move along
  // the teeth.
  if (const InvolutePair* p = pair.involute()) {
    const gearwright::Mesh<double>& m = p->mesh;
    for (const double rho : {0.0, m.sigma * m.base_tangent_distance}) {
      append(line_of_action, p->on_line_of_action(rho).r);
      append(trailing_line, p->on_trailing_line(rho).r);
    }
    if (p->flanks_meet()) {
      for (const double rho : {m.rho1_A, m.rho1_E})
        append(path_of_contact, p->on_line_of_action(rho).r);
      for (const auto& [name, rho] :
           {std::pair("A", m.rho1_A), std::pair("B", m.rho1_B), std::pair("C", m.rho1_C),
            std::pair("D", m.rho1_D), std::pair("E", m.rho1_E)}) {
        const Vec3 r = p->on_line_of_action(rho).r;
        if (r.allFinite())
          points.push_back({{"name", name}, {"x", r.x()}, {"y", r.y()}, {"z", r.z()}});
      }
    }
  }
  return Json{{"kind", to_string(pair.kind())},
              {"centerDistance", pair.center_distance()},
              {"shaftAngleDeg", pair.shaft_angle().deg()},
              {"lineOfAction", row(line_of_action)},
              {"trailingLine", row(trailing_line)},
              {"pathOfContact", row(path_of_contact)},
              {"points", std::move(points)}};
}

// Gear 1 turns clockwise seen from +z. The mounting error ΔC displaces axis 2. All other mounting
// errors tilt or displace axis 1. [T1.5], [T8.12]
Result<Json> Session::pose(int gear, double rotation1_deg, bool nominal) {
  if (!has_pair()) {
    if (gear != 1) return absent_input("gear2", ": there is no pair");
    return shape(SolidPose(Vec3::Zero(), about_z(-Angle::degrees(rotation1_deg).rad())));
  }
  const Angle rotation1 = Angle::degrees(rotation1_deg);
  // If `nominal` is true or the gears cannot touch, the errors of mounting are ignored.
  const auto touching = nominal ? Result<const Touching*>(nullptr) : this->touching();
  const ContactPair* contact = touching && *touching ? (*touching)->pair.get() : nullptr;
  using Motion = Pose<AssemblyFrame, AssemblyFrame>;
  const SolidPose at_rest = pose_of(job_, gear);
  if (gear == 1) {
    const SolidPose x = Motion(Vec3::Zero(), about_z(-rotation1.rad())) * at_rest;
    if (!contact) return shape(x);
    Mat3 tilt;
    for (const int i : {0, 1, 2}) tilt.col(i) = contact->tilted(Vec3::Unit(i));
    return shape(Motion(contact->in_housing(0.0, 0.0), tilt) * x);
  }
  // If gear 2 is a rack, its rotation is its travel divided by the reference radius of the pinion.
  Vec3 shift = Vec3::Zero();
  Angle rotation2 = job_.rack ? rotation1 : std::abs(1.0 / job_.pair->gear_ratio()) * rotation1;
  if (contact) {
    const auto p = touch(rotation1_deg);
    if (!p) return p.error();
    if (p->kind != TouchKind::none) rotation2 = p->rotation2;
    shift.x() = contact->place().errors.center_distance;
  }
  Mat3 turn = Mat3::Identity();
  if (job_.rack)
    shift.y() = -rotation2.rad() * job_.rack->pinion.reference_diameter / 2;
  else
    turn = about_z(job_.pair->mounted().side() * rotation2.rad());
  return shape(Motion(shift, Mat3::Identity()) * at_rest *
               Pose<SolidFrame, SolidFrame>(Vec3::Zero(), turn));
}

}  // namespace gearwright::web
