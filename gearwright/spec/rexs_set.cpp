#include "gearwright/spec/rexs_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "gearwright/base/lists.hpp"

namespace gearwright {

namespace {

using Component = RexsComponent;
using Gears = std::vector<const Component*>;

Error not_read(std::string_view what, const Component& c, std::string_view why) {
  return {"", "",
          fmt::format("{} {} cannot be read, because {}; describe such a drive by [drive]", what,
                      rexs_name(c), why)};
}

class SetFinder {
 public:
  SetFinder(const RexsModel& model, const std::vector<RexsStage>& stages, const Component& stage)
      : model_(model), stages_(stages), stage_(stage) {}

  Result<RexsSet> set() {
    for (const auto step : {&SetFinder::name_planets, &SetFinder::name_central_gears,
                            &SetFinder::name_meshes, &SetFinder::find_ends})
      if (auto error = (this->*step)()) return *error;
    return std::move(set_);
  }

 private:
  const Component* shaft_of(const Component& gear) const {
    return model_.related(gear.id, {"assembly"}, {"shaft"});
  }
  bool has_role(std::string_view relation, std::string_view shaft) const {
    const bool only = model_.of_type("planetary_stage").size() == 1;
    return std::any_of(model_.relations.begin(), model_.relations.end(),
                       [&](const RexsRelation& r) {
                         return r.type == relation && r.of("shaft") == shaft &&
                                (only || r.of("planetary_stage") == stage_.id);
                       });
  }

  Gears partners(const Component& gear) const {
    Gears list;
    for (const RexsStage& s : stages_)
      for (const std::size_t i : {0U, 1U})
        if (s.gears[i] == &gear) list.push_back(s.gears[1 - i]);
    return list;
  }

  // True if the gear is a planet, that is, if it is on a planet shaft. If the file names no planet
  // shafts, every external gear that meshes with a ring is a planet.
  bool rides(const Component& gear) const {
    const auto is_ring = [](const Component* g) { return g->type == "ring_gear"; };
    if (std::any_of(model_.relations.begin(), model_.relations.end(),
                    [](const RexsRelation& r) { return r.type == "planet_shaft"; })) {
      const Component* const shaft = shaft_of(gear);
      return shaft && has_role("planet_shaft", shaft->id);
    }
    const Gears others = partners(gear);
    return !is_ring(&gear) && std::any_of(others.begin(), others.end(), is_ring);
  }

  // Returns a text that is the same for all copies of one planet. Copies have the same number of
  // teeth, the same neighbours on their shafts, and meshes with the same central gears.
  std::string kind_of(const Component& gear) const {
    std::multiset<std::string> others;
    for (const Component* p : partners(gear))
      others.insert(rides(*p) ? fmt::format("z {}", rexs_teeth(*p)) : "id " + p->id);
    for (const Component& c : model_.components)
      if (is_rexs_gear(c) && c.id != gear.id && shaft_of(c) && shaft_of(c) == shaft_of(gear))
        others.insert(c.number("number_of_teeth") ? fmt::format("beside {}", rexs_teeth(c))
                                                  : "beside a gear without number of teeth");
    return fmt::format("{} {}", rexs_teeth(gear), fmt::join(others, ", "));
  }

  // True if the only central gear that meshes with `gear` is external.
  bool only_a_sun(const Component& gear) const {
    const Gears all = partners(gear);
    return std::count_if(all.begin(), all.end(), [&](auto* p) { return !rides(*p); }) == 1 &&
           std::none_of(all.begin(), all.end(), [](auto* p) { return p->type == "ring_gear"; });
  }

