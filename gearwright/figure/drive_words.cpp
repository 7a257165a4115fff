#include "gearwright/figure/drive_words.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

std::string torque_text(double Nm) {
  return std::abs(Nm) < 99999.5 ? fmt::format("{:.5g} N m", Nm)
                                : fmt::format("{:.5g} kN m", Nm / 1e3);
}

std::string symbol_text(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 3, "_in") == 0) {
      out += "<tspan class=\"s\" dy=\"3\">in</tspan>";
      i += 2;
    } else
      out += text[i];
  }
  return out;
}

}  // namespace

std::vector<std::string> end_words(const Drive& drive, std::size_t body) {
  const DriveGraph& graph = drive.graph;
  const char* part = graph.is_input(body) ? "in" : graph.output == body ? "out" : "held";
  std::vector<std::string> lines;
  const bool rack = graph.moves(body);
  if (!graph.is_fixed(body)) {
    if (const auto v = drive.linear_speed(body))
      lines.push_back(fmt::format("{:.4g} m/s", *v));
    else if (const auto n = drive.speed_rpm(body); n && !rack)
      lines.push_back(fmt::format("{:.5g} /min", *n));
    else if (const auto ratio = drive.speed_ratio(body))
      lines.push_back(rack ? fmt::format("{:.4g} pitches per turn", *ratio)
                           : fmt::format("n {:.4g} n_in", *ratio));
  }
  if (rack) {
    if (const auto force = drive.force(body)) lines.push_back(fmt::format("{:.5g} N", *force));
  } else if (drive.flow && !drive.flow->self_locking()) {
    const double t = drive.flow->torque[body];
    const auto& given = graph.torque_Nm;
    lines.push_back(given ? torque_text(t * *given) : fmt::format("T {:.4g} T_in", t));
  }
  for (std::string& line : lines) line = symbol_text(line);
  lines.insert(lines.begin(), fmt::format("{} {}", escaped(graph.bodies[body].name), part));
  return lines;
}

}  // namespace gearwright
