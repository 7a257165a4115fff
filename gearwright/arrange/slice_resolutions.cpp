#include "gearwright/arrange/slice_resolutions.hpp"

#include <algorithm>

namespace gearwright {

Result<SliceResolutions::Solved> SliceResolutions::solve(
    LoadTask task,
    const std::function<Contacts(const LoadTask&, const PairCompliance&)>& contacts_of) {
  for (std::size_t i = 0;; ++i) {
    if (i == known_.size()) {
      auto made = task.compliance();
      if (!made) return made.error();
      known_.push_back(std::move(made).take());
    }
    const PairCompliance& compliance = known_[i];
    task.request.slices = {compliance.slices[0].count, compliance.slices[1].count};
    Solved found{task.request.slices, &compliance, contacts_of(task, compliance)};
    const bool too_fine =
        std::any_of(found.contacts.begin(), found.contacts.end(),
                    [](const LoadedContact& contact) { return contact.slices_too_fine; });
    if (!too_fine || given_) return found;
    if (i + 1 == known_.size() && !halve_slices(task.request.slices)) return found;
  }
}

}  // namespace gearwright
