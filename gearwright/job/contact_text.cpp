#include "gearwright/job/contact_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/job/fixed_text.hpp"

namespace gearwright {

namespace {

constexpr double kDeg = 180 / std::numbers::pi;
constexpr double kArcsec = 3600 * kDeg;

Json point_json(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

Json position_json(const ContactPoint& p) {
  Json j;
  j["rotation1_deg"] = p.rotation1 * kDeg;
  const bool touches = p.kind != TouchKind::none;
  const auto when = [&](auto value) { return touches ? Json(std::move(value)) : Json(nullptr); };
  j["rotation2_deg"] = when(p.rotation2 * kDeg);
  j["transmission_error_arcsec"] = when(p.te * kArcsec);
  j["tooth"] = when(p.pair);
  j["kind"] = when(std::string(to_string(p.kind)));
  j["point_mm"] = when(point_json(p.point));
  j["normal"] = when(point_json(p.normal));
  j["diameter_mm"] = when(Json{p.diameter[0], p.diameter[1]});
  j["height_mm"] = when(Json{p.height[0], p.height[1]});
  j["rack_angle_deg"] = p.rack_angle ? Json(*p.rack_angle * kDeg) : Json(nullptr);
  j["gap_curvature_per_mm"] =
      p.gap_curvature ? Json{(*p.gap_curvature)[0], (*p.gap_curvature)[1]} : Json(nullptr);
  j["ellipse"] = nullptr;
  if (p.ellipse) {
    j["ellipse"] = {
        {"semi_major_mm", p.ellipse->semi_major ? Json(*p.ellipse->semi_major) : Json(nullptr)},
        {"semi_minor_mm", p.ellipse->semi_minor},
        {"angle_deg", p.ellipse->angle * kDeg}};
  }
  j["line_mm"] = p.line ? Json{point_json((*p.line)[0]), point_json((*p.line)[1])} : Json(nullptr);
  return j;
}

Json sensitivity_json(const ContactAnswer& answer) {
  Json j = Json::object();
  const auto& named = answer.setup.influences();
  for (std::size_t i = 0; i < named.size(); ++i) {
    Json te = Json::array();
    Json points = Json::array();
    for (std::size_t k = 0; k < answer.driving.positions.size(); ++k) {
      const Sensitivity& s = answer.driving.sensitivities[i][k];
      const TouchKind kind = answer.driving.positions[k].kind;
      te.push_back(kind == TouchKind::none ? Json(nullptr) : Json(s.te * named[i].unit * kArcsec));
      // Along a line of contact no point is the contact point.
      const bool point = kind != TouchKind::none && kind != TouchKind::line;
      points.push_back(point ? point_json(s.point * named[i].unit) : Json(nullptr));
    }
    j[named[i].key] = {{"transmission_error_arcsec", te}, {"point_mm", points}};
  }
  return j;
}

Json map_json(const ContactMapInput& input, const ErrorMap& map) {
  Json rows = Json::array();
  for (const auto& row : map.value) {
    Json line = Json::array();
    for (const double v : row) line.push_back(std::isnan(v) ? Json(nullptr) : Json(v * kArcsec));
    rows.push_back(std::move(line));
  }
  return {{"x", kErrorKeys[input.key[0]]},
          {"x_values", map.x},
          {"y", kErrorKeys[input.key[1]]},
          {"y_values", map.y},
          {"peak_to_peak_arcsec", std::move(rows)}};
}

// A raster with the share of the flank that the compound would mark.
Json raster_json(const FlankRaster& r, double marking) {
  Json rows = Json::array();
  std::size_t marked = 0;
  for (std::size_t i = 0; i < r.diameter.size(); ++i) {
    Json row = Json::array();
    for (std::size_t k = 0; k < r.height.size(); ++k) {
      const double gap = r.at(i, k);
      row.push_back(std::isfinite(gap) ? Json(gap) : Json(nullptr));
      if (gap <= marking) ++marked;
    }
    rows.push_back(std::move(row));
  }
  return {{"diameter_mm", r.diameter},
          {"height_mm", r.height},
          {"gap_mm", std::move(rows)},
          {"marked", static_cast<double>(marked) / static_cast<double>(r.gap.size())}};
}

std::string kinds_of(const ContactResult& result) {
  std::vector<std::pair<TouchKind, int>> count;
  for (const ContactPoint& p : result.positions) {
    const auto it =
        std::find_if(count.begin(), count.end(), [&](const auto& c) { return c.first == p.kind; });
    if (it == count.end()) {
      count.emplace_back(p.kind, 1);
    } else {
      ++it->second;
    }
  }
  std::string text;
  for (const auto& [kind, n] : count) {
    text += fmt::format("{}{} {} %", text.empty() ? "" : ", ", to_string(kind),
                        std::lround(100.0 * n / static_cast<double>(result.positions.size())));
  }
  return text;
}

}  // namespace

Json contact_json(const SolvedJob& job, const ContactAnswer& answer) {
  Json positions = Json::array();
  for (const ContactPoint& p : answer.driving.positions) positions.push_back(position_json(p));
  Json harmonics = Json::array();
  for (const double h : answer.driving.harmonics) harmonics.push_back(h * kArcsec);
  Json other = Json::array();
  Json kinds = Json::array();
  for (const ContactPoint& p : answer.other.positions) {
    const bool touches = p.kind != TouchKind::none;
    other.push_back(touches ? Json(p.te * kArcsec) : Json(nullptr));
    kinds.push_back(touches ? Json(std::string(to_string(p.kind))) : Json(nullptr));
  }
  Json c;
  c["positions"] = std::move(positions);
  c["peak_to_peak_arcsec"] = answer.driving.peak_to_peak * kArcsec;
  c["mean_slope"] = answer.driving.mean_slope;
  c["harmonics_arcsec"] = std::move(harmonics);
  c["contact_lost"] = answer.driving.contact_lost;
  c["other_flank"] = {{"transmission_error_arcsec", std::move(other)},
                      {"kind", std::move(kinds)},
                      {"peak_to_peak_arcsec", answer.other.peak_to_peak * kArcsec},
                      {"contact_lost", answer.other.contact_lost}};
  c["least_play_deg"] = answer.least_play ? Json(*answer.least_play * kDeg) : Json(nullptr);
  c["sensitivity"] = sensitivity_json(answer);
  if (answer.pattern) {
    const double marking = job.spec.contact.marking;
    c["pattern"] = {{"gear1", raster_json((*answer.pattern)[0], marking)},
                    {"gear2", raster_json((*answer.pattern)[1], marking)}};
  }
  if (answer.map) c["map"] = map_json(*job.spec.contact.map, *answer.map);
  Json j;
  if (!job.spec.title.empty()) j["title"] = job.spec.title;
  j["contact"] = std::move(c);
  j["warnings"] = warnings_json(job.warnings);
  return j;
}

std::string contact_listing(const SolvedJob& job, const ContactAnswer& answer) {
  const ContactResult& r = answer.driving;
  std::string out;
  if (!job.spec.title.empty()) out += job.spec.title + "\n";
  out += "\nTooth contact\n";
  const auto row = [&](const char* what, const std::string& value) {
    out += fmt::format("  {:<42}{}\n", what, value);
  };
  for (std::size_t i = 0; i < kErrorKeys.size(); ++i) {
    if (job.spec.errors.value[i] != 0.0)
      row(fmt::format("errors.{}", kErrorKeys[i]).c_str(),
          fmt::format("{}", job.spec.errors.value[i]));
  }
  row("Transmission error, peak to peak", fixed_text(r.peak_to_peak * kArcsec, 4) + " arcsec");
  row("  the other flanks", fixed_text(answer.other.peak_to_peak * kArcsec, 4) + " arcsec");
  if (answer.least_play)
    row("Least play of gear 2", fixed_text(*answer.least_play * kDeg, 6) + " °");
  row("Contact", kinds_of(r));
  if (!r.harmonics.empty()) {
    std::string waves;
    for (std::size_t i = 0; i < std::min<std::size_t>(5, r.harmonics.size()); ++i)
      waves += fmt::format("{}{:.4f}", i ? ", " : "", r.harmonics[i] * kArcsec);
    row("Harmonics 1 to 5, amplitudes", waves + " arcsec");
  }
  out +=
      fmt::format("\n  {:>11}{:>15}{:>7}  {:<9}{:>11}{:>11}{:>10}{:>10}{:>11}{:>11}\n", "rotation1",
                  "TE", "tooth", "kind", "diam. 1", "diam. 2", "z 1", "z 2", "major", "minor");
  out += fmt::format("  {:>11}{:>15}{:>7}  {:<9}{:>11}{:>11}{:>10}{:>10}{:>11}{:>11}\n", "°",
                     "arcsec", "", "", "mm", "mm", "mm", "mm", "mm", "mm");
  // A page of them; --json has all.
  const std::size_t step = std::max<std::size_t>(1, r.positions.size() / 32);
  for (std::size_t i = 0; i < r.positions.size(); i += step) {
    const ContactPoint& p = r.positions[i];
    if (p.kind == TouchKind::none) {
      out += fmt::format("  {:>11.4f}{:>15}\n", p.rotation1 * kDeg, "no contact");
      continue;
    }
    const std::string major =
        p.ellipse && p.ellipse->semi_major ? fixed_text(*p.ellipse->semi_major, 4) : "-";
    const std::string minor = p.ellipse ? fixed_text(p.ellipse->semi_minor, 4) : "-";
    out +=
        fmt::format("  {:>11}{:>15}{:>7}  {:<9}{:>11}{:>11}{:>10}{:>10}{:>11}{:>11}\n",
                    fixed_text(p.rotation1 * kDeg, 4), fixed_text(p.te * kArcsec, 5), p.pair,
                    to_string(p.kind), fixed_text(p.diameter[0], 4), fixed_text(p.diameter[1], 4),
                    fixed_text(p.height[0], 4), fixed_text(p.height[1], 4), major, minor);
  }
  return out;
}

}  // namespace gearwright
