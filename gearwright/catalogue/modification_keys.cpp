#include "gearwright/catalogue/gear_keys.hpp"

#include <deque>

namespace gearwright {

namespace {

// Stores a composed text for the lifetime of the program, because keys contain only views.
std::string_view kept(std::string text) {
  static std::deque<std::string> texts;
  return texts.emplace_back(std::move(text));
}

// Adds one key for both flanks and one key for each flank.
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

const std::array<ModificationEntry, kModifications.size()>& modification_entries() {
  using M = Modification;
  static const std::array<ModificationEntry, kModifications.size()> entries{{
      {member_of(M::tip_relief), "C_αa", "tip relief", "_start_mm", "from diameter",
       "amount C; the removal grows from 0 at the start diameter to C at d_Fa"},
      {member_of(M::root_relief), "C_αf", "root relief", "_start_mm", "from diameter",
       "amount C; the removal grows from 0 at the start diameter to C at d_Ff"},
      {member_of(M::profile_crowning), "C_α", "profile crowning", "", "",
       "parabola over the usable flank, with 0 in the middle and C at both ends; C is negative for "
       "a hollow flank"},
      {member_of(M::profile_slope), "C_Hα", "profile slope", "", "",
       "linear over the usable flank; the removal is 0 in the middle and greater by C at d_Fa than "
       "at d_Ff; C can be negative"},
      {member_of(M::lead_crowning), "C_β", "helix crowning", "", "",
       "parabola over the face, with 0 in the middle and C at both ends; C is negative for a "
       "hollow flank"},
      {member_of(M::lead_slope), "C_Hβ", "helix slope modification", "", "",
       "linear over the face; the removal C z/b is 0 in the middle and greater by C at the +z end "
       "than at the other end; C can be negative"},
      {member_of(M::end_relief), "C_βI = C_βII", "end relief", "_length_mm", "over",
       "amount C; at each end of the face, the removal is 0 at the distance l from the end and "
       "grows to C at the end"},
  }};
  return entries;
}

const KeyTable& modification_keys() {
  static const KeyTable table = [] {
    KeyTable t{"modifications",
               "Material removed from the flanks in the normal direction; a key with the prefix "
               "right_ or left_ applies to one flank only",
               {}};
    for (const ModificationEntry& m : modification_entries()) {
      const std::string name(m.name);
      const KeyRange amount =
          m.relief
              ? KeyRange::not_negative(
                    ", because a relief removes material; crownings and slopes can be negative")
              : KeyRange();
      add(t.keys, {.key = kept(name + "_um"),
                   .symbol = m.symbol,
                   .range = amount,
                   .meaning = m.meaning,
                   .fields = {m.relief ? name + ".amount" : name}});
      if (!m.relief) continue;
      const bool length = m.reach == "_length_mm";
      add(t.keys,
          {.key = kept(name + std::string(m.reach)),
           .range = KeyRange::positive(),
           .fallback = length ? std::string_view()
                              : "start of a short relief, so that the reliefs of both gears leave "
                                "one base pitch of the path of contact unmodified",
           .meaning =
               length ? "length l, from b/1000 to b/2" : "start diameter, on the usable flank",
           .fields = {name + ".reach"}});
      add(t.keys, {.key = kept(name + "_shape"),
                   .kind = KeyKind::word,
                   .words = {"linear", "parabolic"},
                   .fallback = "\"linear\"",
                   .meaning = "shape of the relief; the removal is C q (linear) or C q² "
                              "(parabolic), with q from 0 to 1",
                   .fields = {name + ".shape"}});
    }
    add(t.keys, {.key = "topography",
                 .kind = KeyKind::text,
                 .meaning = "CSV file with the material that is removed at the points of a grid"});
    return t;
  }();
  return table;
}

}  // namespace gearwright
