// What a verb says of a pair, as a value of Python: Contact, Rating, Loaded.
//
// Each is the pair's spec with what was asked, the answer, and every quantity of it as an attribute; a kind adds
// `Verdict verdict() const`.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "apps/python/model.hpp"
#include "apps/python/pickles.hpp"
#include "apps/python/watched.hpp"
#include "gearwright/catalogue/verdict_quantities.hpp"

namespace gearwright::python {

template <class A>
struct AnswerValue {
  using Answer = A;

  std::shared_ptr<const Model> model;  ///< with the warnings of the answer
  std::shared_ptr<const Answer> answer;
  std::shared_ptr<const ValueRecord> record;  ///< every quantity
};

/// The pair's spec with other errors and modifications, None as they are, and with `keys` in its table of this name.
ModelPtr asked_model(const PairValue& pair, const py::object& errors,
                     const py::object& modifications, const KeyTable& table,
                     const std::string& name, const py::kwargs& keys);

/// solve(job, progress) as a Self, and say(job, answer) as its record; Ctrl-C stops it.
template <class Self, class Solve, class Say>
Self answered(const ModelPtr& asked, const Solve& solve, const Say& say) {
  const auto model = std::make_shared<Model>(*asked);
  std::optional<Result<typename Self::Answer>> found;
  std::shared_ptr<const ValueRecord> record;
  Watched watched;
  watch(watched, [&] {
    found = solve(model->job, &watched.progress);
    if (*found) record = std::make_shared<const ValueRecord>(say(model->job, found->value()));
  });
  if (!*found) raise(found->error(), *model);
  Self self;
  self.model = model;
  self.answer = std::make_shared<const typename Self::Answer>(std::move(*found).take());
  self.record = record;
  return self;
}

/// Attributes for all that the table says but `own`, which the kind has in a way of its own. Out of a
/// pickle comes what `of` finds of the pair again, bit for bit: an answer follows from its spec.
template <class Self>
void bind_answer(py::class_<Self>& type, const QuantityTable& table, Self (*of)(const PairValue&),
                 std::string_view own = {}) {
  bind_copies(
      type, [](const Self& s) { return py::make_tuple(to_python(s.model->spec), s.model->folder); },
      [of](const py::tuple& state) {
        return of({make_model(tree_of(state[0], ""), state[1].cast<std::filesystem::path>(),
                              Scope::pair)});
      });
  type.def(
          "as_dict", [](const Self& s) { return by_key(*s.record); },
          "Every quantity by key: what JSON has")
      .def_property_readonly(
          "spec", [](const Self& s) { return to_python(s.model->spec); },
          "What it was made from, by key")
      .def_property_readonly("pair", [](const Self& s) { return PairValue{s.model}; })
      .def_property_readonly(
          "verdict",
          [](const Self& s) { return by_name(Value(verdict_quantities().of(s.verdict()))); },
          "Whether the pair runs like this, the worst finding first")
      .def_property_readonly(
          "warnings", [](const Self& s) { return warnings_of(s.model->job.warnings); },
          "What a person should know: Records with code, message, gear");
  for (const QuantityInfo* info : table.list) {
    if (info->key == own) continue;
    type.def_property_readonly(
        name_of(*info).c_str(),
        [info](const Self& s) -> py::object {
          for (const Member& member : *s.record)
            if (member.info == info) return by_name(*info, member.value);
          return py::none();
        },
        docstring(*info).c_str());
  }
}

}  // namespace gearwright::python
