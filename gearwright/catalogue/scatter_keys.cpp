#include "gearwright/catalogue/scatter_keys.hpp"

#include <fmt/format.h>

#include <deque>

namespace gearwright {

namespace {

using S = ScatterInput;

constexpr const char* kRange =
    "[least, greatest], uniform, or a table with `range` and `distribution`";

// A toleranced number in the form of a list or a table, which the reader handles.
Key toleranced(std::string_view key, std::string_view symbol, const KeyRange& range,
               std::string_view meaning) {
  return {.key = key,
          .symbol = symbol,
          .kind = KeyKind::table,
          .range = range,
          .list = KeyList{.least = 2, .most = 2, .single = true, .numbers = true},
          .form = kRange,
          .tables = {scatter_range_keys},
          .meaning = meaning};
}

std::optional<KeyFault> check_scatter(S& s, const KeyGiven&) {
  if ((s.samples & (s.samples - 1)) != 0)
    return KeyFault{"samples",
                    "must be a power of two, 1024 or 2048 for example; with another number the "
                    "points do not fill the ranges evenly"};
  const long long all = static_cast<long long>(s.samples) * s.replicates;
  if (all <= kMaxScatterSamples) return std::nullopt;
  return KeyFault{"samples", fmt::format("samples times replicates must be at most {}; here they "
                                         "are {}",
                                         kMaxScatterSamples, all)};
}

}  // namespace

const KeyTable& scatter_keys() {
  static const KeyTable table{
      "scatter",
      "What tolerances do to the pair; every range is added to what the spec has",
      {Key::number("samples", "n", KeyRange::between(1, kMaxScatterSamples), &S::samples, "1024",
                   "samples of each replicate, a power of two"),
       Key::number("replicates", "R", KeyRange::between(1, 1024), &S::replicates, "8",
                   "independent replicates, which give the error of every number; samples times "
                   "replicates at most 524 288"),
       Key::number("seed", "", KeyRange::between(0, kMaxWholeInput), &S::seed, "1",
                   "another seed draws other samples, the same seed the same ones"),
       Key::word("sampling", {"sobol", "random"}, &S::sampling, "\"sobol\"",
                 "scrambled Sobol points [T14.5], or plain random numbers"),
       Key::number("percentiles", "", KeyRange::inside(0, 100), &S::percentiles, "[5, 50, 95]",
                   "the percentiles of each quantity")
           .with_list(KeyList{.most = 100, .single = true}),
       Key::number("confidence", "", KeyRange::inside(0, 1), &S::confidence, "0.95",
                   "that of the intervals"),
       Key::flag("indices", &S::indices, "false",
                 "true: first and total Sobol indices of each input [T14.10], for (inputs + 2) "
                 "times the work"),
       Key::flag("worst_case", &S::worst_case, "false",
                 "true: the greatest peak to peak and the least play within all ranges [T14.15]"),
       Key::part("errors", scatter_error_keys, {}, "ranges of the keys of [errors]"),
       Key::part("bearings", scatter_bearing_keys, {},
                 "bores in circles, instead of the centre distance and the shaft deviations"),
       Key::part("gear1", scatter_gear_keys, {}, "ranges of the teeth of gear 1"),
       Key::part("gear2", scatter_gear_keys, {}, "the same of gear 2"),
       {.key = "groups",
        .kind = KeyKind::any,
        .form = "a table of names, each with a list of inputs: { housing = "
                "[\"errors.crossing_deg\", \"errors.center_distance_mm\"] }",
        .meaning = "inputs that `indices` treats as one; an input in no group is one of its own"}},
      check_scatter};
  return table;
}

const KeyTable& scatter_error_keys() {
  static const KeyTable table = [] {
    KeyTable t{"scatter_errors", "Ranges of errors, each added to the value in [errors]", {}};
    for (const Key& error : error_keys().keys)
      t.keys.push_back(toleranced(error.key, error.symbol, error.range, error.meaning));
    return t;
  }();
  return table;
}

const KeyTable& scatter_bearing_keys() {
  using B = ScatterBearings;
  static const KeyTable table{
      "scatter_bearings",
      "The bores of axis 1 against those of axis 2, each anywhere in a circle [T14.12]",
      {Key::positive("span_mm", "L", &B::span, kRequired, "distance of the bearings of a shaft"),
       Key::not_negative("radius_mm", "R", &B::radius, kRequired, "radius of the circle"),
       Key::number("offset_mm", "c", {}, &B::offset, "0",
                   "place of the gears on the shaft, from the middle of the span towards +z")}};
  return table;
}

const KeyTable& scatter_gear_keys() {
  static const KeyTable table{
      "scatter_gear",
      "Ranges of the teeth of a gear, each added to what the gear has",
      {toleranced("thickness_allowance_mm", "E_sn", KeyRange::between(-10, 10),
                  "normal tooth thickness of an involute gear; it changes the play and the mean of "
                  "the transmission error [T14.13]"),
       Key::part("modifications", scatter_modification_keys, {},
                 "ranges of modifications, of both flanks")}};
  return table;
}

const KeyTable& scatter_modification_keys() {
  static const KeyTable table = [] {
    static std::deque<std::string> names;
    KeyTable t{"scatter_modifications", "Ranges of amounts, added to [gearN.modifications]", {}};
    for (const ModificationEntry& m : modification_entries())
      t.keys.push_back(toleranced(names.emplace_back(std::string(m.name) + "_um"), m.symbol,
                                  KeyRange::between(-5000, 5000), m.words));
    return t;
  }();
  return table;
}

const KeyTable& scatter_range_keys() {
  using D = DistributionSpec;
  static const KeyTable table{
      "scatter_range",
      "A toleranced number [T14.1]",
      {Key::number("range", "l, h", {}, &D::range, kRequired, "the least and the greatest value")
           .with_list(KeyList{.least = 2, .most = 2}),
       Key::word("distribution", {"uniform", "triangular", "normal", "beta"}, &D::kind,
                 "\"uniform\"",
                 "how it is distributed over the range; a normal distribution is cut at the range"),
       Key::number("cpk", "C_pk", {}, &D::cpk, "1",
                   "of a normal distribution: the mean lies 3 C_pk standard deviations inside the "
                   "range"),
       Key::number("offset", "", {}, &D::offset, "0",
                   "of a normal distribution: the mean off the middle of the range"),
       Key::number("shape", "p, q", {}, &D::shape, "[1, 1]", "of a beta distribution")
           .with_list(KeyList{.least = 2, .most = 2})}};
  return table;
}

}  // namespace gearwright
