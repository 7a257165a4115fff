#include "gearwright/cad/dxf_document.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"

namespace gearwright {
namespace {

// Handles of the frame. Owners come before what they own.
enum Handle : int {
  kNone = 0x0,
  kVports = 0x1,
  kVport,
  kLtypes,
  kByBlock,
  kByLayer,
  kContinuous,
  kStyles,
  kStyle,
  kViews,
  kUcses,
  kAppids,
  kAcad,
  kDimstyles,
  kDimstyle,
  kBlocks,
  kModel,
  kPaper,
  kLayers,
  kModelBegin = 0x20,
  kModelEnd,
  kPaperBegin,
  kPaperEnd,
  kRoot = 0x30,
  kGroups,
  kLayouts,
  kPlotStyles,
  kPlotStyle,
  kModelLayout,
  kPaperLayout,
  kLayer0 = 0x40,  // further layers follow
};

// Writes pairs. Reals always show that they are real.
class Pairs {
 public:
  explicit Pairs(std::string& text) : text_(text) {}
  Pairs& word(int code, const std::string& value) {
    text_ += fmt::format("{}\n{}\n", code, value);
    return *this;
  }
  Pairs& integer(int code, int value) {
    text_ += fmt::format("{}\n{}\n", code, value);
    return *this;
  }
  Pairs& real(int code, double value) {
    const std::size_t start = text_.size();
    text_ += fmt::format("{}\n{}", code, value + 0.0);
    const std::size_t number = text_.find('\n', start) + 1;
    if (text_.find_first_of(".e", number) == std::string::npos) text_ += ".0";
    text_ += '\n';
    return *this;
  }
  Pairs& handle(int code, int value) {
    text_ += fmt::format("{}\n{:X}\n", code, value);
    return *this;
  }
  Pairs& point(int code, double x, double y) { return real(code, x).real(code + 10, y); }
  Pairs& point(int code, double x, double y, double z) {
    return point(code, x, y).real(code + 20, z);
  }

