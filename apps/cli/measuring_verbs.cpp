// The verbs of the workshop: what is measured of a gear, and which gear it was that measured so.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/cli/door.hpp"
#include "apps/common/speaking.hpp"
#include "gearwright/job/identify_answer.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/measures.hpp"
#include "gearwright/job/nominal_csv.hpp"

namespace gearwright::cli {

int measure_verb(const Options& o) {
  const auto grid = parse_grid(o.grid.value_or("2x2"));
  if (!grid)
    return usage("--points takes two numbers from 2 to 1000, along the profile and the face: 9x5");
  Door door(o);
  auto solved = door.solve(Scope::gears);
  if (!solved) return door.fail(solved.error());
  SolvedJob job = std::move(solved).take();
  if (o.grid) {
    const auto points = nominal_csv(job, *grid, o.fillet_points);
    if (!points) return door.fail(points.error());
    print(*points);
    return 0;
  }
  const auto measures = measure_gears(job);
  if (!measures) return door.fail(measures.error());
  if (o.json) {
    print_json(measures_json(job, *measures));
  } else {
    print(measure_listing(job, *measures) + warning_listing(job.warnings));
  }
  return 0;
}

int identify_verb(const Options& o) {
  Door door(o);
  const auto spec = door.read();
  if (!spec) return door.fail(spec.error());
  const auto answer = answer_identify(*spec);
  if (!answer) return door.fail(answer.error());
  if (o.take) {
    return take_spec(o, door, answer->specs,
                     fmt::format("there are {} candidates", answer->specs.size()));
  }
  if (o.json) {
    print_json(identify_json(*answer));
  } else {
    print(identify_listing(*answer));
  }
  return 0;
}

}  // namespace gearwright::cli
