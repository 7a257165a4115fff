#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/cad/dxf_document.hpp"
#include "gearwright/cad/sheet_files.hpp"

namespace gearwright {

namespace {

void add(DxfEntities& entities, const SheetPath& path) {
  const char* layer = style_of(path.layer).name;
  const std::vector<Vec2>& p = path.points;
  if (path.filled) {
    GW_EXPECTS(p.size() == 3);
    entities.triangle(layer, p[0], p[1], p[2]);
  } else if (!path.closed && p.size() == 2 && path.bulges[0] == 0.0) {
    entities.line(layer, p[0], p[1]);
  } else {
    entities.polyline(layer, p, path.bulges);
  }
}

}  // namespace

std::string sheets_dxf(const std::vector<Sheet>& sheets) {
  GW_EXPECTS(!sheets.empty());
  constexpr double kUpright_deg = 90.0;
  DxfEntities entities;
  double x = 0.0, height = 0.0;
  for (const Sheet& sheet : sheets) {
    if (x > 0.0) x += kBetweenSheets_mm;
    entities.place(Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, 0.0)));
    for (const SheetPath& path : sheet.paths) add(entities, path);
    for (const SheetCircle& c : sheet.circles)
      entities.circle(style_of(c.layer).name, c.radius, c.center);
    for (const SheetText& t : sheet.texts)
      entities.text(style_of(t.layer).name, t.at, t.text, t.height, t.upright ? kUpright_deg : 0.0);
    x += sheet.size.x();
    height = std::max(height, sheet.size.y());
  }
  std::vector<DxfLayer> layers;
  for (int i = 0; i < kSheetLayers; ++i) {
    const LayerStyle& style = style_of(static_cast<SheetLayer>(i));
    const auto hundredths = static_cast<int>(std::lround(100 * style.line_width));
    layers.push_back({style.name, style.dxf_color, hundredths, style.chain});
  }
  return dxf_document(entities, layers, {Vec2::Zero(), {x, height}});
}

}  // namespace gearwright
