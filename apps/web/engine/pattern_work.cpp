#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/web/engine/stopwatch.hpp"
#include "apps/web/engine/work.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/job/contact_report.hpp"

namespace gearwright::web {

namespace {

class PatternWork : public Work {
 public:
  PatternWork(std::shared_ptr<Session> session, int positions, const RasterSize& size)
      : Work(std::move(session)), positions_(positions), size_(size) {}

  // The first step uses a sixteenth of the nodes, the second step a quarter, and the third step all
  // nodes. All three steps together take at most a third longer than the third step alone.
  Result<Steps> step(double) override {
    constexpr int kSteps = 3;
    if (next_ == kSteps) return Steps{kSteps, kSteps, true};
    const int part = 1 << (kSteps - 1 - next_);
    const RasterSize size{std::max(2, size_.rows / part), std::max(2, size_.columns / part)};
    const auto patterns = session().pattern(std::max(2, positions_ / part), size);
    if (!patterns) return patterns.error();
    result_ = Json::array();
    for (const FlankRaster& raster : *patterns) result_.push_back(shape(raster));
    ++next_;
    return Steps{next_, kSteps, next_ == kSteps};
  }
  Json result() const override { return result_; }

 private:
  int positions_;
  RasterSize size_;
  int next_ = 0;
  Json result_;
};

class ErrorMapWork : public Work {
 public:
  ErrorMapWork(std::shared_ptr<Session> session, const std::array<std::size_t, 2>& keys,
               std::array<Numbers, 2> axes, int positions)
      : Work(std::move(session)),
        keys_(keys),
        axes_(std::move(axes)),
        peak_to_peak_arcsec_(axes_[0].size() * axes_[1].size(), kNoNumber),
        positions_(positions) {}

  Result<Steps> step(double milliseconds) override {
    const Stopwatch watch;
    Numbers& value = peak_to_peak_arcsec_;
    const std::size_t nx = axes_[0].size();
    while (next_ < value.size() && watch.ms() < milliseconds) {
      const auto te =
          session().te_under(keys_, {axes_[0][next_ % nx], axes_[1][next_ / nx]}, positions_);
      if (!te) return te.error();
      value[next_++] = Angle::radians(peak_to_peak(*te)).arcsec();
    }
    return Steps{static_cast<std::int64_t>(next_), static_cast<std::int64_t>(value.size()),
                 next_ == value.size()};
  }
  Json result() const override {
    return {{"x", row(axes_[0])},
            {"y", row(axes_[1])},
            {"peakToPeakArcsec", row(peak_to_peak_arcsec_)}};
  }
  Result<Json> figures(int, double width) const override {
    const auto& value = session().job().spec.errors.value;
    ContactMap map{{axes_[0], axes_[1], {}},
                   {named_error(keys_[0], value[keys_[0]]), named_error(keys_[1], value[keys_[1]])},
                   next_ == peak_to_peak_arcsec_.size()};
    const auto nx = static_cast<std::ptrdiff_t>(axes_[0].size());
    for (auto from = peak_to_peak_arcsec_.begin(); from != peak_to_peak_arcsec_.end(); from += nx) {
      map.map.value.emplace_back(from, from + nx);
      for (double& v : map.map.value.back()) v /= kArcsecPerRad;
    }
    return Json::array({session().drawn(error_map_figure(map), width)});
  }

 private:
  std::array<std::size_t, 2> keys_;  // indices of the errors in error_entries()
  std::array<Numbers, 2> axes_;
  Numbers peak_to_peak_arcsec_;  // [iy·nx + ix]; NaN if no teeth touch or if not yet computed
  int positions_;
  std::size_t next_ = 0;
};

}  // namespace

MadeWork pattern_work(std::shared_ptr<Session> session, int positions, const RasterSize& size) {
  if (positions < 2 || size.rows < 2 || size.columns < 2 || positions > 1024 ||
      size.rows * size.columns > 1'000'000)
    return Error{"", "",
                 "a pattern must have 2 to 1024 positions and a grid of at least 2 x 2 and at most "
                 "10^6 nodes"};
  return std::shared_ptr<Work>(std::make_shared<PatternWork>(std::move(session), positions, size));
}

MadeWork error_map_work(std::shared_ptr<Session> session, const std::array<ErrorAxis, 2>& axes,
                        int positions) {
  constexpr int kMost = 1000;
  if (positions < 2 || positions > kMost)
    return refused("positions", positions, "must lie between 2 and 1000");
  std::array<std::size_t, 2> keys{};
  std::array<Numbers, 2> values;
  for (const std::size_t i : {0, 1}) {
    const ErrorAxis& axis = axes[i];
    const auto place = error_index(axis.key);
    if (!place) return Error{"errors", axis.key, "is not a key of [errors]"};
    if (axis.n < 2 || axis.n > kMost) return refused("n", axis.n, "must lie between 2 and 1000");
    keys[i] = *place;
    for (int k = 0; k < axis.n; ++k)
      values[i].push_back(axis.from +
                          (axis.to - axis.from) * (static_cast<double>(k) / (axis.n - 1)));
  }
  return std::shared_ptr<Work>(
      std::make_shared<ErrorMapWork>(std::move(session), keys, std::move(values), positions));
}

}  // namespace gearwright::web
