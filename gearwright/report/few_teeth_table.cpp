#include "gearwright/report/few_teeth_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "gearwright/report/html_text.hpp"
#include "gearwright/report/root_picture.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

using Value = std::function<std::optional<double>(const Gear&)>;

std::optional<double> of_fillet(const Gear& gear, std::optional<FilletArc> GeneratedTooth::*which,
                                double FilletArc::*value) {
  if (!gear.tooth || !((*gear.tooth).*which)) return std::nullopt;
  return (*((*gear.tooth).*which)).*value;
}

class Rows {
 public:
  Rows(TableBuilder& table, const std::vector<const Gear*>& gears) : table_(table), gears_(gears) {}

  bool any(const Value& value) const {
    return std::any_of(gears_.begin(), gears_.end(), [&](const Gear* g) { return value(*g); });
  }
  void add(const char* words, const char* symbol, const char* unit, int digits,
           const Value& value) {
    std::vector<std::string> values;
    for (const Gear* g : gears_) values.push_back(fixed(value(*g), digits));
    table_.row(words, symbol, unit, values);
  }
  // A fillet: where it touches the flank, its circle and its angle.
  void add_fillet(const char* title, const char* point, const char* radius, const char* span,
                  std::optional<FilletArc> GeneratedTooth::*which,
                  std::optional<double> InvoluteTeeth::*l) {
    const Value r = [which](const Gear& g) { return of_fillet(g, which, &FilletArc::radius); };
    if (!any(r)) return;
    table_.group(title);
    add(fmt::format("Touches the flank at {}", point).c_str(), fmt::format("l_{}", point).c_str(),
        "mm", kLengthDigits, [l](const Gear& g) { return of_involute(g, l); });
    add("Radius", radius, "mm", kLengthDigits, r);
    add("Distance of its centre from the axis", "", "mm", kLengthDigits,
        [which](const Gear& g) { return of_fillet(g, which, &FilletArc::distance); });
    add("Angle from the flank to the centre line", span, "°", kAngleDigits,
        [which](const Gear& g) -> std::optional<double> {
          const auto rad = of_fillet(g, which, &FilletArc::span);
          return rad ? std::optional(Angle::radians(*rad).deg()) : std::nullopt;
        });
  }

 private:
  TableBuilder& table_;
  const std::vector<const Gear*>& gears_;
};

}  // namespace

std::string few_teeth_table(const std::vector<const Gear*>& gears) {
  const bool any = std::any_of(gears.begin(), gears.end(), [](const Gear* g) {
    return (g->tooth && (g->tooth->root_fillet || g->tooth->tip_fillet)) ||
           root_is_worth_a_picture(*g);
  });
  if (!any) return {};
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < gears.size(); ++i) columns.push_back(fmt::format("Gear {}", i + 1));
  TableBuilder table("Points and fillets; l runs along the rack’s straight flank", columns);
  Rows rows(table, gears);
  const Value limit = [](const Gear& g) {
    return root_is_worth_a_picture(g) ? g.involute()->undercut_l : std::nullopt;
  };
  if (rows.any(limit)) {
    table.group("Undercut");
    rows.add("Begins at F; below 0 the rack does not reach it", "l_F", "mm", kLengthDigits, limit);
  }
  rows.add_fillet("Circular root fillet", "C", "r_r", "σ_r", &GeneratedTooth::root_fillet,
                  &InvoluteTeeth::point_c_l);
  rows.add_fillet("Circular tip fillet", "J", "r_t", "σ_t", &GeneratedTooth::tip_fillet,
                  &InvoluteTeeth::point_j_l);
  return table.str();
}

}  // namespace gearwright
