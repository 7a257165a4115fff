#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/drive_figures.hpp"
#include "gearwright/figure/load_scene.hpp"

namespace gearwright {

namespace {

constexpr double kCircle = 360.0;  // degrees

// Returns the rotation of the input during one period of a mesh, degrees. If the gears of the mesh
// do not roll, the result is one turn of the input.
double period_of(double frequency_ratio) {
  constexpr double kLeast = 1e-9;  // teeth per turn of the input; below this, no mesh rolls
  return std::abs(frequency_ratio) > kLeast ? kCircle / std::abs(frequency_ratio) : kCircle;
}

// Returns the rotation of the input during one period of the meshes of a set, degrees.
double period_of(const Drive& drive, const PlanetShares& shares) {
  for (const std::size_t m : drive.sets[shares.set].group.meshes)
    if (drive.flow && drive.flow->driver[m] >= 0)
      if (const auto teeth = drive.frequency_ratio(m)) return period_of(*teeth);
  return kCircle;
}

// Returns the values at the positions of one period, with the first value repeated at the end of
// the period.
template <class Of>
std::vector<Vec2> over_the_period(double period, std::size_t count, const Of& of) {
  std::vector<Vec2> points;
  for (std::size_t j = 0; j <= count; ++j)
    points.push_back({period * static_cast<double>(j) / static_cast<double>(count), of(j % count)});
  return points;
}

// Fits the axes to all curves. If the values hardly vary, the y axis gets the length `least`.
Figure fitted(Figure f, double least) {
  fit_axes(f);
  if (f.y.hi - f.y.lo >= least) return f;
  const double middle = (f.y.lo + f.y.hi) / 2;
  f.y.lo = middle - least / 2;
  f.y.hi = middle + least / 2;
  return f;
}

// Returns " of CARRIER" as the end of a title, or nothing if there is only one set.
std::string of_set(const Drive& drive, const PlanetShares& shares) {
  if (drive.loaded->sets.size() < 2) return "";
  return " of " + drive.graph.bodies[drive.sets[shares.set].group.carrier].name;
}

std::string suffix(std::size_t index) { return index == 0 ? "" : fmt::format("-{}", index + 1); }

}  // namespace

Figure planet_share_figure(const Drive& drive, std::size_t set) {
  GW_EXPECTS(drive.loaded && set < drive.loaded->sets.size());
  const PlanetShares& shares = drive.loaded->sets[set];
  const double period = period_of(drive, shares);
  Figure f{.id = "planet-share" + suffix(set),
           .title = "Load of the planets" + of_set(drive, shares),
           .description = "Share of each planet in the load of all planets over one period.",
           .caption =
               ", as shares of the load of all planets, over one period of the meshes. The thin "
               "line shows an equal share.",
           .x = {"rotation of the input", "°"},
           .y = {"share of the load", ""}};
  const auto count = static_cast<double>(shares.share.size());
  for (std::size_t i = 0; i < shares.share.size(); ++i) {
    const std::string words = fmt::format("planet {}", i + 1);
    f.line(over_the_period(period, shares.share[i].size(),
                           [&](std::size_t j) { return shares.share[i][j]; }),
           "curve " + curve_style(i), words);
    f.keys.push_back({"line " + curve_style(i), words});
  }
  f.line({{0.0, 1 / count}, {period, 1 / count}}, "one", "equal share");
  f.note = fmt::format("K_γ = {:.3f}", shares.mesh_load_factor().second);
  constexpr double kLeast = 0.05;
  f = fitted(std::move(f), kLeast);
  f.y.lo = std::max(f.y.lo, 0.0);
  return f;
}

std::optional<Figure> displacement_figure(const Drive& drive, std::size_t set) {
  GW_EXPECTS(drive.loaded && set < drive.loaded->sets.size());
  const PlanetShares& shares = drive.loaded->sets[set];
  if (!shares.floating || shares.displacement.empty()) return std::nullopt;
  const double period = period_of(drive, shares);
  const std::string name = drive.graph.bodies[*shares.floating].name;
  Figure f{.id = "floating-displacement" + suffix(set),
           .title = "Displacement of " + name,
           .description =
               "Components of the displacement in the frame of the carrier over one "
               "period.",
           .caption =
               " in the frame of the carrier. The x axis points to the first planet, and the y "
               "axis is a quarter turn counter-clockwise from x.",
           .x = {"rotation of the input", "°"},
           .y = {"displacement", "µm"}};
  for (const int c : {0, 1}) {
    const auto style = curve_style(static_cast<std::size_t>(c));
    f.line(over_the_period(period, shares.displacement.size(),
                           [&](std::size_t j) { return shares.displacement[j][c] * kUmPerMm; }),
           "curve " + style, c == 0 ? "x" : "y");
    f.keys.push_back({"line " + style, c == 0 ? "x" : "y"});
  }
  f.note = fmt::format("at most {:.1f} µm", *shares.greatest_displacement * kUmPerMm);
  constexpr double kLeast = 0.1;
  return fitted(std::move(f), kLeast);
}

Figure loaded_output_figure(const Drive& drive, std::size_t curve) {
  GW_EXPECTS(drive.loaded && curve < drive.loaded->curves.size());
  const LoadedDrive::Curve& c = drive.loaded->curves[curve];
  const double period = period_of(c.frequency_ratio);
  Figure f{
      .id = "loaded-output" + suffix(curve),
      .title = "Transmission error of the output",
      .description =
          "Two curves of the transmission error of the output over one period of the meshes, one "
          "for teeth under load and one for rigid teeth. Each curve is relative to its mean.",
      .caption = fmt::format(" over one period of the meshes with {:.4g} teeth per turn of the "
                             "input, each curve relative to its mean.",
                             c.frequency_ratio),
      .x = {"rotation of the input", "°"},
      .y = {"transmission error", "arc seconds"}};
  const auto seconds = [](const std::vector<double>& of) {
    return [&of](std::size_t j) { return Angle::radians(of[j]).arcsec(); };
  };
  f.line(over_the_period(period, c.loaded.size(), seconds(c.loaded)), "curve ink", "under load");
  f.line(over_the_period(period, c.rigid.size(), seconds(c.rigid)), "before", "rigid teeth");
  f.keys = {{"ink", "under load"}, {"before", "rigid teeth"}};
  constexpr double kLeast = 0.01;
  return fitted(std::move(f), kLeast);
}

std::vector<Figure> drive_load_figures(const Drive& drive) {
  std::vector<Figure> figures;
  if (!drive.loaded) return figures;
  const LoadedDrive& loaded = *drive.loaded;
  for (std::size_t s = 0; s < loaded.sets.size(); ++s) {
    if (loaded.sets[s].share.size() < 2) continue;
    figures.push_back(planet_share_figure(drive, s));
    if (auto figure = displacement_figure(drive, s)) figures.push_back(std::move(*figure));
  }
  for (std::size_t c = 0; c < loaded.curves.size(); ++c)
    figures.push_back(loaded_output_figure(drive, c));
  return figures;
}

}  // namespace gearwright
