// Implements the class Watch for builds without threads. In such builds, no second thread can show
// the progress of a computation, and a signal ends the program at once.
#include "apps/common/watch.hpp"

namespace gearwright::apps {

Watch::Watch(std::string verb, WatchWords words)
    : verb_(std::move(verb)), words_(std::move(words)) {}

Watch::~Watch() = default;

}  // namespace gearwright::apps
