#include "gearwright/catalogue/scatter_quantities.hpp"

namespace gearwright {

namespace {

struct DensityView {
  const FlankDensity* flank;
  std::int64_t samples;
};

const Quantities<DensityView>& flank_density_quantities() {
  using D = DensityView;
  return define("scatter.pattern gear", [](Quantities<D>& q) {
    q.term("diameter_mm", "diameters of the rows", [](const D& d) { return d.flank->diameter; });
    q.term("height_mm", "heights of the columns", [](const D& d) { return d.flank->height; });
    q.number("share", "share of the samples", "",
             "share of the samples whose pattern covers the place, 0 to 1",
             [](const D& d) {
               ValueList rows;
               const std::size_t columns = d.flank->height.size();
               for (std::size_t i = 0; i < d.flank->diameter.size(); ++i) {
                 ValueList row;
                 for (std::size_t k = 0; k < columns; ++k)
                   row.emplace_back(d.flank->share(i * columns + k, d.samples));
                 rows.push_back(std::move(row));
               }
               return rows;
             })
        .list({0, 0});
  });
}

}  // namespace

const Quantities<PatternDensity>& density_quantities() {
  using D = PatternDensity;
  return define("scatter.pattern", [](Quantities<D>& q) {
    q.term("marking_mm", "value in `[contact]`", &D::marking);
    q.add(Type::index, "samples", "number of samples", "",
          "the first samples of each replicate are used",
          [](const D& d) { return static_cast<long long>(d.samples); });
    const auto gear = [](std::size_t i) {
      return [i](const D& d) { return flank_density_quantities().of({&d.flanks[i], d.samples}); };
    };
    q.record<flank_density_quantities>("gear1", "the flank of gear 1", gear(0));
    q.record<flank_density_quantities>("gear2", "the flank of gear 2", gear(1));
  });
}

}  // namespace gearwright
