#include "gearwright/catalogue/modification_keys.hpp"

#include <deque>

namespace gearwright {

namespace {

// Stores words of keys that are composed here for the lifetime of the program.
std::string_view kept(std::string text) {
  static std::deque<std::string> texts;
  return texts.emplace_back(std::move(text));
}

// One key for both flanks and one for each.
void add(std::vector<Key>& keys, Key key) {
  keys.push_back(key);
  const std::string name(key.key);
  const std::string member = key.members().front();
  const std::string meaning(key.meaning);
  key.in_documents = false;
  for (const std::string_view side : kFlankSides) {
    key.key = kept(std::string(side) + name);
    key.fields = {std::string(side == "right_" ? kFlankMembers[0] : kFlankMembers[1]) + member};
    key.meaning =
        kept(meaning + (side == "right_" ? ", of the right flank" : ", of the left flank"));
    keys.push_back(key);
  }
}

}  // namespace

const std::array<ModificationEntry, 7>& modification_entries() {
  using M = FlankModifications;
  using P = RemovalField::Parameter;
  static const std::array<ModificationEntry, 7> entries{{
      {"tip_relief", "C_αa", "tip relief", P::tip_relief, &M::tip_relief, nullptr, "_start_mm",
       "from diameter", "from 0 at the start diameter to C at d_Fa"},
      {"root_relief", "C_αf", "root relief", P::root_relief, &M::root_relief, nullptr, "_start_mm",
       "from diameter", "from 0 at the start diameter to C at d_Ff"},
      {"profile_crowning", "C_α", "profile crowning", P::profile_crowning, nullptr,
       &M::profile_crowning, "", "",
       "a parabola over the usable flank, 0 in its middle, C at both ends; < 0 is hollow"},
      {"profile_slope", "C_Hα", "profile slope", P::profile_slope, nullptr, &M::profile_slope, "",
       "",
       "linear over the usable flank, 0 in its middle, C more at d_Fa than at d_Ff; may be "
       "negative"},
      {"lead_crowning", "C_β", "helix crowning", P::lead_crowning, nullptr, &M::lead_crowning, "",
       "", "a parabola over the face, 0 in its middle, C at both ends; < 0 is hollow"},
      {"lead_slope", "C_Hβ", "helix slope modification", P::lead_slope, nullptr, &M::lead_slope, "",
       "", "C z/b: 0 in the middle, C more at the +z end than at the other; may be negative"},
      {"end_relief", "C_βI = C_βII", "end relief", P::end_relief, &M::end_relief, nullptr,
       "_length_mm", "over", "over the length l from each end of the face, 0 to C"},
  }};
  return entries;
}

const KeyTable& modification_keys() {
  static const KeyTable table = [] {
    KeyTable t{"modifications",
               "Material removed from the flanks, normal to them; with right_ or left_ before a "
               "key, from one flank",
               {}};
    for (const ModificationEntry& m : modification_entries()) {
      const std::string name(m.name);
      const KeyRange amount =
          m.relief ? KeyRange::not_negative(
                         ": a relief takes material away; crownings may be negative (hollow)")
                   : KeyRange();
      add(t.keys, {.key = kept(name + "_um"),
                   .symbol = m.symbol,
                   .range = amount,
                   .meaning = m.meaning,
                   .fields = {m.relief ? name + ".amount" : name}});
      if (!m.relief) continue;
      const bool length = m.reach == "_length_mm";
      add(t.keys, {.key = kept(name + std::string(m.reach)),
                   .range = KeyRange::positive(),
                   .fallback = length ? std::string_view()
                                      : "short relief: the reliefs of both gears leave one base "
                                        "pitch of the path",
                   .meaning = length ? "the length l, from b/1000 to b/2"
                                     : "the start diameter, on the usable flank",
                   .fields = {name + ".reach"}});
      add(t.keys, {.key = kept(name + "_shape"),
                   .kind = KeyKind::word,
                   .words = {"linear", "parabolic"},
                   .fallback = "\"linear\"",
                   .meaning = "shape of the relief, C q or C q², q from 0 to 1",
                   .fields = {name + ".shape"}});
    }
    add(t.keys, {.key = "topography",
                 .kind = KeyKind::text,
                 .meaning = "a CSV file with the material removed at the points of a grid"});
    return t;
  }();
  return table;
}

}  // namespace gearwright
