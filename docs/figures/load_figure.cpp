// Page 12: the section of a gear, divided into finite elements for its compliance, and a load bump.
#include <cmath>

#include "docs/figures/figure.hpp"
#include "gearwright/compliance/flank_load.hpp"
#include "gearwright/compliance/tooth_section.hpp"

namespace gearwright::figures {

Drawing load_figure() {
  Drawing f("12-loaded-contact", 900, 520, "The section of a gear in finite elements",
            "Three teeth of a gear are divided into elements, which are smaller near the outline "
            "and the tips. The rest of the rim has no teeth. A load with the shape of a bump acts "
            "on the flank of the middle tooth.");
  CylindricalSpec spec;
  spec.teeth = 25;
  spec.normal_module = 1;
  spec.face_width = 10;
  const Gear gear = gear_of(spec);
  const auto made = make_section_mesh(gear.tooth->outline, 1.0, 6.0,
                                      detail::mesh_options(gear, 0.0, ComplianceAccuracy::draft));
  const SectionMesh& mesh = *made;
  // The centre line of the tooth points up.
  const Viewport view{900, 520, {11.2, 0}, 98, true};
  const auto point = [&](int node) {
    return Vec2(mesh.nodes[node].real(), mesh.nodes[node].imag());
  };
  for (const auto& e : mesh.elements) {
    bool near = false;
    for (const int n : e) near = near || (point(n).x() > 8.4 && std::abs(point(n).y()) < 5.0);
    if (!near) continue;
    std::vector<Vec2> side;
    for (const int k : {0, 4, 1, 5, 2, 6, 3, 7, 0}) side.push_back(point(e[k]));
    f.line(view, side, "soft thin");
  }
  std::vector<Vec2> outline;
  for (int i = 0; i <= 300; ++i) {
    const auto w = mesh.outline(mesh.edges.size() * (i / 300.0));
    outline.push_back({w.real(), w.imag()});
  }
  f.line(view, outline, "g1 heavy");
  const double s = detail::length_at_radius(mesh, 12.6);
  std::vector<Vec2> bump;
  for (int i = -20; i <= 20; ++i) {
    const double x = i / 20.0;
    const auto p = detail::flank_place(mesh, s + 0.3 * x);
    const double q = (1 - x * x) * (1 - x * x);
    const auto w = p.point - 0.5 * q * p.normal;
    bump.push_back({w.real(), w.imag()});
    if (i % 5 == 0 && q > 0.0)
      f.arrow(view.px({w.real(), w.imag()}), view.px({p.point.real(), p.point.imag()}), "action");
  }
  f.line(view, bump, "action thick");
  f.label(view.px(bump[20]), "b(s)", Anchor::end, {-8, -2}, "action bold halo");
  f.label({886, 510}, "25 teeth, bore 6 m; draft mesh", Anchor::end, Vec2::Zero(),
          "soft small halo");
  return f;
}

}  // namespace gearwright::figures
