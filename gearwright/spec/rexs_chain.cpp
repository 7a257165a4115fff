#include "gearwright/spec/rexs_chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gearwright/base/lists.hpp"

namespace gearwright {

namespace {

using Component = RexsComponent;

bool meet(const RexsTerminal& a, const RexsTerminal& b) {
  return std::any_of(a.parts.begin(), a.parts.end(),
                     [&](const std::string& id) { return b.parts.count(id) > 0; });
}

class Chain {
 public:
  Chain(const RexsModel& model, std::vector<RexsLink> links)
      : model_(model), links_(std::move(links)) {}

  Result<std::vector<RexsLink>> chain() {
    auto next = start();
    while (next) {
      const auto [k, t] = *next;
      RexsLink link = links_[k];
      used_.insert(k);
      const auto output = output_of(k, t);
      if (!output)
        return Error{"", "",
                     fmt::format("the output of the planetary set with input {} is not known; give "
                                 "its output a load, or connect its other bodies with the casing",
                                 link.terminals[t].body)};
      link.input = link.terminals[t].body;
      link.output = link.terminals[*output].body;
      if (!link.set && t == 1) std::swap(link.pair.gears[0], link.pair.gears[1]);
      if (link.set) link.fixed = fixed_of(k, t, *output);
      const RexsTerminal shaft = link.terminals[*output];
      chain_.push_back(std::move(link));
      next = on(shaft);
    }
    if (used_.size() == links_.size()) return std::move(chain_);
    return Error{
        "", "",
        fmt::format("the {} stages do not form a chain from one shaft to the next; describe "
                    "such a gear unit by [drive], or use a separate file for each stage",
                    links_.size())};
  }

 private:
  using Place = std::pair<std::size_t, std::size_t>;  // indices of a link and of its terminal

  // Returns an unused link with a terminal that meets this shaft, or none.
  std::optional<Place> on(const RexsTerminal& shaft) const {
    for (std::size_t k = 0; k < links_.size(); ++k) {
      if (used_.count(k) > 0) continue;
      for (std::size_t t = 0; t < links_[k].terminals.size(); ++t)
        if (meet(shaft, links_[k].terminals[t])) return Place{k, t};
    }
    return std::nullopt;
  }

  bool is_end(std::size_t link, const RexsTerminal& shaft) const {
    for (std::size_t k = 0; k < links_.size(); ++k)
      for (const RexsTerminal& other : links_[k].terminals)
        if (k != link && meet(shaft, other)) return false;
    return true;
  }

  std::optional<Place> start() const {
    std::optional<Place> first;
    bool inside = false;  // true if a torque or a speed is given for a shaft between two links
    for (const Component* shaft : model_.of_type("shaft"))
      for (std::size_t k = 0; k < links_.size(); ++k)
        for (std::size_t t = 0; t < links_[k].terminals.size(); ++t) {
          const RexsTerminal& end = links_[k].terminals[t];
          if (end.parts.count(shaft->id) == 0) continue;
          const bool drives = rexs_drives(model_, *shaft), is_inside = !is_end(k, end);
          inside = inside || (drives && is_inside);
          if (is_inside) continue;
          if (drives) return Place{k, t};
          if (!first && (!links_[k].set || end.body == "sun")) first = Place{k, t};
        }
    return inside ? std::nullopt : first;
  }

  bool is_loaded(const RexsTerminal& shaft) const {
    for (const Component* load : model_.of_type("external_load"))
      if (const Component* part = model_.related(load->id, {"assembly"}, {"shaft"}))
        if (shaft.parts.count(part->id) > 0) return true;
    return false;
  }

  std::optional<std::size_t> output_of(std::size_t link, std::size_t input) const {
    const auto& terminals = links_[link].terminals;
    std::vector<std::size_t> others, driven;
    for (std::size_t t = 0; t < terminals.size(); ++t) {
      if (t == input) continue;
      others.push_back(t);
      if (on(terminals[t]) || is_loaded(terminals[t])) driven.push_back(t);
    }
    if (driven.size() == 1) return driven.front();
    return others.size() == 1 ? std::optional(others.front()) : std::nullopt;
  }

  std::vector<std::string> fixed_of(std::size_t link, std::size_t input, std::size_t output) const {
    const RexsLink& own = links_[link];
    if (!own.set->held.empty() || own.terminals.size() != 3) return own.set->held;
    return {own.terminals[3 - input - output].body};
  }

  const RexsModel& model_;
  std::vector<RexsLink> links_, chain_;
  std::set<std::size_t> used_;
};

}  // namespace

Result<std::vector<RexsLink>> rexs_links(const RexsModel& model,
                                         const std::vector<RexsStage>& stages) {
  const auto sets = model.of_type("planetary_stage");
  const bool shafts = std::any_of(model.relations.begin(), model.relations.end(),
                                  [](const RexsRelation& r) { return r.type == "planet_shaft"; });
  const auto shaft_of = [&](const Component* gear) {
    return model.related(gear->id, {"assembly"}, {"shaft"});
  };
  // The index of the set that contains a stage.
  const auto set_with = [&](const RexsStage& s) -> std::optional<std::size_t> {
    if (sets.size() == 1 && !shafts) return 0;
    for (const RexsRelation& r : model.relations)
      for (const Component* gear : s.gears) {
        const Component* const shaft = r.type == "planet_shaft" ? shaft_of(gear) : nullptr;
        if (!shaft || r.of("shaft") != shaft->id) continue;
        for (std::size_t k = 0; k < sets.size(); ++k)
          if (sets.size() == 1 || r.of("planetary_stage") == sets[k]->id) return k;
      }
    return std::nullopt;
  };
  std::vector<RexsLink> links;
  std::vector<std::vector<RexsStage>> own(sets.size());
  for (const RexsStage& s : stages) {
    if (const auto k = set_with(s)) {
      own[*k].push_back(s);
      continue;
    }
    RexsLink& pair = links.emplace_back();
    pair.pair = s;
    for (const std::size_t i : {0U, 1U}) {
      const Component* const shaft = shaft_of(s.gears[i]);
      pair.terminals.push_back({i == 0 ? "gear1" : "gear2",
                                shaft ? rexs_coupled(model, shaft->id) : std::set<std::string>()});
    }
  }
  for (std::size_t k = 0; k < sets.size(); ++k) {
    auto set = set_of_rexs(model, own[k], *sets[k]);
    if (!set) return set.error();
    RexsLink& link = links.emplace_back();
    for (const auto& [body, parts] : set->bodies)
      if (!is_in(body, set->held)) link.terminals.push_back({body, parts});
    link.set = std::move(set).take();
  }
  return links;
}

Result<std::vector<RexsLink>> rexs_chain(const RexsModel& model, std::vector<RexsLink> links) {
  return Chain(model, std::move(links)).chain();
}

}  // namespace gearwright
