#include "gearwright/catalogue/figure_units.hpp"

#include <utility>

namespace gearwright {

namespace {

class FigureConverter {
 public:
  FigureConverter(UnitSystem units, Figure& figure)
      : units_(units), f_(figure), x_(units, figure.x.unit), y_(units, figure.y.unit) {}

  void convert() {
    for (std::string* text : {&f_.title, &f_.description, &f_.caption, &f_.note}) words(*text);
    axis(f_.x, x_);
    axis(f_.y, y_);
    for (FigureMark& m : f_.marks) mark(m);
    for (FigureLane& lane : f_.lanes) {
      for (FigureLane::Block& block : lane.blocks) {
        block.from = x_(block.from);
        block.to = x_(block.to);
        words(block.words);
      }
    }
    for (FigureKey& key : f_.keys) words(key.words);
    if (f_.grid) grid(*f_.grid);
    if (f_.slide) {
      f_.slide->at = at(f_.slide->at);
      f_.slide->step = at(f_.slide->step);
    }
    for (FigureLeader& leader : f_.leaders) {
      leader.at = at(leader.at);
      length(leader.length);
    }
    for (FigureGroup& group : f_.groups) group.about = at(group.about);
  }

 private:
  Vec2 at(const Vec2& p) const { return {x_(p.x()), y_(p.y())}; }
  void words(std::string& text) const { text = sentence_in(units_, text); }

  void axis(FigureAxis& axis, const TextUnit& unit) const {
    axis.lo = unit(axis.lo);
    axis.hi = unit(axis.hi);
    for (AxisName& name : axis.names) name.at = unit(name.at);
    words(axis.words);
    axis.unit = unit.text();
  }

  void length(std::optional<FigureLength>& length) const {
    if (!length) return;
    const TextUnit unit(units_, length->unit);
    *length = {unit(length->value), unit.digits(length->decimals), unit.text(), length->zeros};
  }

  void mark(FigureMark& m) const {
    for (Vec2& p : m.points) p = at(p);
    if (m.kind == FigureMark::Kind::circle || m.kind == FigureMark::Kind::shape)
      m.radius = x_(m.radius);
    if (m.kind != FigureMark::Kind::shape) words(m.words);
    words(m.label);
    length(m.length);
  }

  void grid(FigureGrid& grid) {
    const TextUnit unit(units_, grid.unit);
    for (double& v : grid.x) v = x_(v);
    for (double& v : grid.y) v = y_(v);
    for (double& v : grid.values) v = unit(v);
    if (f_.shades)
      for (double& v : f_.shades->levels) v = unit(v);
    words(grid.words);
    grid.unit = unit.text();
  }

  UnitSystem units_;
  Figure& f_;
  TextUnit x_, y_;
};

}  // namespace

TextUnit::TextUnit(UnitSystem units, std::string_view unit) : units_(units), rest_(unit) {
  if (units == UnitSystem::mm) return;
  for (const Unit one : units_to_convert()) {
    const std::string_view text = unit_text(one);
    if (!unit.starts_with(text)) continue;
    std::string_view rest = unit.substr(text.size());
    const bool square = rest.starts_with("²");
    if (square) rest.remove_prefix(std::string_view("²").size());
    if (!rest.empty() && rest.front() != ',') continue;
    unit_ = one;
    power_ = square ? 2 : 1;
    rest_ = unit.substr(text.size());
    return;
  }
}

double TextUnit::operator()(double value) const {
  for (int k = 0; k < power_; ++k) value = value_in(units_, unit_, value);
  return value;
}

int TextUnit::digits(int decimals) const {
  for (int k = 0; k < power_; ++k) decimals = digits_in(units_, unit_, decimals);
  return decimals;
}

std::string TextUnit::text() const {
  return unit_ == Unit::none ? rest_ : std::string(unit_text(units_, unit_)) + rest_;
}

Figure in_units(UnitSystem units, Figure figure) {
  if (units != UnitSystem::mm) FigureConverter(units, figure).convert();
  return figure;
}

std::optional<Figure> in_units(UnitSystem units, std::optional<Figure> figure) {
  if (figure) *figure = in_units(units, std::move(*figure));
  return figure;
}

}  // namespace gearwright
