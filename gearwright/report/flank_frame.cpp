#include "gearwright/report/flank_frame.hpp"

#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

constexpr double kPictureWidth = 640.0, kPictureLeft = 74.0, kPictureRight = 104.0,
                 kPictureTop = 44.0, kPictureFoot = 54.0;  // px
constexpr double kBeyond = 16.0;  // px of tooth drawn beyond the usable flank

}  // namespace

FlankFrame frame_of(const FlankRaster& raster, bool internal, double left, double right, double top,
                    double low, double high) {
  const double face = raster.height.back() - raster.height.front();
  const double deep = (raster.diameter.back() - raster.diameter.front()) / 2;
  const double scale = (right - left) / face;
  const double tall = std::clamp(scale * deep, low, high);
  const double foot = top + tall;
  return {{raster.height.front(), raster.height.back(), left, right},
          {raster.diameter.front() / 2, raster.diameter.back() / 2, internal ? top : foot,
           internal ? foot : top},
          internal,
          tall / (scale * deep)};
}

FlankFrame frame_of(const FlankRaster& raster, bool internal, double low) {
  return frame_of(raster, internal, kPictureLeft, kPictureWidth - kPictureRight,
                  kPictureTop + kBeyond, low, kHighFlank);
}

std::function<Vec2(const Vec2&)> nodes_px(const FlankRaster& raster, const FlankFrame& f) {
  const double columns = static_cast<double>(raster.height.size() - 1);
  const double rows = static_cast<double>(raster.diameter.size() - 1);
  return [=](const Vec2& node) -> Vec2 {
    return {f.z.from + node.x() / columns * (f.z.to - f.z.from),
            f.rho.from + node.y() / rows * (f.rho.to - f.rho.from)};
  };
}

Svg flank_picture(std::string_view id, const FlankFrame& f, std::size_t which,
                  std::string_view title, std::string_view description) {
  Svg svg(id, kPictureWidth, f.bottom() + kBeyond + kPictureFoot, title, description);
  const std::string n = std::to_string(which + 1);
  const double wide = f.z.to - f.z.from;
  svg.rect(f.z.from, f.top() - kBeyond, wide, f.bottom() - f.top() + 2 * kBeyond, "slice");
  svg.rect(f.z.from, f.top(), wide, f.bottom() - f.top(), "flank-ground");
  svg.text({12, 20}, "diameter, mm", Anchor::start, "panel");
  const Ticks ticks = round_ticks(2 * f.rho.lo, 2 * f.rho.hi, 5);
  for (const double d : ticks.values) {
    svg.line({f.z.from - 4, f.rho(d / 2)}, {f.z.to, f.rho(d / 2)}, "grid");
    svg.text({f.z.from - 8, f.rho(d / 2) + 4}, fixed(d, ticks.decimals), Anchor::end, "tick");
  }
  draw_foot(svg, f.z, f.top(), f.bottom() + kBeyond, 8, "along the face from its middle, mm");
  const double tip = f.rho(f.internal ? f.rho.lo : f.rho.hi);
  const double root = f.rho(f.internal ? f.rho.hi : f.rho.lo);
  for (const auto& [y, symbol, radius, word] :
       {std::tuple(tip, "d_Fa" + n, f.internal ? f.rho.lo : f.rho.hi, "tip"),
        std::tuple(root, "d_Ff" + n, f.internal ? f.rho.hi : f.rho.lo, "root")}) {
    svg.line({f.z.from, y}, {f.z.to + 6, y}, "limit");
    const bool up = y < (tip + root) / 2;
    svg.text({f.z.to + 12, y + (up ? 4 : 0)}, symbol_svg(symbol));
    svg.text({f.z.to + 12, y + (up ? 21 : -17)}, fixed(2 * radius, 2), Anchor::start, "tick");
    svg.text({f.z.from + 6, y + (up ? -4 : 13)}, word, Anchor::start, "inzone");
  }
  for (const double z : {f.z.from, f.z.to}) svg.line({z, f.top()}, {z, f.bottom()}, "limit");
  svg.begin_clip(f.z.from, f.top(), f.z.to - f.z.from, f.bottom() - f.top());
  return svg;
}

std::string proportions(const FlankFrame& f) {
  if (std::abs(f.taller - 1) < 0.02) return "True proportions.";
  return fmt::format("Heights are drawn {} times larger than widths.", fixed(f.taller, 1));
}

}  // namespace gearwright
