#include "gearwright/catalogue/scatter_keys.hpp"

#include <fmt/format.h>

#include <deque>
#include <tuple>

namespace gearwright {

namespace {

constexpr const char* kRange =
    "[least, greatest] for a uniform distribution, or a table with `range` and `distribution`";

// Makes a key for a toleranced number, which a spec gives as a list or as a table. `reach` returns
// the member of the struct T that stores the number. This member is an optional distribution.
template <class T, class F>
Key toleranced(std::string_view key, std::string_view symbol, const KeyRange& range, F reach,
               std::string_view meaning) {
  return {.key = key,
          .symbol = symbol,
          .kind = KeyKind::table,
          .range = range,
          .list = KeyList{.least = 2,
                          .most = 2,
                          .single = true,
                          .order = {.sentence = "must contain the least value before the greatest; "
                                                "a tolerance of ±0.02 is [-0.02, 0.02]"},
                          .must = "must be [least, greatest], or a table with range and "
                                  "distribution",
                          .numbers = true},
          .form = kRange,
          .place = KeyPlace::ends_or_table<T>(&DistributionSpec::range, reach),
          .tables = {scatter_range_keys},
          .meaning = meaning};
}

std::optional<KeyFault> check_distribution(DistributionSpec& d, const KeyGiven& given) {
  using Kind = DistributionSpec::Kind;
  for (const auto& [key, kind, word] : {std::tuple{"cpk", Kind::normal, "normal"},
                                        {"offset", Kind::normal, "normal"},
                                        {"shape", Kind::beta, "beta"}})
    if (given(key) && d.kind != kind)
      return KeyFault{key, fmt::format("is used only with distribution = \"{}\"", word)};
  const auto made = Distribution::of(d);
  return made ? std::nullopt : std::optional(KeyFault{made.error().field, made.error().rule});
}

std::optional<KeyFault> check_correlation(ScatterInput::Correlation& c, const KeyGiven&) {
  if (c.between[0] != c.between[1]) return std::nullopt;
  return KeyFault{"between",
                  "must be two different inputs; the correlation of an input with itself is 1"};
}

std::optional<KeyFault> check_scatter(ScatterInput& s, const KeyGiven&) {
  for (const std::size_t i : {0, 1, 2})
    if (s.bearings && s.errors[i])
      return KeyFault{"bearings", fmt::format("cannot be combined with scatter.errors.{}, because "
                                              "the positions of the bores determine this error",
                                              error_entries()[i].key)};
  if ((s.samples & (s.samples - 1)) != 0)
    return KeyFault{"samples",
                    "must be a power of two, for example 1024 or 2048, because another number of "
                    "points would fill the ranges unevenly"};
  const long long all = static_cast<long long>(s.samples) * s.replicates;
  if (all <= kMaxScatterSamples) return std::nullopt;
  return KeyFault{"samples", fmt::format("must be smaller; the product of samples and replicates "
                                         "must be at most {}, but this product is {}",
                                         kMaxScatterSamples, all)};
}

template <class V>
KeyPlace plan(V ScatterPlan::*member) {
  return KeyPlace::inherited<ScatterInput>(member);
}

KeyPlace gear(std::size_t i) {
  return KeyPlace::within<ScatterInput>([i](auto& s) -> auto& { return s.gears[i]; });
}

std::optional<KeyFault> check_robust(ScatterRobust& r, const KeyGiven&) {
  if (!r.range) return std::nullopt;
  const auto [lo, hi] = *r.range;
  if (lo <= 0.0 && hi >= 0.0 && lo < hi) return std::nullopt;
  return KeyFault{"range",
                  "must contain 0, which stands for no correction, and another value, for example "
                  "[0, 20]"};
}

}  // namespace

const KeyTable& scatter_keys() {
  static const KeyTable table{
      "scatter",
      "Effect of tolerances on the pair; each range gives deviations, which are added to the "
      "nominal value in the spec. The tooth thickness and the centre distance vary within the "
      "tolerances of [gearN] and [pair], unless [scatter] gives a range",
      {Key::number("samples", "n", KeyRange::between(1, kMaxScatterSamples),
                   plan(&ScatterPlan::samples), "1024",
                   "number of samples of each replicate, a power of two"),
       Key::number("replicates", "R", KeyRange::between(1, 1024), plan(&ScatterPlan::replicates),
                   "8",
                   "number of independent replicates, from which the error of every result is "
                   "estimated; samples times replicates must be at most 524 288"),
       Key::number("seed", "", KeyRange::between(0, kMaxWholeInput), &ScatterInput::seed, "1",
                   "seed of the random numbers; the same seed always gives the same samples"),
       Key::word("sampling", {"sobol", "random"}, plan(&ScatterPlan::sampling), "\"sobol\"",
                 "kind of the sample points, which are scrambled Sobol points [T14.5] or plain "
                 "random numbers"),
       Key::number("percentiles", "", KeyRange::inside(0, 100), plan(&ScatterPlan::percentiles),
                   "[5, 50, 95]", "percentiles that are computed for each quantity")
           .with_list(KeyList{.most = 100, .single = true}),
       Key::number("confidence", "", KeyRange::inside(0, 1), plan(&ScatterPlan::confidence), "0.95",
                   "confidence level of the intervals"),
       Key::flag("indices", plan(&ScatterPlan::indices), "false",
                 "if true, first-order and total Sobol indices of each input are computed "
                 "[T14.10], which multiplies the computing time by (inputs + 2)"),
       Key::flag("worst_case", plan(&ScatterPlan::worst_case), "false",
                 "if true, a search finds the greatest peak-to-peak transmission error and the "
                 "least play within all ranges [T14.15]"),
       Key::flag("loosening", plan(&ScatterPlan::loosening), "false",
                 "if true, the result contains the tolerance that should be tightened first. For "
                 "each tolerance, the result also contains a factor; if the tolerance grows by "
                 "this factor, the greatest of `percentiles` of the peak-to-peak transmission "
                 "error grows by 5 % [T14.19]"),
       Key::flag("pattern", &ScatterInput::pattern, "false",
                 "if true, the result contains the density of the contact pattern on both flanks. "
                 "At each point of a flank, the density is the share of samples in which the "
                 "marking compound of [contact] shows contact. The density is computed from the "
                 "first 256 / `replicates` samples of each replicate [T14.27]"),
       Key::flag(
           "loaded", &ScatterInput::loaded, "false",
           "if true, loaded transmission error, pressure and face load factor are computed for the "
           "first samples of each replicate. The torques and positions are those of [load] (by "
           "default 16 positions). Pitch deviations have no effect on these quantities [T14.24]"),
       Key::number(
           "loaded_samples", "", KeyRange::between(1, kMaxScatterSamples),
           &ScatterInput::loaded_samples, "256",
           "greatest number of samples under load, for all replicates together. Each replicate has "
           "at least 1 sample. The number of samples of each replicate is the greatest power of "
           "two that is at most `samples` and at most this limit divided by `replicates`"),
       Key::number(
           "quality", "A", KeyRange::between(0, 12), &ScatterInput::quality,
           "`[gearN.tolerance] quality`",
           "grade of ISO 1328 for both gears, or two grades. The grade determines all tolerances "
           "that are not given in the tables of [scatter]: f_Hα, f_Hβ, the waves of f_fα and f_fβ "
           "and the pitches of each gear, and the axes by ISO/TR 10064-3 [T14.23]")
           .with_list(KeyList{.least = 1, .most = 2, .single = true}),
       Key::part("errors", scatter_error_keys,
                 KeyPlace::within<ScatterInput>([](auto& s) -> auto& { return s; }),
                 "ranges of the keys of [errors]"),
       Key::part("bearings", scatter_bearing_keys, &ScatterInput::bearings,
                 "positions of the bores within circles, instead of the centre distance and the "
                 "shaft deviations"),
       Key::part("gear1", scatter_gear_keys, gear(0), "ranges of the teeth of gear 1"),
       Key::part("gear2", scatter_gear_keys, gear(1), "ranges of the teeth of gear 2"),
       {.key = "groups",
        .kind = KeyKind::any,
        .form = "a table of names, each with a list of inputs, for example { housing = "
                "[\"errors.crossing_deg\", \"errors.center_distance_mm\"] }",
        .meaning = "groups of inputs, each of which `indices` treats as one input; an input "
                   "without a group is treated alone"},
       {.key = "correlations",
        .kind = KeyKind::table,
        .list = KeyList{.most = kMostCorrelations,
                        .must = "must be a list of 1 to {} tables, for example [{{ between = "
                                "[\"errors.crossing_deg\", \"errors.intersecting_deg\"], value = "
                                "0.5 }}]"},
        .place = &ScatterInput::correlations,
        .tables = {scatter_correlation_keys},
        .meaning = "correlations of inputs. Each is a table `[[scatter.correlations]]`, or an "
                   "entry of a list such as { between = [\"errors.crossing_deg\", "
                   "\"errors.intersecting_deg\"], value = 0.5 }. Inputs without a correlation are "
                   "independent. The worst case does not depend on correlations [T14.30]"},
       Key::part("robust", scatter_robust_keys, &ScatterInput::robust,
                 "corrections that minimise a percentile of the peak-to-peak transmission error")},
      check_scatter};
  return table;
}

const KeyTable& scatter_error_keys() {
  static const KeyTable table = [] {
    KeyTable t{"scatter_errors", "Ranges of errors, each added to the value in [errors]", {}};
    for (std::size_t i = 0; i < kErrorCount; ++i) {
      const Key& error = error_keys().keys[i];
      t.keys.push_back(toleranced<ScatterInput>(
          error.key, error.symbol,
          error.range, [i](ScatterInput & s) -> auto& { return s.errors[i]; }, error.meaning));
    }
    return t;
  }();
  return table;
}

const KeyTable& scatter_bearing_keys() {
  using B = ScatterBearings;
  static const KeyTable table{
      "scatter_bearings",
      "The bores of axis 1 relative to the bores of axis 2; each bore can lie anywhere in a circle "
      "[T14.12]",
      {Key::positive("span_mm", "L", &B::span, kRequired, "distance of the bearings of a shaft"),
       Key::not_negative("radius_mm", "R", &B::radius, kRequired,
                         "radius of the circle in which a bore of axis 1 can lie relative to the "
                         "bore of axis 2 in the same wall. If both bores lie independently in "
                         "circles of radius r, R = √2 r gives the same variance"),
       Key::number("offset_mm", "c", {}, &B::offset, "0",
                   "position of the gears on the shaft, from the middle of the span towards +z")}};
  return table;
}

const KeyTable& scatter_gear_keys() {
  using G = ScatterGear;
  static const KeyTable table{
      "scatter_gear",
      "Ranges of the teeth of a gear, each added to the value of the gear",
      {toleranced<G>(
           "thickness_allowance_mm", "E_sn", KeyRange::between(-10, 10),
           [](G & g) -> auto& { return g.thickness; },
           "range of a deviation of the normal tooth thickness of an involute gear, which is added "
           "to the allowance of the gear; the thickness affects the play and the mean of the "
           "transmission error [T14.13]"),
       {.key = "pitch",
        .kind = KeyKind::word,
        .words = {"F_p"},
        .place = KeyPlace::by<G, std::size_t>([](G& g, std::size_t) { g.pitch = true; }),
        .meaning = "pitch deviations, which vary within F_pT and f_ptT of the grade [T14.20]"},
       Key::number("profile_waves", "", KeyRange::between(0, 100), &G::profile_waves,
                   "[1, 4] if a grade is given",
                   "least and greatest number of waves of the profile form over the usable flank; "
                   "the height of the waves is f_fαT of the grade [T14.21]. [0, 0] is a flank "
                   "without waves")
           .with_list(kLowerAndUpper),
       Key::number("helix_waves", "", KeyRange::between(0, 100), &G::helix_waves,
                   "[1, 4] if a grade is given",
                   "least and greatest number of waves of the helix form over the face; the height "
                   "of the waves is f_fβT of the grade. [0, 0] is a flank without waves")
           .with_list(kLowerAndUpper),
       Key::part("modifications", scatter_modification_keys,
                 KeyPlace::within<G>([](auto& g) -> auto& { return g; }),
                 "ranges of modifications of both flanks")}};
  return table;
}

const KeyTable& scatter_modification_keys() {
  static const KeyTable table = [] {
    static std::deque<std::string> names;
    KeyTable t{
        "scatter_modifications", "Ranges of amounts, which are added to [gearN.modifications]", {}};
    for (std::size_t i = 0; i < modification_entries().size(); ++i) {
      const ModificationEntry& m = modification_entries()[i];
      t.keys.push_back(toleranced<ScatterGear>(
          names.emplace_back(std::string(m.name) + "_um"), m.symbol, KeyRange::between(-5000, 5000),
          [i](ScatterGear & g) -> auto& { return g.modifications[i]; }, m.words));
    }
    return t;
  }();
  return table;
}

const KeyTable& scatter_correlation_keys() {
  static const KeyTable table{
      "scatter_correlations",
      "The correlation of two inputs; the range and the distribution of each input do not change",
      {{.key = "between",
        .kind = KeyKind::text,
        .list = KeyList{.least = 2, .most = 2},
        .form = "a list of two inputs, for example [\"errors.crossing_deg\", "
                "\"errors.intersecting_deg\"]",
        .place = &ScatterInput::Correlation::between,
        .required = true,
        .meaning =
            "two inputs. The position of a bore can be correlated with the position of the "
            "other bore. One coordinate of a bore, such as `bearings.bore_a.x_mm`, can be "
            "correlated with an input that is a number. For pitch deviations, the correlated "
            "number is their share of F_pT or, with the name `gear1.pitch.eccentric`, the "
            "eccentric part. For waves, it is the number of waves. Phases cannot be "
            "correlated. With `indices`, both inputs must be in the same group of `groups`"},
       {.key = "value",
        .symbol = "ρ",
        .kind = KeyKind::number,
        .range = KeyRange::inside(-1, 1),
        .place = &ScatterInput::Correlation::value,
        .required = true,
        .meaning = "correlation of the normal scores of the inputs; the normal score of a value is "
                   "the quantile of the standard normal distribution at the cumulative probability "
                   "of that value. The rank correlation of the inputs is 6/π asin(ρ/2)"}},
      check_correlation};
  return table;
}

const KeyTable& scatter_robust_keys() {
  using R = ScatterRobust;
  static const KeyTable table{
      "scatter_robust",
      "Corrections that minimise a percentile of the peak-to-peak transmission error of rigid or "
      "loaded teeth [T14.18]",
      {Key::word("corrections", correction_words(), &R::corrections,
                 "corrections of `[compensate]`",
                 "corrections that can be used, as in `[compensate]`; each correction is added to "
                 "the value in the spec")
           .with_list(KeyList{.most = correction_entries().size(), .noun = "correction"})
           .with_form("a list of names, [\"gear1.lead_crowning_um\"]"),
       Key::word("aim", {"transmission_error", "loaded_transmission_error"}, &R::aim,
                 "\"transmission_error\"",
                 "quantity that is computed for each sample. It is the peak-to-peak transmission "
                 "error of rigid teeth or, with `loaded_transmission_error`, of loaded teeth under "
                 "the worst torque of `[load]` [T14.25]"),
       Key::number("percentile", "", KeyRange::inside(0, 100), &R::percentile, "95",
                   "percentile to minimise"),
       Key::number(
           "range", "", KeyRange::between(-1000, 1000), &R::range, "ranges of `[compensate]`",
           "least and greatest value of every correction, in its unit; the range must contain 0")
           .with_list(kLowerAndUpper)},
      check_robust};
  return table;
}

const KeyTable& scatter_range_keys() {
  using D = DistributionSpec;
  static const KeyTable table{
      "scatter_range",
      "A toleranced number [T14.1]",
      {Key::number("range", "l, h", {}, &D::range, kRequired, "least and greatest value")
           .with_list(KeyList{.least = 2, .most = 2}),
       Key::word("distribution", {"uniform", "triangular", "normal", "beta"}, &D::kind,
                 "\"uniform\"",
                 "distribution over the range; a normal distribution is truncated at the ends of "
                 "the range"),
       Key::number("cpk", "C_pk", {}, &D::cpk, "1",
                   "process capability C_pk of a normal distribution, whose mean is 3 C_pk "
                   "standard deviations from the nearer end of the range"),
       Key::number("offset", "", {}, &D::offset, "0",
                   "offset of the mean of a normal distribution from the middle of the range"),
       Key::number("shape", "p, q", {}, &D::shape, "[1, 1]",
                   "shape parameters of a beta distribution")
           .with_list(KeyList{.least = 2, .most = 2})},
      check_distribution,
      "range"};
  return table;
}

}  // namespace gearwright