  std::optional<Error> name_planets() {
    std::vector<std::pair<std::string, Gears>> kinds;
    for (const Component& c : model_.components) {
      if (!is_rexs_gear(c) || partners(c).empty() || !rides(c)) continue;
      const std::string kind = kind_of(c);
      const auto known =
          std::find_if(kinds.begin(), kinds.end(), [&](auto& k) { return k.first == kind; });
      (known == kinds.end() ? kinds.emplace_back(kind, Gears()) : *known).second.push_back(&c);
    }
    if (kinds.empty())
      return Error{"", "", "the planetary stage has no planets that mesh with a sun or a ring"};
    std::vector<std::string> names{"planet"};
    if (kinds.size() == 2) {
      const Component &one = *kinds[0].second[0], &two = *kinds[1].second[0];
      const Gears met = partners(one);
      if (shaft_of(one) && shaft_of(one) == shaft_of(two))
        names = {"planet", "planet2"};
      else if (is_in(&two, met) && only_a_sun(one))
        names = {"idler", "planet"};
      else if (is_in(&two, met) && only_a_sun(two))
        names = {"planet", "idler"};
    }
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const Gears& copies = kinds[k].second;
      if (k >= names.size() || copies.size() != kinds[0].second.size())
        return not_read(
            "gear", *copies[0],
            fmt::format("it differs from planet {}, but [planetary] supports only equal planets, "
                        "which may be stepped with two gears or paired with an idler",
                        rexs_name(*kinds[0].second[0])));
      set_.gears[names[k]] = copies[0];
      for (const Component* gear : copies) {
        member_[gear] = names[k];
        if (gear != copies[0]) set_.copies.push_back({gear, copies[0]});
      }
    }
    set_.planets = kinds[0].second.size();
    return std::nullopt;
  }

  std::optional<Error> name_central_gears() {
    const bool stepped = set_.gears.count("planet2") > 0, idler = set_.gears.count("idler") > 0;
    std::map<const Component*, const Component*> on_shaft;
    for (const Component& c : model_.components) {
      if (!is_rexs_gear(c) || member_.count(&c) > 0) continue;
      std::set<std::string> met;
      for (const Component* p : partners(c))
        if (member_.count(p) > 0 && rides(*p)) met.insert(member_[p]);
      if (met.empty()) continue;  // name_meshes() rejects the stages of such a gear
      const std::string base = c.type == "ring_gear" ? "ring" : "sun";
      std::string name = base;
      if (met.count("planet2") > 0 || (base == "sun" && idler && met.count("planet") > 0) ||
          (!stepped && set_.gears.count(base) > 0))
        name += "2";
      if (met.size() > 1 || set_.gears.count(name) > 0 ||
          (base == "ring" && met.count("idler") > 0))
        return not_read(
            "gear", c,
            "[planetary] allows one sun and one ring for each gear of a stepped planet, two suns "
            "and two rings for a planet with one gear, and no ring for an idler");
      const Component* const shaft = shaft_of(c);
      if (shaft && !on_shaft.emplace(shaft, &c).second)
        return not_read("gear", c,
                        "it is on the same shaft as gear " + rexs_name(*on_shaft[shaft]) +
                            ", but each central gear of [planetary] must be a separate body");
      set_.gears[name] = &c;
      member_[&c] = name;
    }
    return std::nullopt;
  }

  std::optional<Error> name_meshes() {
    for (const RexsStage& s : stages_) {
      std::array<std::string, 2> names;
      for (const std::size_t i : {0U, 1U}) {
        const auto it = member_.find(s.gears[i]);
        if (it == member_.end() || member_.count(s.gears[1 - i]) == 0)
          return not_read("stage", *s.stage, "it is not a mesh of the planetary set of this file");
        names[i] = it->second == "planet2" ? "planet" : it->second;
      }
      // The order is sun, idler, planet, ring.
      const auto rank = [](const std::string& n) { return std::string("sipr").find(n.front()); };
      if (rank(names[0]) > rank(names[1])) std::swap(names[0], names[1]);
      const auto [first, is_new] = set_.meshes.emplace(names[0] + "_" + names[1], s);
      if (!is_new) set_.copies.push_back({s.stage, first->second.stage});
    }
    return std::nullopt;
  }

