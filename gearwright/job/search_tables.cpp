#include "gearwright/job/search_tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "gearwright/base/angle.hpp"

namespace gearwright {

double tidy_degrees(double rad) {
  const double value = Angle::radians(rad).deg();
  const double tidy = std::round(value * 1e9) / 1e9;
  return std::abs(value - tidy) < 1e-13 * (1.0 + std::abs(value)) ? tidy : value;
}

namespace {

template <class Row>
class Columns {
 public:
  using Table = std::vector<TableColumn<Row>>;

  template <class F>
  void add(std::string name, ParquetType type, const F& f) {
    table_.push_back({std::move(name), type, [f](const Row& r) { return TableValue(f(r)); }});
  }
  template <class F>
  void index(std::string name, const F& f) {
    add(std::move(name), ParquetType::int64, f);
  }
  template <class F>
  void whole(std::string name, const F& f) {
    add(std::move(name), ParquetType::int32,
        [f](const Row& r) { return static_cast<std::int64_t>(f(r)); });
  }
  template <class F>
  void real(std::string name, const F& f) {
    add(std::move(name), ParquetType::float64, f);
  }
  template <class F>
  void maybe(std::string name, const F& f) {
    table_.push_back({std::move(name), ParquetType::float64,
                      [f](const Row& r) {
                        const std::optional<double> v = f(r);
                        return v ? TableValue(*v) : TableValue();
                      },
                      true});
  }
  /// One column for each gear, "x1" and "x2".
  template <class F>
  void both(const char* before, const char* after, const F& f) {
    for (const int i : {0, 1})
      real(fmt::format("{}{}{}", before, i + 1, after), [f, i](const Row& r) { return f(r, i); });
  }
  Table take() { return std::move(table_); }

 private:
  Table table_;
};

}  // namespace

const std::vector<TableColumn<DesignRow>>& design_columns() {
  static const auto kTable = [] {
    using R = DesignRow;
    Columns<R> c;
    c.index("trial", [](const R& r) { return r.trial.index; });
    c.whole("rack", [](const R& r) { return r.trial.rack + 1; });
    c.real("module_mm", [](const R& r) { return r.trial.module; });
    c.whole("z1", [](const R& r) { return r.trial.z1; });
    c.whole("z2", [](const R& r) { return r.trial.z2; });
    c.both("helix", "_deg", [](const R& r, int i) { return tidy_degrees(r.trial.helix[i]); });
    c.real("ratio", [](const R& r) { return r.ratio; });
    c.real("center_distance_mm", [](const R& r) { return r.center_distance; });
    c.both("x", "", [](const R& r, int i) { return r.shift[i]; });
    c.add("point", ParquetType::text,
          [](const R& r) { return std::string(r.balanced ? "eq11" : "lo_hi"); });
    c.real("contact_ratio", [](const R& r) { return r.contact_ratio; });
    c.real("contact_ratio_true", [](const R& r) { return r.contact_ratio_true; });
    c.real("overlap_ratio", [](const R& r) { return r.overlap_ratio; });
    c.real("working_angle_deg", [](const R& r) { return tidy_degrees(r.working_angle); });
    c.real("backlash_normal_mm", [](const R& r) { return r.backlash_normal; });
    c.both("tip_thickness", "_mm", [](const R& r, int i) { return r.tip_thickness[i]; });
    c.both("tip_clearance", "_mm", [](const R& r, int i) { return r.tip_clearance[i]; });
    c.real("tip_alteration_mm", [](const R& r) { return r.tip_alteration; });
    for (const int gear : {0, 1}) {
      for (const int end : {0, 1}) {
        c.maybe(fmt::format("sliding{}_{}", gear + 1, end == 0 ? "A" : "E"),
                [gear, end](const R& r) { return r.sliding[gear][end]; });
      }
    }
    c.maybe("sliding_max", [](const R& r) { return r.max_sliding(); });
    c.whole("interference", [](const R& r) { return r.interference; });
    c.real("area", [](const R& r) { return r.area; });
    c.real("shift_sum_min", [](const R& r) { return r.sums[0]; });
    c.real("shift_sum_max", [](const R& r) { return r.sums[1]; });
    c.both("lo_x", "", [](const R& r, int i) { return r.lo[i]; });
    c.both("hi_x", "", [](const R& r, int i) { return r.hi[i]; });
    return c.take();
  }();
  return kTable;
}

const std::vector<TableColumn<ShiftPoint>>& point_columns() {
  static const auto kTable = [] {
    using R = ShiftPoint;
    Columns<R> c;
    c.index("trial", [](const R& r) { return r.trial; });
    c.both("x", "", [](const R& r, int i) { return r.shift[i]; });
    c.real("center_distance_mm", [](const R& r) { return r.center_distance; });
    c.real("working_angle_deg", [](const R& r) { return tidy_degrees(r.working_angle); });
    c.real("contact_ratio", [](const R& r) { return r.contact_ratio; });
    c.real("contact_ratio_true", [](const R& r) { return r.contact_ratio_true; });
    c.maybe("sliding_max", [](const R& r) { return r.sliding; });
    c.both("tip_thickness", "_mm", [](const R& r, int i) { return r.tip_thickness[i]; });
    c.both("tip_clearance", "_mm", [](const R& r, int i) { return r.tip_clearance[i]; });
    c.real("backlash_normal_mm", [](const R& r) { return r.backlash_normal; });
    c.whole("interference", [](const R& r) { return r.interference; });
    return c.take();
  }();
  return kTable;
}

}  // namespace gearwright
