// Interprets any bytes as a spec of two gears under errors. Tooth contact, its pattern and map, and
// the corrections end in numbers or in an error message. Values that make the computation long are
// reduced first.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/job/compensate_answer.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "tests/fuzz/fuzzing.hpp"

namespace {

using namespace gearwright;
using fuzz::require;

constexpr int kPositions = 6;
// Wide faces have hundreds of tooth pairs that may touch, each of which is examined.
constexpr int kMostTeeth = 200;
constexpr double kWidestFace = 100;  // modules

void shorten(JobSpec& spec) {
  ContactInput& c = spec.contact;
  c.positions = std::min(c.positions, kPositions);
  c.pitches = std::min(c.pitches, 2);
  if (c.rotations.size() > 3) c.rotations.resize(3);
  if (c.map) c.map->points = {2, 2};
  for (auto& range : spec.compensate.range) {
    if (&range != &spec.compensate.range[0]) range.reset();
  }
  if (spec.compensate.corrections.size() > 1) spec.compensate.corrections.resize(1);
}

bool short_enough(const JobSpec& spec) {
  for (const auto& gear : spec.gears) {
    if (!gear) return false;
    const CylindricalSpec& c = gear->cylindrical;
    if (std::abs(c.teeth) > kMostTeeth || c.face_width > kWidestFace * c.normal_module)
      return false;
  }
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto read = fuzz::spec_of(fuzz::text_of(data, size));
  if (!read || !short_enough(*read)) return 0;
  JobSpec spec = std::move(read).take();
  shorten(spec);
  const auto solved = solve(spec, Scope::pair);
  if (!solved) return 0;
  SolvedJob job = *solved;
  const auto contact = answer_contact(job);
  if (contact) {
    require(!contact_json(job, *contact).dump().empty());
    require(!contact_listing(job, *contact).empty());
    for (const ContactPoint& p : contact->driving.positions)
      require(std::isfinite(p.te.rad()) && p.point.allFinite());
  } else {
    require(!contact.error().message().empty() && !contact.error().field.empty());
  }
  job = *solved;
  constexpr int kCurves = 6;
  const auto compensation = answer_compensate(job, nullptr, kCurves);
  if (!compensation) {
    require(!compensation.error().message().empty() && !compensation.error().field.empty());
    return 0;
  }
  require(!compensate_json(job, *compensation).dump().empty());
  require(!compensate_listing(job, *compensation).empty());
  const Compensation& found = compensation->result;
  for (const double v : found.value) require(std::isfinite(v) && !(v == 0.0 && std::signbit(v)));
  if (!found.before.lost)
    require(found.after.peak_to_peak <= std::max(kQuiet, found.before.peak_to_peak + kSameError) ||
            spec.compensate.centering_arcsec);
  // Every verb accepts the corrected spec.
  require(bool(read_spec(toml_text(compensation->corrected->tables), SpecFormat::toml)));
  return 0;
}
