#include "gearwright/job/rating_text.hpp"

#include <nlohmann/json.hpp>

#include "gearwright/base/printable.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/value_json.hpp"

namespace gearwright {

Json rating_json(const SolvedJob& job, const RatingAnswer& answer) {
  Json record = titled_record(job.spec);
  record["rating"] = to_json(rating_quantities().of(answer.view()));
  return record;
}

std::string rating_listing(const SolvedJob& job, const RatingAnswer& answer) {
  const auto& quantities = rating_quantities();
  const std::string& title = job.spec.title;
  return (title.empty() ? "" : "\n" + printable(title) + "\n") +
         quantity_listing(quantities.table(), {quantities.of(answer.view())}, gear_columns(2),
                          [&](const QuantityInfo& s) { return source_text(answer.rating, s.key); });
}

}  // namespace gearwright