  std::optional<Error> find_ends() {
    auto& bodies = set_.bodies;
    for (const auto& [name, gear] : set_.gears)
      if (const Component* const shaft = rides(*gear) ? nullptr : shaft_of(*gear))
        bodies[name] = rexs_coupled(model_, shaft->id);
    for (const Component* shaft : model_.of_type("shaft"))
      if (has_role("planet_carrier_shaft", shaft->id))
        bodies["carrier"].merge(rexs_coupled(model_, shaft->id));
    std::vector<std::string>& held = set_.held;
    std::vector<std::string> unloaded;
    std::vector<RexsEnd> defining, speed_only, following;
    std::map<std::string, std::string> owner;
    for (const auto& [name, parts] : bodies) {
      bool fixed = false, loaded = false, torque = false, speed = false;
      RexsEnd end;
      end.body = name;
      for (const std::string& id : parts) {
        const Component* const c = model_.find(id);
        if (!c) continue;
        if (c->type == "gear_casing") {
          fixed = true;
          continue;
        }
        if (const auto [other, is_new] = owner.emplace(id, name); !is_new)
          return not_read(c->type, *c,
                          fmt::format("couplings connect {} with {}", other->second, name));
        if (c->text("defines_speed") == "true") speed = true;
        if (!end.speed_rpm) end.speed_rpm = c->number("rotational_speed");
        for (const Component* load : model_.of_type("external_load")) {
          if (model_.related(load->id, {"assembly"}, {"shaft"}) != c) continue;
          const bool defines = load->text("defines_torque") == "true";
          if (!defines && load->text("transmits_torque") != "true") continue;
          loaded = true;
          if (!end.load || defines) end.load = load;
          if (!defines) continue;
          torque = true;
          end.torque_Nm = load->number("torque_around_u_axis");
        }
      }
      if (fixed)
        held.push_back(name);
      else if (!loaded)
        unloaded.push_back(name);
      else
        (torque ? defining : speed ? speed_only : following).push_back(end);
    }
    // The inputs that define a torque come first. Apart from this, the inputs have the order of
    // their loads in the file.
    for (auto* ends : {&defining, &speed_only})
      std::sort(ends->begin(), ends->end(),
                [](const RexsEnd& a, const RexsEnd& b) { return a.load < b.load; });
    // If only the speed of a body is defined, this body can be an input or the output. It is the
    // output if the torque of another body is defined and no other body is the output.
    if (following.empty() && !defining.empty()) std::swap(following, speed_only);
    std::copy(speed_only.begin(), speed_only.end(), std::back_inserter(defining));
    if (following.size() > 1)
      return Error{"", "",
                   fmt::format("the bodies {} and {} are both outputs, but a drive has one output; "
                               "set `defines_torque` in the load of each driving body",
                               following[0].body, following[1].body)};
    set_.inputs = defining;
    if (!following.empty()) set_.output = following[0].body;
    const std::size_t loads = defining.size() + following.size();
    if (!held.empty() || loads > 2)
      set_.fixed = held;
    else if (loads == 2 && unloaded.size() == 1)
      set_.fixed = unloaded;
    return std::nullopt;
  }

  const RexsModel& model_;
  const std::vector<RexsStage>& stages_;
  const Component& stage_;
  std::map<const Component*, std::string> member_;
  RexsSet set_;
};

}  // namespace

bool is_rexs_gear(const RexsComponent& c) {
  return c.type == "cylindrical_gear" || c.type == "ring_gear";
}

std::string rexs_name(const RexsComponent& c) {
  return c.name.empty() ? fmt::format("{} {}", c.type, c.id) : fmt::format("\"{}\"", c.name);
}

int rexs_teeth(const RexsComponent& gear) {
  const int z = static_cast<int>(std::lround(std::abs(*gear.number("number_of_teeth"))));
  return gear.type == "ring_gear" ? -z : z;
}

std::set<std::string> rexs_coupled(const RexsModel& model, const std::string& shaft) {
  std::set<std::string> group{shaft};
  for (std::size_t before = 0; before != group.size();) {
    before = group.size();
    for (const RexsRelation& r : model.relations) {
      const Component* const c = r.type == "side" ? model.find(r.of("assembly")) : nullptr;
      if (!c || (c->type != "coupling" &&
                 !(c->type == "switchable_coupling" && c->text("is_engaged") == "true")))
        continue;
      for (const auto& [from, to] :
           {std::pair("inner_part", "outer_part"), {"outer_part", "inner_part"}}) {
        const Component* const part = model.find(r.of(from));
        if (part && part->type != "gear_casing" && group.count(part->id) > 0)
          group.insert(std::string(r.of(to)));
      }
    }
  }
  return group;
}

const Component* rexs_torque(const RexsModel& model, const Component& shaft) {
  for (const Component* load : model.of_type("external_load"))
    if (load->text("defines_torque") == "true" &&
        model.related(load->id, {"assembly"}, {"shaft"}) == &shaft)
      return load;
  return nullptr;
}

bool rexs_drives(const RexsModel& model, const Component& shaft) {
  return rexs_torque(model, shaft) || shaft.text("defines_speed") == "true";
}

Result<RexsSet> set_of_rexs(const RexsModel& model, const std::vector<RexsStage>& stages,
                            const Component& planetary_stage) {
  return SetFinder(model, stages, planetary_stage).set();
}

}  // namespace gearwright
