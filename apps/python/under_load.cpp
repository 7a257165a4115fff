// A pair under load: its strength by the standard, and its teeth as they yield.
#include <fmt/format.h>

#include "apps/python/answer_value.hpp"
#include "apps/python/arrays.hpp"
#include "gearwright/catalogue/load_keys.hpp"
#include "gearwright/catalogue/rating_keys.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/rating_answer.hpp"

namespace gearwright::python {

namespace {

struct RatingValue : AnswerValue<RatingAnswer> {
  Verdict verdict() const { return judge(model->job, {.rating = answer.get()}); }
};

struct LoadedValue : AnswerValue<LoadAnalysis> {
  Verdict verdict() const { return judge(model->job, {.load = true}); }
};

RatingValue rating_of(const PairValue& pair, const py::kwargs& keys) {
  return answered<RatingValue>(
      asked_model(pair, py::none(), py::none(), rating_keys(), "rating", keys),
      [](SolvedJob& job, Progress* progress) { return answer_rating(job, progress); },
      [](const SolvedJob&, const RatingAnswer& a) { return rating_quantities().of(a.view()); });
}

LoadedValue loaded_of(const PairValue& pair, const py::object& errors,
                      const py::object& modifications, const py::kwargs& keys) {
  return answered<LoadedValue>(
      asked_model(pair, errors, modifications, load_keys(), "load", keys),
      [](SolvedJob& job, Progress* progress) { return answer_load(job, progress); },
      [](const SolvedJob& job, const LoadAnalysis& a) {
        return load_quantities().of(load_view(job, a));
      });
}

// A row for each torque, in it the positions.
py::object positions_of(const LoadedValue& loaded) {
  if (!loaded.answer->contact) return py::none();
  const std::vector<LoadedTorque>& torques = loaded.answer->contact->torques;
  const std::size_t each = torques.front().positions.size();
  StructuredArray array;
  array.add_columns(load_position_quantities().table());
  array.allocate(torques.size() * each);
  std::size_t row = 0;
  for (const LoadedTorque& t : torques)
    for (const LoadedPosition& p : t.positions)
      array.fill(row++, load_position_quantities(),
                 LoadPositionView{&t, &p, loaded.answer->contact->regime});
  return array.take().attr("reshape")(torques.size(), each);
}

}  // namespace

void bind_under_load(py::module_& m, py::class_<PairValue>& pair) {
  py::class_<RatingValue> rating(m, "Rating", "The strength of a pair by the standard");
  bind_answer<RatingValue>(rating, rating_quantities().table(),
                           [](const PairValue& pair) { return rating_of(pair, {}); });
  rating.def("__repr__", [](const RatingValue& r) {
    const Rating& made = r.answer->rating;
    return fmt::format("Rating(S_H={:.4g} / {:.4g}, S_F={:.4g} / {:.4g})", made.S_H[0].value,
                       made.S_H[1].value, made.S_F[0].value, made.S_F[1].value);
  });
  py::class_<LoadedValue> loaded(m, "Loaded", "A pair under torque, its teeth yielding");
  bind_answer<LoadedValue>(loaded, load_quantities().table(), [](const PairValue& pair) {
    return loaded_of(pair, py::none(), py::none(), {});
  });
  loaded
      .def_property_readonly(
          "positions", &positions_of,
          "A structured array (torques, positions), a column for each quantity by key; load "
          "shares, "
          "as many as pairs carry, are those of torques[i].positions. None where only probes were "
          "asked")
      .def("__repr__", [](const LoadedValue& l) {
        const std::size_t torques = l.answer->contact ? l.answer->contact->torques.size() : 0;
        return fmt::format("Loaded({} torques, {} probes)", torques, l.answer->probes.size());
      });
  pair.def("rate", &rating_of,
           "Strength by ISO 6336 or VDI 2736, with keys of [rating]: torque_Nm, speed_rpm, "
           "quality, …; what is not given is as in the pair's spec. Gears have their material, "
           "material={\"name\": \"18CrNiMo7-6\"}")
      .def("loaded", &loaded_of, py::arg("errors") = py::none(),
           py::arg("modifications") = py::none(),
           "The pair under torque, with keys of [load]: torque_Nm=[100, 200], positions, slices, "
           "…; errors and modifications as contact(). What is not given is as in the pair's spec");
}

}  // namespace gearwright::python
