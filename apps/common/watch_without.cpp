// Without threads, a computation cannot be watched. There is no line of progress, and a signal ends
// the program in the usual way.
#include "apps/common/watch.hpp"

namespace gearwright::apps {

Watch::Watch(std::string verb, WatchWords words)
    : verb_(std::move(verb)), words_(std::move(words)) {}

Watch::~Watch() = default;

}  // namespace gearwright::apps
