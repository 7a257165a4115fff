#include "gearwright/catalogue/gear_keys.hpp"

#include <fmt/format.h>

#include <deque>

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

// Stores a composed text for the lifetime of the program, because keys contain only views of texts.
std::string_view kept(std::string text) {
  static std::deque<std::string> texts;
  return texts.emplace_back(std::move(text));
}

// Adds one key for both flanks and one key for each flank. The keys of one flank come later, so
// they replace the value of the key for both flanks. set(FlanksInput&, flank, const V&) sets the
// value of one flank.
template <class V, class Set>
void add(std::vector<Key>& keys, Key key, Set set) {
  const std::string name(key.key);
  const std::string member = key.members().front();
  const std::string meaning(key.meaning);
  key.place = KeyPlace::by<FlanksInput, V>([set](FlanksInput& input, const V& value) {
    for (const std::size_t flank : {0, 1}) set(input, flank, value);
  });
  keys.push_back(key);
  key.in_documents = false;
  for (const std::size_t flank : {0, 1}) {
    key.key = kept(std::string(kFlankSides[flank]) + name);
    key.fields = {std::string(kFlankMembers[flank]) + member};
    key.meaning = kept(meaning + (flank == 0 ? ", of the right flank" : ", of the left flank"));
    key.place = KeyPlace::by<FlanksInput, V>(
        [set, flank](FlanksInput& input, const V& value) { set(input, flank, value); });
    keys.push_back(key);
  }
}

// Returns an error if a spec gives a key that has no effect on either flank. `amount` is the key of
// the amount of the relief to which `key` belongs. It is empty if `key` belongs to no relief.
std::optional<KeyFault> unused(const KeyGiven& given, const std::string& key,
                               const std::string& amount = "") {
  const std::string right = std::string(kFlankSides[0]) + key;
  const std::string left = std::string(kFlankSides[1]) + key;
  if (given(right) && given(left) && given(key))
    return KeyFault{key, fmt::format("has no effect, because {} and {} are given; leave out this "
                                     "key",
                                     right, left)};
  for (const std::string& one : {key, right, left}) {
    if (!given(one) || amount.empty()) continue;
    bool used = false;
    for (const std::size_t flank : {0, 1})
      used = used ||
             (key_of_flank(given, flank, key) == one && given(key_of_flank(given, flank, amount)));
    if (!used) return KeyFault{one, "has no effect without " + amount + ", which is not given"};
  }
  return std::nullopt;
}

std::optional<KeyFault> check_flanks(FlanksInput& input, const KeyGiven& given) {
  if (auto fault = unused(given, "topography")) return fault;
  for (const ModificationEntry& m : modification_entries()) {
    const std::string name(m.name), amount = name + "_um", reach = name + std::string(m.reach);
    if (auto fault = unused(given, amount)) return fault;
    if (!m.relief) continue;
    for (const std::string& key : {reach, name + "_shape"})
      if (auto fault = unused(given, key, amount)) return fault;
    for (const std::size_t flank : {0, 1}) {
      Relief& relief = input.flanks[flank].*m.relief;
      const std::string key = key_of_flank(given, flank, amount);
      if (!given(key)) relief = {};
      // A missing start diameter is computed from the pair. A missing length cannot be computed and
      // causes an error.
      if (relief.amount > 0.0 && !relief.reach && m.reach != "_start_mm")
        return KeyFault{reach, ": " + key + " needs a value for this key", true};
    }
  }
  return std::nullopt;
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

std::string key_of_flank(const KeyGiven& given, std::size_t flank, const std::string& key) {
  const std::string own = std::string(kFlankSides[flank]) + key;
  return given(own) ? own : key;
}

const KeyTable& modification_keys() {
  static const KeyTable table = [] {
    KeyTable t{"modifications",
               "Material removed from the flanks in the normal direction; a key with the prefix "
               "right_ or left_ applies to one flank only",
               {},
               check_flanks};
    for (const ModificationEntry& m : modification_entries()) {
      const std::string name(m.name);
      const KeyRange amount =
          m.relief
              ? KeyRange::not_negative(
                    ", because a relief removes material; crownings and slopes can be negative")
              : KeyRange();
      add<double>(t.keys,
                  {.key = kept(name + "_um"),
                   .symbol = m.symbol,
                   .range = amount,
                   .meaning = m.meaning,
                   .fields = {m.relief ? name + ".amount" : name}},
                  [&m](FlanksInput& input, std::size_t flank, double um) {
                    m.amount_of(input.flanks[flank]) = um / kUmPerMm;
                  });
      if (!m.relief) continue;
      const bool length = m.reach == "_length_mm";
      add<double>(
          t.keys,
          {.key = kept(name + std::string(m.reach)),
           .range = KeyRange::positive(),
           .fallback = length ? std::string_view()
                              : "start of a short relief; short reliefs on both gears leave one "
                                "base pitch of the path of contact unmodified",
           .meaning =
               length ? "length l, from b/1000 to b/2" : "start diameter, on the usable flank",
           .fields = {name + ".reach"}},
          [&m](FlanksInput& input, std::size_t flank, double mm) {
            (input.flanks[flank].*m.relief).reach = mm;
          });
      add<ReliefShape>(t.keys,
                       {.key = kept(name + "_shape"),
                        .kind = KeyKind::word,
                        .words = {"linear", "parabolic"},
                        .fallback = "\"linear\"",
                        .meaning = "shape of the relief; the removal is C q (linear) or C q² "
                                   "(parabolic), with q from 0 to 1",
                        .fields = {name + ".shape"}},
                       [&m](FlanksInput& input, std::size_t flank, ReliefShape shape) {
                         (input.flanks[flank].*m.relief).shape = shape;
                       });
    }
    add<std::string>(
        t.keys,
        {.key = "topography",
         .kind = KeyKind::text,
         .meaning = "CSV file with the material that is removed at the points of a grid"},
        [](FlanksInput& input, std::size_t flank, const std::string& file) {
          input.topography[flank] = file;
        });
    return t;
  }();
  return table;
}

}  // namespace gearwright
