#include "gearwright/cad/sheet_page.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

constexpr double kInner = 6;  // mm, from the views to the frame

struct Scale {
  double paper, gear;
  double factor() const { return paper / gear; }
};
constexpr std::array<Scale, 18> kScales{{{50, 1},
                                         {20, 1},
                                         {10, 1},
                                         {5, 1},
                                         {2, 1},
                                         {1, 1},
                                         {1, 2},
                                         {1, 5},
                                         {1, 10},
                                         {1, 20},
                                         {1, 50},
                                         {1, 100},
                                         {1, 200},
                                         {1, 500},
                                         {1, 1000},
                                         {1, 2000},
                                         {1, 5000},
                                         {1, 10000}}};

struct TablePlace {
  SheetBox views;
  Vec2 data;
  int columns;
};

// An A4 sheet is in portrait format, with the views at the top and the data in two columns below
// the views. An A3 sheet is in landscape format, with the data to the right of the views.
TablePlace place_of(SheetSize size, const SheetBox& frame, const SheetBox& block,
                    const std::vector<DataGroup>& data) {
  if (size == SheetSize::a4) {
    const double top = block.hi.y() + kInner / 2 + data_size(data, 2).y();
    return {{{frame.lo.x(), top}, frame.hi}, {frame.lo.x(), top}, 2};
  }
  const double room = frame.hi.y() - block.hi.y() - kInner / 2;
  const int columns = data_size(data, 1).y() <= room ? 1 : 2;
  const double left = frame.hi.x() - data_size(data, columns).x();
  return {{{frame.lo.x(), block.hi.y()}, {left, frame.hi.y()}}, {left, frame.hi.y()}, columns};
}

}  // namespace

std::string length_text(UnitSystem units, double mm) {
  return units == UnitSystem::mm ? short_decimals(mm, 4)
                                 : fixed_decimals(value_in(units, Unit::mm, mm), 4);
}

std::string computed_length_text(UnitSystem units, double mm) {
  return length_text(units, units == UnitSystem::mm ? std::round(kUmPerMm * mm) / kUmPerMm : mm);
}

void SheetViews::add(Dimension d) {
  const bool up = d.direction == Direction::up;
  const Vec2 along(up ? origin_.y() : origin_.x(), up ? origin_.x() : origin_.y());
  for (double* x : {&d.begin, &d.end}) *x += along.x();
  for (double* x : {&d.edge_begin, &d.edge_end, &d.line}) *x += along.y();
  draw_dimension(*sheet_, d);
}

GearSheet on_page(const SheetInput& part, const std::string& datum, SheetSize size,
                  double deviation_mm,
                  const std::function<std::unique_ptr<SheetViews>(double)>& views_at) {
  const bool a4 = size == SheetSize::a4;
  Sheet sheet{a4 ? Vec2(210, 297) : Vec2(420, 297), {}, {}, {}};
  const SheetBox frame = draw_frame(sheet);
  const auto title_block = [&](Sheet& to, const std::string& scale) {
    return draw_title_block(to, frame, {part, scale, a4 ? "A4" : "A3", datum});
  };
  Sheet draft = sheet;
  const TablePlace place = place_of(size, frame, title_block(draft, ""), part.data);
  const Vec2 room = place.views.hi - place.views.lo - Vec2(2 * kInner, 2 * kInner);
  for (const Scale& scale : kScales) {
    const auto views = views_at(scale.factor());
    const SheetBox box = views->box();
    const Vec2 needed = box.hi - box.lo;
    const bool last = &scale == &kScales.back();
    if (!last && (needed.x() > room.x() || needed.y() > room.y())) continue;
    const std::string words = fmt::format("{:g}:{:g}", scale.paper, scale.gear);
    views->draw_at(sheet, place.views.lo + Vec2(kInner, kInner) + (room - needed) / 2 - box.lo);
    draw_data(sheet, place.data, part.data, place.columns);
    title_block(sheet, words);
    return GearSheet{std::move(sheet), words, scale.factor(), deviation_mm};
  }
  contract_failed("postcondition", "a scale", __FILE__, __LINE__);
}

}  // namespace gearwright
