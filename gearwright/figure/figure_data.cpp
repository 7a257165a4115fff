#include "gearwright/figure/figure_data.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/figure/markup.hpp"

namespace gearwright {

nlohmann::ordered_json figure_data(const Figure& figure) {
  using Json = nlohmann::ordered_json;
  const auto axis = [](const FigureAxis& a) { return Json{{"words", a.words}, {"unit", a.unit}}; };
  const auto point = [](const Vec2& p) {
    return is_new_piece(p) ? Json{nullptr, nullptr} : Json{p.x(), p.y()};
  };
  Json curves = Json::array();
  Json bars = Json::array(), circles = Json::array(), points = Json::array();
  for (const FigureMark& m : figure.marks) {
    if (m.kind == FigureMark::Kind::circle)
      circles.push_back({{"gear", m.gear},
                         {"name", m.words},
                         {"center", point(m.points[0])},
                         {"radius", m.radius}});
    if (m.kind == FigureMark::Kind::dot && !(m.text().empty() && m.words.empty()))
      points.push_back({{"name", m.text().empty() ? m.words : without_tags(m.text())},
                        {"at", point(m.points[0])}});
    if (m.words.empty()) continue;
    if (m.kind == FigureMark::Kind::bar)
      bars.push_back({0.5 * (m.points[0].x() + m.points[1].x()), m.points[1].y()});
    if (m.kind != FigureMark::Kind::line) continue;
    Json of = Json::array();
    for (const Vec2& p : m.points) of.push_back(point(p));
    curves.push_back({{"name", m.words}, {"points", std::move(of)}});
  }
  if (!bars.empty()) curves.push_back({{"name", figure.y.words}, {"points", std::move(bars)}});
  Json data{{"id", figure.id},     {"title", figure.title}, {"description", figure.description},
            {"x", axis(figure.x)}, {"y", axis(figure.y)},   {"curves", std::move(curves)}};
  if (!circles.empty()) data["circles"] = std::move(circles);
  if (!points.empty()) data["points"] = std::move(points);
  if (const auto& grid = figure.grid) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < grid->values.size(); ++i) {
      if (i % grid->x.size() == 0) rows.push_back(Json::array());
      const double v = grid->values[i];
      rows.back().push_back(std::isfinite(v) ? Json(v) : Json());
    }
    data["grid"] = {{"words", grid->words},
                    {"unit", grid->unit},
                    {"x", grid->x},
                    {"y", grid->y},
                    {"values", std::move(rows)}};
  }
  return data;
}

}  // namespace gearwright
