// Page 12: the section of a gear, divided into finite elements for its compliance, and a load bump.
#include <algorithm>
#include <cmath>
#include <complex>

#include "docs/figures/figure.hpp"
#include "gearwright/compliance/flank_load.hpp"
#include "gearwright/compliance/tooth_section.hpp"

namespace gearwright::figures {

Drawing load_figure() {
  CylindricalSpec spec;
  spec.teeth = 25;
  spec.normal_module = 1;
  spec.face_width = 10;
  const Gear gear = gear_of(spec);
  const auto made = make_section_mesh(gear.tooth->outline, 1.0, 6.0,
                                      detail::mesh_options(gear, 0.0, ComplianceAccuracy::draft));
  const SectionMesh& mesh = *made;
  Figure f = plane_figure("12-loaded-contact", "The section of a gear in finite elements",
                          "Three teeth of a gear are divided into elements, which are smaller near "
                          "the outline and the tips. The rest of the rim has no teeth. A load with "
                          "the shape of a bump acts on the flank of the middle tooth.",
                          window({0, 11.2}, {900, 520}, 98));
  // The centre line of the tooth points up.
  const auto up = [](const std::complex<double>& p) { return Vec2(-p.imag(), p.real()); };
  for (const auto& e : mesh.elements) {
    std::vector<Vec2> side;
    for (const int k : {0, 4, 1, 5, 2, 6, 3, 7, 0}) side.push_back(up(mesh.nodes[e[k]]));
    const bool near = std::any_of(side.begin(), side.end(), [](const Vec2& p) {
      return p.y() > 8.4 && std::abs(p.x()) < 5.0;
    });
    if (near) f.line(std::move(side), "leader");
  }
  std::vector<Vec2> outline;
  for (int i = 0; i <= 300; ++i)
    outline.push_back(up(mesh.outline(mesh.edges.size() * (i / 300.0))));
  f.line(std::move(outline), "curve g1");
  const double s = detail::length_at_radius(mesh, 12.6);
  std::vector<Vec2> bump;
  for (int i = -20; i <= 20; ++i) {
    const double x = i / 20.0;
    const auto p = detail::flank_place(mesh, s + 0.3 * x);
    const double q = (1 - x * x) * (1 - x * x);
    bump.push_back(up(p.point - 0.5 * q * p.normal));
    if (i % 5 == 0 && q > 0.0) add_arrow(f, {bump.back(), up(p.point)}, "curve action-curve fine");
  }
  f.line(bump, "curve action-curve");
  f.text(bump[20], "b(s)", Anchor::end, "letter halo here", {-8, -2});
  f.text({kInfinity, -kInfinity}, "25 teeth, bore 6 m; draft mesh", Anchor::end, "tick halo",
         {-14, -10});
  return {f, 900};
}

}  // namespace gearwright::figures
