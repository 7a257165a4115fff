// Without threads nobody can wait beside the work: no line of progress, and a signal ends the
// program as it ends any other.
#include "apps/common/watch.hpp"

namespace gearwright::apps {

Watch::Watch(std::string verb) : verb_(std::move(verb)), terminal_(false) {}

Watch::~Watch() = default;

}  // namespace gearwright::apps
