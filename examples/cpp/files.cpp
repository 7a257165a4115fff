// Files: a gear with a bore as STL for a printer, DXF for a wire cutter, SVG for a page.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  const Result<Gear> gear = make_gear({.teeth = 24, .normal_module = 1, .face_width = 8});
  if (!gear) return fail(gear.error());
  const Result<ToothedBody> body = gear_body(*gear, "gear", Bore{.diameter = 6});
  if (!body) return fail(body.error());

  const Result<TriangleMesh> mesh = tessellate(*body, {.chord_tolerance_mm = 0.005});
  if (!mesh) return fail(mesh.error());
  const Result<Drawing> dxf = dxf_drawing({*body});
  if (!dxf) return fail(dxf.error());
  const Result<Drawing> svg = svg_drawing(*body);
  if (!svg) return fail(svg.error());
  try {
    write_file("example_gear.stl", stl_bytes({{.name = body->name, .mesh = *mesh}}));
    write_file("example_gear.dxf", dxf->text);
    write_file("example_gear.svg", svg->text);
  } catch (const IoError& error) {  // disk full, no permission
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
  std::printf("volume   %.1f mm3\n", mesh_volume(*mesh));
  std::printf("DXF      within 1 um: %s\n", dxf->deviation_mm < 1e-3 ? "yes" : "no");
  std::printf("SVG      within 0.1 um: %s\n", svg->deviation_mm < 1e-4 ? "yes" : "no");
}

/* prints
volume   3348.0 mm3
DXF      within 1 um: yes
SVG      within 0.1 um: yes
*/
