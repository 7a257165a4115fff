#include "gearwright/contact/error_map.hpp"

#include "gearwright/base/parallel.hpp"
#include "gearwright/contact/contact.hpp"

namespace gearwright {

ErrorMap map_of_errors(const std::vector<double>& x, const std::vector<double>& y,
                       const std::function<std::vector<double>(double, double)>& te_at, int threads,
                       Progress* progress) {
  GW_EXPECTS(!x.empty() && !y.empty() && threads >= 0);
  ErrorMap map{x, y, std::vector<std::vector<double>>(y.size(), std::vector<double>(x.size()))};
  begin_stage(progress, "computing the map of two errors",
              static_cast<std::int64_t>(x.size() * y.size()));
  const auto row = [&](std::size_t i) {
    for (std::size_t k = 0; k < x.size(); ++k) {
      map.value[i][k] = peak_to_peak(te_at(x[k], y[i]));
      count_step(progress);
    }
  };
  parallel_for(y.size(), row, threads);
  return map;
}

}  // namespace gearwright
