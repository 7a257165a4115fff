// The result as listings for people: what a terminal shows without --json.
#pragma once

#include <string>

#include "gearwright/job/files.hpp"

namespace gearwright {

std::string gear_listing(const SolvedJob& job);
std::string pair_listing(const InvolutePair& pair);
std::string pair_listing(const ArcPair& pair);
std::string warning_listing(const std::vector<Warning>& warnings);
std::string file_listing(const std::vector<JobFile>& files);
/// One line per arc with its ends, then every point: name, x, y.
std::string outline_listing(const Outline& outline, int n);

}  // namespace gearwright
