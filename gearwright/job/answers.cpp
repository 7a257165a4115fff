#include "gearwright/job/answers.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "gearwright/base/output_file.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/compensate_text.hpp"
#include "gearwright/job/contact_text.hpp"
#include "gearwright/job/fit_answer.hpp"
#include "gearwright/job/identify_answer.hpp"
#include "gearwright/job/load_text.hpp"
#include "gearwright/job/measures.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

namespace {

constexpr int kItemsPerThread = 4;

Result<Json> contact_of(SolvedJob& job) {
  const auto found = answer_contact(job);
  if (!found) return found.error();
  return contact_json(job, *found);
}

Result<Json> compensation_of(SolvedJob& job) {
  const auto found = answer_compensate(job);
  if (!found) return found.error();
  return compensate_json(job, *found);
}

Result<Json> load_of(SolvedJob& job) {
  const auto found = answer_load(job);
  if (!found) return found.error();
  return load_json(job, *found);
}

Result<Json> measures_of(SolvedJob& job) {
  const auto found = measure_gears(job);
  if (!found) return found.error();
  return measures_json(job, *found);
}

Scope scope_of(std::string_view verb) {
  if (verb.empty() || verb == "load") return Scope::everything;
  return verb == "gear" || verb == "measure" ? Scope::gears : Scope::pair;
}

}  // namespace

Result<Json> answer_json(std::string_view verb, const JobSpec& spec) {
  GW_EXPECTS(verb.empty() ||
             std::find(kAnswering.begin(), kAnswering.end(), verb) != kAnswering.end());
  if (verb == "fit") {
    const auto found = answer_fit(spec);
    if (!found) return found.error();
    return fit_json(*found);
  }
  if (verb == "identify") {
    const auto found = answer_identify(spec);
    if (!found) return found.error();
    return identify_json(*found);
  }
  auto solved = solve(spec, scope_of(verb));
  if (!solved) return solved.error();
  SolvedJob job = std::move(solved).take();
  if (verb == "contact") return contact_of(job);
  if (verb == "compensate") return compensation_of(job);
  if (verb == "load") return load_of(job);
  if (verb == "measure") return measures_of(job);
  return job_json(job);
}

std::string batch_line(std::string_view verb, const std::string& text) {
  const auto failed = [](const Error& error) { return json_text(error_json(error)); };
  if (text.size() > kMaxSpec) {
    return failed({"", "",
                   fmt::format("this line has {} bytes; a spec has at most {}, more than any gear "
                               "needs",
                               text.size(), kMaxSpec)});
  }
  try {
    const auto spec = read_spec(text, SpecFormat::json);
    if (!spec) return failed(spec.error());
    const auto answer = answer_json(verb, *spec);
    return answer ? json_text(*answer) : failed(spelled(answer.error(), spec->given));
  } catch (const IoError& e) {  // a file that the spec names: the other lines go on
    return failed({"", "", e.what()});
  }
}

void in_order(const std::function<bool(std::string&)>& next,
              const std::function<std::string(const std::string&)>& work,
              const std::function<void(const std::string&)>& take, int threads) {
  const auto count = static_cast<std::size_t>(
      threads > 0 ? threads : std::max(1, tbb::info::default_concurrency()));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
  using Item = std::shared_ptr<std::string>;
  tbb::parallel_pipeline(
      count * kItemsPerThread,
      tbb::make_filter<void, Item>(tbb::filter_mode::serial_in_order,
                                   [&](tbb::flow_control& flow) -> Item {
                                     auto item = std::make_shared<std::string>();
                                     if (!next(*item)) flow.stop();
                                     return item;
                                   }) &
          tbb::make_filter<Item, Item>(tbb::filter_mode::parallel,
                                       [&](const Item& item) -> Item {
                                         return std::make_shared<std::string>(work(*item));
                                       }) &
          tbb::make_filter<Item, void>(tbb::filter_mode::serial_in_order,
                                       [&](const Item& item) { take(*item); }));
}

}  // namespace gearwright
