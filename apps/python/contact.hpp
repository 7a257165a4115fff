// A contact analysis with the pair that it is about, and what else a pair is asked.
#pragma once

#include "apps/python/answer_value.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/judgement.hpp"

namespace gearwright::python {

struct ContactValue : AnswerValue<ContactAnswer> {
  Verdict verdict() const { return judge(model->job, {.contact = &answer->driving}); }
};

py::class_<ContactValue> bind_contact(py::module_& m, py::class_<PairValue>& pair);
void bind_under_load(py::module_& m, py::class_<PairValue>& pair);
void bind_sweep(py::class_<PairValue>& pair);
void bind_pictures(py::class_<GearValue>& gear, py::class_<PairValue>& pair,
                   py::class_<ContactValue>& contact);

}  // namespace gearwright::python
