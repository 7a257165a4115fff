#include "gearwright/cad/dxf_document.hpp"

#include <algorithm>

#include "gearwright/base/contract.hpp"
#include "gearwright/cad/dxf_pairs.hpp"

namespace gearwright {

using namespace dxf;

namespace {

void begin_section(DxfPairs& out, const char* name) { out.word(0, "SECTION").word(2, name); }

void begin_table(DxfPairs& out, const char* name, int handle, int entries) {
  out.word(0, "TABLE").word(2, name).handle(5, handle).handle(330, kNone);
  out.word(100, "AcDbSymbolTable").integer(70, entries);
}

void record(DxfPairs& out, const char* type, int handle, int owner, const char* subclass,
            const std::string& name, int handle_code = 5) {
  out.word(0, type).handle(handle_code, handle).handle(330, owner);
  out.word(100, "AcDbSymbolTableRecord").word(100, subclass).word(2, name);
}

void header(DxfPairs& out, int handle_seed, const SheetBox& extent) {
  const auto& [lo, hi] = extent;
  begin_section(out, "HEADER");
  out.word(9, "$ACADVER").word(1, "AC1015");
  out.word(9, "$DWGCODEPAGE").word(3, "ANSI_1252");
  out.word(9, "$INSBASE").point(10, 0, 0, 0);
  out.word(9, "$EXTMIN").point(10, lo.x(), lo.y(), 0);
  out.word(9, "$EXTMAX").point(10, hi.x(), hi.y(), 0);
  out.word(9, "$LIMMIN").point(10, lo.x(), lo.y());
  out.word(9, "$LIMMAX").point(10, hi.x(), hi.y());
  out.word(9, "$LUNITS").integer(70, 2);
  out.word(9, "$LUPREC").integer(70, 6);
  out.word(9, "$INSUNITS").integer(70, 4);
  out.word(9, "$MEASUREMENT").integer(70, 1);
  out.word(9, "$HANDSEED").handle(5, handle_seed);
  out.word(0, "ENDSEC");
  begin_section(out, "CLASSES");
  out.word(0, "ENDSEC");
}

// Writes the table of line types. In a pattern, positive lengths are dashes, and negative ones are
// gaps.
void line_types(DxfPairs& out, bool chain) {
  begin_table(out, "LTYPE", kLtypes, chain ? 4 : 3);
  for (const auto& [handle, name] :
       {std::pair{kByBlock, "ByBlock"}, {kByLayer, "ByLayer"}, {kContinuous, "Continuous"}}) {
    record(out, "LTYPE", handle, kLtypes, "AcDbLinetypeTableRecord", name);
    out.integer(70, 0).word(3, "").integer(72, 65).integer(73, 0).real(40, 0);
  }
  if (chain) {
    record(out, "LTYPE", kChain, kLtypes, "AcDbLinetypeTableRecord", "CENTER");
    double length = 0.0, sign = 1.0;
    for (const double part : kChain_mm) length += part;
    out.integer(70, 0).word(3, "Center ____ _ ____").integer(72, 65).integer(73, 4);
    out.real(40, length);
    for (const double part : kChain_mm) {
      out.real(49, sign * part).integer(74, 0);
      sign = -sign;
    }
  }
  out.word(0, "ENDTAB");
}

void text_styles(DxfPairs& out, bool words) {
  begin_table(out, "STYLE", kStyles, words ? 2 : 1);
  const auto style = [&](int handle, const char* name, const char* font) {
    record(out, "STYLE", handle, kStyles, "AcDbTextStyleTableRecord", name);
    out.integer(70, 0).real(40, 0).real(41, 1).real(50, 0).integer(71, 0).real(42, 2.5);
    out.word(3, font).word(4, "");
  };
  style(kStyle, "Standard", "txt");
  if (words) style(kWords, kWordStyle, "arial.ttf");
  out.word(0, "ENDTAB");
}

void tables(DxfPairs& out, const std::vector<DxfLayer>& layers, bool words,
            const SheetBox& extent) {
  const Vec2 half = (extent.hi - extent.lo) / 2, middle = extent.lo + half;
  begin_section(out, "TABLES");
  begin_table(out, "VPORT", kVports, 1);
  record(out, "VPORT", kVport, kVports, "AcDbViewportTableRecord", "*Active");
  out.integer(70, 0).point(10, 0, 0).point(11, 1, 1).point(12, middle.x(), middle.y());
  out.point(13, 0, 0);
  out.point(14, 10, 10).point(15, 10, 10).point(16, 0, 0, 1).point(17, 0, 0, 0);
  out.real(40, 2.2 * half.y()).real(41, 1.5).real(42, 50).real(43, 0).real(44, 0).real(50, 0);
  out.real(51, 0).integer(71, 0).integer(72, 1000).integer(73, 1).integer(74, 3);
  out.integer(75, 0).integer(76, 0).integer(77, 0).integer(78, 0);
  out.word(0, "ENDTAB");

  line_types(out, std::any_of(layers.begin(), layers.end(), [](const auto& l) { return l.chain; }));

  begin_table(out, "LAYER", kLayers, static_cast<int>(layers.size()) + 1);
  int handle = kLayer0;
  const auto layer = [&](const DxfLayer& l) {
    record(out, "LAYER", handle++, kLayers, "AcDbLayerTableRecord", l.name);
    out.integer(70, 0).integer(62, l.color).word(6, l.chain ? "CENTER" : "Continuous");
    out.integer(370, l.line_width).handle(390, kPlotStyle);
  };
  layer({"0", 7});
  for (const DxfLayer& l : layers) layer(l);
  out.word(0, "ENDTAB");

  text_styles(out, words);

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

void block(DxfPairs& out, const char* name, int owner, int begin, int end) {
  out.word(0, "BLOCK").handle(5, begin).handle(330, owner).word(100, "AcDbEntity");
  if (owner == kPaper) out.integer(67, 1);
  out.word(8, "0").word(100, "AcDbBlockBegin").word(2, name).integer(70, 0).point(10, 0, 0, 0);
  out.word(3, name).word(1, "");
  out.word(0, "ENDBLK").handle(5, end).handle(330, owner).word(100, "AcDbEntity");
  if (owner == kPaper) out.integer(67, 1);
  out.word(8, "0").word(100, "AcDbBlockEnd");
}

// Writes a LAYOUT object. If `order` is 0, it is the layout of the model space. Otherwise, it is an
// empty A3 sheet.
void layout(DxfPairs& out, const char* name, int handle, int order, int record_handle,
            const SheetBox& extent) {
  const auto& [lo, hi] = extent;
  const bool model = order == 0;
  out.word(0, "LAYOUT").handle(5, handle).handle(330, kLayouts).word(100, "AcDbPlotSettings");
  out.word(1, "").word(2, "none_device").word(4, "").word(6, "");
  out.real(40, 7.5).real(41, 20).real(42, 7.5).real(43, 20).real(44, 420).real(45, 297);
  out.real(46, 0).real(47, 0).real(48, 0).real(49, 0).real(140, 0).real(141, 0);
  out.real(142, 1).real(143, 1).integer(70, model ? 1024 : 0).integer(72, 1).integer(73, 0);
  out.integer(74, model ? 1 : 5).word(7, "").integer(75, 16).real(147, 1).point(148, 0, 0);
  out.word(100, "AcDbLayout").word(1, name).integer(70, 1).integer(71, order);
  out.point(10, 0, 0).point(11, 420, 297).point(12, 0, 0, 0);
  out.point(14, lo.x(), lo.y(), 0).point(15, hi.x(), hi.y(), 0).real(146, 0);
  out.point(13, 0, 0, 0).point(16, 1, 0, 0).point(17, 0, 1, 0).integer(76, 0);
  out.handle(330, record_handle);
}

void objects(DxfPairs& out, const SheetBox& extent) {
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
  layout(out, "Model", kModelLayout, 0, kModel, extent);
  layout(out, "Layout1", kPaperLayout, 1, kPaper, extent);
  out.word(0, "ENDSEC");
}

}  // namespace

std::string dxf_document(const DxfEntities& entities, const std::vector<DxfLayer>& layers,
                         const SheetBox& extent) {
  GW_EXPECTS(kLayer0 + static_cast<int>(layers.size()) < 0x100);
  GW_EXPECTS((extent.hi - extent.lo).minCoeff() > 0.0);
  std::string text;
  DxfPairs out(text);
  header(out, entities.next_handle(), extent);
  tables(out, layers, entities.has_words(), extent);
  begin_section(out, "BLOCKS");
  block(out, "*Model_Space", kModel, kModelBegin, kModelEnd);
  block(out, "*Paper_Space", kPaper, kPaperBegin, kPaperEnd);
  out.word(0, "ENDSEC");
  begin_section(out, "ENTITIES");
  text += entities.text();
  out.word(0, "ENDSEC");
  objects(out, extent);
  out.word(0, "EOF");
  return text;
}

}  // namespace gearwright
