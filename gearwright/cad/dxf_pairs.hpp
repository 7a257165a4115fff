// Writes the pairs of a DXF file and defines the handles of its fixed sections. Internal to cad/.
#pragma once

#include <fmt/format.h>

#include <string>

namespace gearwright::dxf {

// Handles of the fixed sections. The handle of an owner is less than the handles of its objects.
enum DxfHandle : int {
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
  kChain,
  kWords,
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

inline constexpr const char* kWordStyle = "SHEET";

// Writes pairs. A real number is always written with a decimal point.
class DxfPairs {
 public:
  explicit DxfPairs(std::string& text) : text_(text) {}
  DxfPairs& word(int code, const std::string& value) {
    text_ += fmt::format("{}\n{}\n", code, value);
    return *this;
  }
  DxfPairs& integer(int code, int value) {
    text_ += fmt::format("{}\n{}\n", code, value);
    return *this;
  }
  DxfPairs& real(int code, double value) {
    const std::size_t start = text_.size();
    text_ += fmt::format("{}\n{}", code, value + 0.0);
    const std::size_t number = text_.find('\n', start) + 1;
    if (text_.find_first_of(".e", number) == std::string::npos) text_ += ".0";
    text_ += '\n';
    return *this;
  }
  DxfPairs& handle(int code, int value) {
    text_ += fmt::format("{}\n{:X}\n", code, value);
    return *this;
  }
  DxfPairs& point(int code, double x, double y) { return real(code, x).real(code + 10, y); }
  DxfPairs& point(int code, double x, double y, double z) {
    return point(code, x, y).real(code + 20, z);
  }

 private:
  std::string& text_;
};

}  // namespace gearwright::dxf