 private:
  std::string& text_;
};

void begin_section(Pairs& out, const char* name) { out.word(0, "SECTION").word(2, name); }

void begin_table(Pairs& out, const char* name, int handle, int entries) {
  out.word(0, "TABLE").word(2, name).handle(5, handle).handle(330, kNone);
  out.word(100, "AcDbSymbolTable").integer(70, entries);
}

void record(Pairs& out, const char* type, int handle, int owner, const char* subclass,
            const std::string& name, int handle_code = 5) {
  out.word(0, type).handle(handle_code, handle).handle(330, owner);
  out.word(100, "AcDbSymbolTableRecord").word(100, subclass).word(2, name);
}

void header(Pairs& out, int handle_seed, double reach) {
  begin_section(out, "HEADER");
  out.word(9, "$ACADVER").word(1, "AC1015");
  out.word(9, "$DWGCODEPAGE").word(3, "ANSI_1252");
  out.word(9, "$INSBASE").point(10, 0, 0, 0);
  out.word(9, "$EXTMIN").point(10, -reach, -reach, 0);
  out.word(9, "$EXTMAX").point(10, reach, reach, 0);
  out.word(9, "$LIMMIN").point(10, -reach, -reach);
  out.word(9, "$LIMMAX").point(10, reach, reach);
  out.word(9, "$LUNITS").integer(70, 2);
  out.word(9, "$LUPREC").integer(70, 6);
  out.word(9, "$INSUNITS").integer(70, 4);
  out.word(9, "$MEASUREMENT").integer(70, 1);
  out.word(9, "$HANDSEED").handle(5, handle_seed);
  out.word(0, "ENDSEC");
  begin_section(out, "CLASSES");
  out.word(0, "ENDSEC");
}

void tables(Pairs& out, const std::vector<DxfLayer>& layers, double reach) {
  begin_section(out, "TABLES");
  begin_table(out, "VPORT", kVports, 1);
  record(out, "VPORT", kVport, kVports, "AcDbViewportTableRecord", "*Active");
  out.integer(70, 0).point(10, 0, 0).point(11, 1, 1).point(12, 0, 0).point(13, 0, 0);
  out.point(14, 10, 10).point(15, 10, 10).point(16, 0, 0, 1).point(17, 0, 0, 0);
  out.real(40, 2.2 * reach).real(41, 1.5).real(42, 50).real(43, 0).real(44, 0).real(50, 0);
  out.real(51, 0).integer(71, 0).integer(72, 1000).integer(73, 1).integer(74, 3);
  out.integer(75, 0).integer(76, 0).integer(77, 0).integer(78, 0);
  out.word(0, "ENDTAB");

  begin_table(out, "LTYPE", kLtypes, 3);
  for (const auto& [handle, name] :
       {std::pair{kByBlock, "ByBlock"}, {kByLayer, "ByLayer"}, {kContinuous, "Continuous"}}) {
    record(out, "LTYPE", handle, kLtypes, "AcDbLinetypeTableRecord", name);
    out.integer(70, 0).word(3, "").integer(72, 65).integer(73, 0).real(40, 0);
  }
  out.word(0, "ENDTAB");

  begin_table(out, "LAYER", kLayers, static_cast<int>(layers.size()) + 1);
  int handle = kLayer0;
  const auto layer = [&](const std::string& name, int color) {
    record(out, "LAYER", handle++, kLayers, "AcDbLayerTableRecord", name);
    out.integer(70, 0).integer(62, color).word(6, "Continuous").integer(370, -3);
    out.handle(390, kPlotStyle);
  };
  layer("0", 7);
  for (const DxfLayer& l : layers) layer(l.name, l.color);
  out.word(0, "ENDTAB");

  begin_table(out, "STYLE", kStyles, 1);
  record(out, "STYLE", kStyle, kStyles, "AcDbTextStyleTableRecord", "Standard");
  out.integer(70, 0).real(40, 0).real(41, 1).real(50, 0).integer(71, 0).real(42, 2.5);
  out.word(3, "txt").word(4, "");
  out.word(0, "ENDTAB");

  begin_table(out, "VIEW", kViews, 0);
  out.word(0, "ENDTAB");
  begin_table(out, "UCS", kUcses, 0);
  out.word(0, "ENDTAB");

  begin_table(out, "APPID", kAppids, 1);
  record(out, "APPID", kAcad, kAppids, "AcDbRegAppTableRecord", "ACAD");
  out.integer(70, 0).word(0, "ENDTAB");

  begin_table(out, "DIMSTYLE", kDimstyles, 1);
  out.word(100, "AcDbDimStyleTable").integer(71, 0);
  record(out, "DIMSTYLE", kDimstyle, kDimstyles, "AcDbDimStyleTableRecord", "Standard", 105);
  out.integer(70, 0).handle(340, kStyle).word(0, "ENDTAB");

  begin_table(out, "BLOCK_RECORD", kBlocks, 2);
  record(out, "BLOCK_RECORD", kModel, kBlocks, "AcDbBlockTableRecord", "*Model_Space");
  out.handle(340, kModelLayout);
  record(out, "BLOCK_RECORD", kPaper, kBlocks, "AcDbBlockTableRecord", "*Paper_Space");
  out.handle(340, kPaperLayout);
  out.word(0, "ENDTAB").word(0, "ENDSEC");
}

void block(Pairs& out, const char* name, int owner, int begin, int end) {
  out.word(0, "BLOCK").handle(5, begin).handle(330, owner).word(100, "AcDbEntity");
  if (owner == kPaper) out.integer(67, 1);
  out.word(8, "0").word(100, "AcDbBlockBegin").word(2, name).integer(70, 0).point(10, 0, 0, 0);
  out.word(3, name).word(1, "");
  out.word(0, "ENDBLK").handle(5, end).handle(330, owner).word(100, "AcDbEntity");
  if (owner == kPaper) out.integer(67, 1);
  out.word(8, "0").word(100, "AcDbBlockEnd");
}

// An A3 sheet; nothing is placed on it.
void layout(Pairs& out, const char* name, int handle, int order, int record_handle, double reach) {
  const bool model = order == 0;
  out.word(0, "LAYOUT").handle(5, handle).handle(330, kLayouts).word(100, "AcDbPlotSettings");
  out.word(1, "").word(2, "none_device").word(4, "").word(6, "");
  out.real(40, 7.5).real(41, 20).real(42, 7.5).real(43, 20).real(44, 420).real(45, 297);
  out.real(46, 0).real(47, 0).real(48, 0).real(49, 0).real(140, 0).real(141, 0);
  out.real(142, 1).real(143, 1).integer(70, model ? 1024 : 0).integer(72, 1).integer(73, 0);
  out.integer(74, model ? 1 : 5).word(7, "").integer(75, 16).real(147, 1).point(148, 0, 0);
  out.word(100, "AcDbLayout").word(1, name).integer(70, 1).integer(71, order);
  out.point(10, 0, 0).point(11, 420, 297).point(12, 0, 0, 0);
  out.point(14, -reach, -reach, 0).point(15, reach, reach, 0).real(146, 0);
  out.point(13, 0, 0, 0).point(16, 1, 0, 0).point(17, 0, 1, 0).integer(76, 0);
  out.handle(330, record_handle);
}

void objects(Pairs& out, double reach) {
  const auto dictionary = [&](const char* type, int handle, int owner) {
    out.word(0, type).handle(5, handle).handle(330, owner);
    out.word(100, "AcDbDictionary").integer(281, 1);
  };
  begin_section(out, "OBJECTS");
  dictionary("DICTIONARY", kRoot, kNone);
  out.word(3, "ACAD_GROUP").handle(350, kGroups);
  out.word(3, "ACAD_LAYOUT").handle(350, kLayouts);
  out.word(3, "ACAD_PLOTSTYLENAME").handle(350, kPlotStyles);
  dictionary("DICTIONARY", kGroups, kRoot);
  dictionary("DICTIONARY", kLayouts, kRoot);
  out.word(3, "Model").handle(350, kModelLayout);
  out.word(3, "Layout1").handle(350, kPaperLayout);
  dictionary("ACDBDICTIONARYWDFLT", kPlotStyles, kRoot);
  out.word(3, "Normal").handle(350, kPlotStyle);
  out.word(100, "AcDbDictionaryWithDefault").handle(340, kPlotStyle);
  out.word(0, "ACDBPLACEHOLDER").handle(5, kPlotStyle).handle(330, kPlotStyles);
  layout(out, "Model", kModelLayout, 0, kModel, reach);
  layout(out, "Layout1", kPaperLayout, 1, kPaper, reach);
  out.word(0, "ENDSEC");
}

}  // namespace

void DxfEntities::begin(const char* type, const std::string& layer, const char* subclass) {
  Pairs(text_)
      .word(0, type)
      .handle(5, handle_++)
      .handle(330, kModel)
      .word(100, "AcDbEntity")
      .word(8, layer)
      .word(100, subclass);
}

void DxfEntities::place(const Eigen::Isometry3d& pose) {
  moved_ = !pose.matrix().isIdentity(0.0);
  pose_.linear() = pose.linear().topLeftCorner<2, 2>();
  pose_.translation() = pose.translation().head<2>();
}

void DxfEntities::closed_polyline(const std::string& layer, const std::vector<Vec2>& points,
                                  const std::vector<double>& bulges) {
  GW_EXPECTS(points.size() == bulges.size());
  begin("LWPOLYLINE", layer, "AcDbPolyline");
  Pairs out(text_);
  out.integer(90, static_cast<int>(points.size())).integer(70, 1).real(43, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = at(points[i]);
    out.point(10, p.x(), p.y());
    if (bulges[i] != 0.0) out.real(42, bulges[i]);
  }
}

void DxfEntities::circle(const std::string& layer, double radius) {
  begin("CIRCLE", layer, "AcDbCircle");
  const Vec2 center = at(Vec2::Zero());
  Pairs(text_).point(10, center.x(), center.y(), 0).real(40, radius);
}

void DxfEntities::circular_spline(const std::string& layer, const Vec2& begin_point,
                                  const Vec2& end_point, double sweep) {
  // Pieces of at most a quarter turn: P0, the corner of the tangents with weight cos(δ/2), P1.
  const int pieces = static_cast<int>(std::ceil(std::abs(sweep) / (std::numbers::pi / 2 + 1e-9)));
  const double half = sweep / (2 * pieces);
  const double weight = std::cos(half);
  begin("SPLINE", layer, "AcDbSpline");
  Pairs out(text_);
  const int poles = 2 * pieces + 1;
  out.point(210, 0, 0, 1).integer(70, 12).integer(71, 2);  // 4: rational, 8: planar
  out.integer(72, poles + 3).integer(73, poles).integer(74, 0).real(42, 1e-9).real(43, 1e-9);
  for (int i = 0; i < 3; ++i) out.real(40, 0);
  for (int i = 1; i < pieces; ++i) {
    for (int twice = 0; twice < 2; ++twice) out.real(40, static_cast<double>(i) / pieces);
  }
  for (int i = 0; i < 3; ++i) out.real(40, 1);
  for (int i = 0; i < poles; ++i) out.real(41, i % 2 == 0 ? 1 : weight);
  for (int i = 0; i < poles; ++i) {
    Vec2 p = i == 0 ? begin_point : end_point;
    if (i > 0 && i < poles - 1) {
      p = Eigen::Rotation2Dd(half * i) * begin_point;
      if (i % 2 == 1) p /= weight;
    }
    p = at(p);
    out.point(10, p.x(), p.y(), 0);
  }
}

void DxfEntities::spline(const std::string& layer, int degree, const std::vector<double>& knots,
                         const std::vector<Vec2>& poles) {
  GW_EXPECTS(knots.size() == poles.size() + static_cast<std::size_t>(degree) + 1);
  begin("SPLINE", layer, "AcDbSpline");
  Pairs out(text_);
  out.point(210, 0, 0, 1).integer(70, 8).integer(71, degree);  // 8: planar
  out.integer(72, static_cast<int>(knots.size())).integer(73, static_cast<int>(poles.size()));
  out.integer(74, 0).real(42, 1e-9).real(43, 1e-9);
  for (const double knot : knots) out.real(40, knot);
  for (const Vec2& pole : poles) {
    const Vec2 p = at(pole);
    out.point(10, p.x(), p.y(), 0);
  }
}

std::string dxf_document(const DxfEntities& entities, const std::vector<DxfLayer>& layers,
                         double reach) {
  GW_EXPECTS(kLayer0 + static_cast<int>(layers.size()) < 0x100);
  GW_EXPECTS(reach > 0.0);
  std::string text;
  Pairs out(text);
  header(out, entities.next_handle(), reach);
  tables(out, layers, reach);
  begin_section(out, "BLOCKS");
  block(out, "*Model_Space", kModel, kModelBegin, kModelEnd);
  block(out, "*Paper_Space", kPaper, kPaperBegin, kPaperEnd);
  out.word(0, "ENDSEC");
  begin_section(out, "ENTITIES");
  text += entities.text();
  out.word(0, "ENDSEC");
  objects(out, reach);
  out.word(0, "EOF");
  return text;
}

}  // namespace gearwright
