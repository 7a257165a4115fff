#include <algorithm>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/drive_quantities.hpp"

namespace gearwright {

namespace {

Value micrometres(const std::optional<double>& mm) { return mm ? Value(*mm * kUmPerMm) : Value(); }

template <class Of>
ValueList of_planets(const PlanetShares& shares, const Of& of) {
  ValueList list;
  for (std::size_t i = 0; i < shares.share.size(); ++i) list.emplace_back(of(i));
  return list;
}

}  // namespace

const Quantities<PlanetSharesView>& planet_share_quantities() {
  using V = PlanetSharesView;
  return define("drive.load.set", [](Quantities<V>& q) {
    q.text("carrier", "name of the carrier", [](const V& v) {
      return v.drive->graph.bodies[v.drive->sets[v.shares->set].group.carrier].name;
    });
    q.number("mesh_load_factor", "mesh load factor", "K_γ",
             "number of planets times the greatest share [T13.26]",
             [](const V& v) { return v.shares->mesh_load_factor().second; });
    q.number("mesh_load_factors", "mesh load factor of each mesh", "K_γ",
             "in the order of the loaded meshes; null if all meshes have the same shares",
             [](const V& v) -> Value {
               // Factors with a relative difference of at most kSame count as equal. The
               // differences that the residual of the equilibrium causes are far smaller.
               constexpr double kSame = 1e-6;
               ValueList list;
               bool same = true;
               for (const auto& [mesh, factor] : v.shares->mesh_load_factors) {
                 list.emplace_back(factor);
                 same = same && factor >= (1 - kSame) * v.shares->mesh_load_factor().second;
               }
               return same ? Value() : Value(std::move(list));
             })
        .list({0});
    q.number("share_mean", "mean share of each planet", "",
             "load of a planet divided by the load of all planets, averaged over a period",
             [](const V& v) {
               return of_planets(*v.shares, [&](std::size_t i) { return v.shares->mean(i); });
             });
    q.number("share_max", "greatest share of each planet", "", "greatest value within a period",
             [](const V& v) {
               return of_planets(*v.shares, [&](std::size_t i) { return v.shares->greatest[i]; });
             });
    q.number("share_min", "least share of each planet", "",
             "least value within a period; 0 if the planet loses contact", [](const V& v) {
               return of_planets(*v.shares, [&](std::size_t i) { return v.shares->least[i]; });
             });
    q.number("shares", "load shares of the planets", "",
             "share of each planet at each position of the period. If the meshes have several "
             "frequencies, the positions are those of the first frequency, and the shares are "
             "averaged over the positions of the other frequencies",
             [](const V& v) {
               return of_planets(*v.shares, [&](std::size_t i) {
                 return ValueList(v.shares->share[i].begin(), v.shares->share[i].end());
               });
             })
        .list({0, 0})
        .doors(kJson);
    q.text("floating", "name of the body that floats; null if no body floats",
           [](const V& v) -> Value {
             if (!v.shares->floating) return {};
             return v.drive->graph.bodies[*v.shares->floating].name;
           });
    q.number("displacement_um", "greatest displacement of the floating body", "",
             "distance from the axis of the carrier; null if no body floats",
             [](const V& v) { return micrometres(v.shares->greatest_displacement); });
    q.number("displacement_x_um", "displacement of the floating body", "",
             "component towards the first planet at each position, in the frame of the carrier",
             [](const V& v) -> Value {
               if (!v.shares->floating) return {};
               ValueList list;
               for (const Vec2& d : v.shares->displacement) list.emplace_back(d.x() * kUmPerMm);
               return list;
             })
        .list({0})
        .doors(kJson);
    q.number("displacement_y_um", "displacement of the floating body", "",
             "component 90° counter-clockwise from x at each position, in the frame of the carrier",
             [](const V& v) -> Value {
               if (!v.shares->floating) return {};
               ValueList list;
               for (const Vec2& d : v.shares->displacement) list.emplace_back(d.y() * kUmPerMm);
               return list;
             })
        .list({0})
        .doors(kJson);
  });
}

namespace {

const Quantities<LoadedDrive::Curve>& loaded_curve_quantities() {
  using C = LoadedDrive::Curve;
  return define("drive.load.curve", [](Quantities<C>& q) {
    q.term("frequency_ratio", "", &C::frequency_ratio);
    const auto seconds = [](const std::vector<double>& radians) {
      ValueList list;
      for (const double r : radians) list.emplace_back(Angle::radians(r).arcsec());
      return list;
    };
    q.number("loaded_arcsec", "rotation error under load", "",
             "deviation of the output from its mean rotation at each position of the period. For "
             "stepped planets, the deviation is averaged over the positions of the other meshes",
             [seconds](const C& c) { return seconds(c.loaded); });
    q.number("rigid_arcsec", "rotation error of rigid teeth", "",
             "as `loaded_arcsec`, but for rigid teeth and equal shares",
             [seconds](const C& c) { return seconds(c.rigid); });
  });
}

}  // namespace

const Quantities<Drive>& drive_load_quantities() {
  return define("drive.load", [](Quantities<Drive>& q) {
    q.number("torque_Nm", "torque on the input", "T", "",
             [](const Drive& d) { return d.loaded->torque; });
    q.number("output_arcsec_peak_to_peak", "transmission error of the output under load", "",
             "greatest value minus least value; for meshes of several frequencies that share no "
             "planet, the sum of these differences",
             [](const Drive& d) { return Angle::radians(d.loaded->error.peak_to_peak).arcsec(); })
        .unit(Unit::arcsec);
    q.number("rigid_arcsec_peak_to_peak", "transmission error of the output with rigid teeth", "",
             "peak-to-peak value of `transmission_error`",
             [](const Drive& d) -> Value {
               if (!d.error) return {};
               return Angle::radians(d.error->peak_to_peak).arcsec();
             })
        .unit(Unit::arcsec);
    q.record<drive_error_line_quantities>(
         "lines", "harmonics of the mesh frequencies under load",
         [](const Drive& d) { return error_lines(d.loaded->error); })
        .doors(kJson);
    q.number("mesh_load_factor", "greatest mesh load factor", "K_γ",
             "greatest value over all sets [T13.26]; null without planets", mesh_load_factor)
        .doors(kJson);
    q.number("rated_mesh_load_factor", "mesh load factor of the rating", "K_γ",
             "factor that the rating uses, from `rating.mesh_load_factor`; null without a rating",
             rated_mesh_load_factor);
    q.record<planet_share_quantities>("sets", "one entry for each set: load shares of its planets",
                                      [](const Drive& d) {
                                        std::vector<PlanetSharesView> list;
                                        for (const PlanetShares& s : d.loaded->sets)
                                          list.push_back({&d, &s});
                                        return list;
                                      })
        .doors(kJson);
    q.record<loaded_curve_quantities>(
         "curves", "rotation error over a period of each mesh frequency",
         [](const Drive& d) -> const auto& { return d.loaded->curves; })
        .doors(kJson);
  });
}

std::optional<double> mesh_load_factor(const Drive& drive) {
  if (!drive.loaded || drive.loaded->sets.empty()) return std::nullopt;
  double greatest = 1.0;
  for (const PlanetShares& s : drive.loaded->sets)
    greatest = std::max(greatest, s.mesh_load_factor().second);
  return greatest;
}

std::optional<double> rated_mesh_load_factor(const Drive& drive) {
  std::optional<double> rated;
  for (const auto& rating : drive.ratings)
    if (rating) rated = std::max(rated.value_or(1.0), rating->input.mesh_load_factor);
  return rated;
}

}  // namespace gearwright
