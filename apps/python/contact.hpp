// A contact analysis with the pair that it is about.
#pragma once

#include <memory>

#include "apps/python/model.hpp"
#include "gearwright/job/contact_answer.hpp"

namespace gearwright::python {

struct ContactValue {
  std::shared_ptr<const Model> model;  ///< with the warnings of the analysis
  std::shared_ptr<const ContactAnswer> answer;
  std::shared_ptr<const ValueRecord> record;  ///< every quantity
};

py::class_<ContactValue> bind_contact(py::module_& m, py::class_<PairValue>& pair);
void bind_sweep(py::class_<PairValue>& pair);
void bind_pictures(py::class_<GearValue>& gear, py::class_<PairValue>& pair,
                   py::class_<ContactValue>& contact);

}  // namespace gearwright::python
