#include "gearwright/catalogue/contact_keys.hpp"

namespace gearwright {

namespace {

using Range = KeyRange;

std::vector<std::string_view> error_words() {
  std::vector<std::string_view> words;
  for (const ErrorEntry& e : error_entries()) words.push_back(e.key);
  return words;
}

}  // namespace

const KeyTable& contact_keys() {
  static const KeyTable table{
      "contact",
      "How the contact of the pair is looked at",
      {{.key = "positions",
        .kind = KeyKind::whole,
        .range = Range::between(4, 100'000),
        .place = &ContactInput::positions,
        .fallback = "64",
        .meaning = "positions per pitch of gear 1"},
       {.key = "pitches",
        .kind = KeyKind::whole,
        .range = Range::between(1, 10'000),
        .place = &ContactInput::pitches,
        .fallback = "1",
        .meaning = "how many pitches; every one is like the first; positions times pitches at most "
                   "10⁶"},
       {.key = "marking_mm",
        .symbol = "δ",
        .range = Range::above(0, 1, ", usually 0.003 to 0.01"),
        .place = &ContactInput::marking,
        .fallback = "0.00635",
        .meaning = "thickness of the marking compound, for ellipses and pattern"},
       {.key = "driver",
        .kind = KeyKind::whole,
        .range = Range::between(1, 2),
        .place = &ContactInput::driver,
        .fallback = "1",
        .meaning =
            "1, or 2: gear 2 pushes in the same sense of rotation, and the non-working flanks "
            "touch"},
       {.key = "pattern",
        .kind = KeyKind::boolean,
        .place = &ContactInput::pattern,
        .fallback = "false",
        .meaning = "true: the result has the marking pattern of both flanks"},
       {.key = "rotation1_deg",
        .range = Range::between(-1e6, 1e6),
        .list = KeyList{1, 100'000},
        .meaning = "rotations of gear 1, in place of positions and pitches",
        .fields = {"rotations"}},
       {.key = "map",
        .kind = KeyKind::table,
        .tables = {contact_map_keys},
        .in_documents = false,
        .meaning = "peak to peak of the transmission error over two errors at once"}}};
  return table;
}

const KeyTable& contact_map_keys() {
  static const KeyTable table{
      "contact_map",
      "Peak to peak of the transmission error over two errors at once, the others as they stand in "
      "[errors]",
      {{.key = "x",
        .kind = KeyKind::word,
        .words = error_words(),
        .form = "a key of `[errors]`",
        .required = true,
        .meaning = "a key of [errors], such as crossing_deg"},
       {.key = "x_range",
        .list = KeyList{2, 2},
        .required = true,
        .meaning = "the least and the greatest value, in the unit of the key"},
       {.key = "y",
        .kind = KeyKind::word,
        .words = error_words(),
        .form = "a key of `[errors]`",
        .required = true,
        .meaning = "a key of [errors], another than x"},
       {.key = "y_range",
        .list = KeyList{2, 2},
        .required = true,
        .meaning = "the least and the greatest value, in the unit of the key"},
       {.key = "points",
        .kind = KeyKind::whole,
        .range = Range::between(2, 1000),
        .list = KeyList{2, 2},
        .fallback = "[21, 21]",
        .meaning = "how many along x and along y, ends included"}}};
  return table;
}

}  // namespace gearwright
