#include "gearwright/job/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/base/output_file.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/compensate_text.hpp"
#include "gearwright/job/contact_text.hpp"
#include "gearwright/job/fit_answer.hpp"
#include "gearwright/job/identify_answer.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/load_text.hpp"
#include "gearwright/job/measures.hpp"
#include "gearwright/job/rating_text.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

namespace {

Result<Json> contact_of(SolvedJob& job, Headway* headway) {
  const auto found = answer_contact(job, headway);
  if (!found) return found.error();
  return contact_json(job, *found, judge(job, {.contact = &found->driving}));
}

Result<Json> compensation_of(SolvedJob& job, Headway* headway) {
  const auto found = answer_compensate(job, headway);
  if (!found) return found.error();
  return compensate_json(job, *found);
}

Result<Json> load_of(SolvedJob& job, Headway* headway) {
  const auto found = answer_load(job, headway);
  if (!found) return found.error();
  return load_json(job, *found, judge(job, {.load = true}));
}

Result<Json> measures_of(SolvedJob& job) {
  const auto found = measure_gears(job);
  if (!found) return found.error();
  return measures_json(job, *found);
}

Result<Json> rating_of(SolvedJob& job, Headway* headway) {
  const auto found = answer_rating(job, headway);
  if (!found) return found.error();
  return rating_json(job, *found, judge(job, {.rating = &*found}));
}

Scope scope_of(std::string_view verb) {
  if (verb.empty() || verb == "load") return Scope::everything;
  return verb == "gear" || verb == "measure" ? Scope::gears : Scope::pair;
}

SpecUse use_of(std::string_view verb) {
  if (verb == "pair" || verb == "contact") return SpecUse::pair;
  if (verb == "load") return SpecUse::load;
  if (verb == "compensate") return SpecUse::compensate;
  return verb == "rate" ? SpecUse::rate : SpecUse::geometry;
}

}  // namespace

Result<Json> answer_json(std::string_view verb, const JobSpec& spec, Headway* headway) {
  GW_EXPECTS(verb.empty() ||
             std::find(kAnswering.begin(), kAnswering.end(), verb) != kAnswering.end());
  if (verb == "fit") {
    const auto found = answer_fit(spec, headway);
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
  if (verb == "contact") return contact_of(job, headway);
  if (verb == "compensate") return compensation_of(job, headway);
  if (verb == "load") return load_of(job, headway);
  if (verb == "measure") return measures_of(job);
  if (verb == "rate") return rating_of(job, headway);
  return job_json(job, judge(job));
}

BatchLine batch_line(const std::function<Result<Json>(const JobSpec&)>& answer,
                     const std::string& text, SpecUse use) {
  const auto failed = [](const Error& error) { return BatchLine{json_text(error_json(error))}; };
  if (text.size() > kMaxSpec) {
    return failed({"", "",
                   fmt::format("this line has {} bytes; a spec has at most {}, more than any gear "
                               "needs",
                               text.size(), kMaxSpec)});
  }
  try {
    const auto spec = read_spec(text, SpecFormat::json, {}, use);
    if (!spec) return failed(spec.error());
    const auto answered = answer(*spec);
    return answered ? BatchLine{json_text(*answered)}
                    : failed(spelled(answered.error(), spec->given));
  } catch (const IoError& e) {  // a file that the spec names
    return failed({"", "", e.what()});
  } catch (const ContractViolation& e) {
    return {failed({"", "", e.what()}).text, true};
  }
}

BatchLine batch_line(std::string_view verb, const std::string& text) {
  return batch_line([verb](const JobSpec& spec) { return answer_json(verb, spec); }, text,
                    use_of(verb));
}

}  // namespace gearwright
