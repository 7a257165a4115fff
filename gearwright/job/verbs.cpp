#include "gearwright/job/verbs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/catalogue/contact_quantities.hpp"
#include "gearwright/catalogue/drive_quantities.hpp"
#include "gearwright/catalogue/fit_quantities.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/analysis.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/drive_answer.hpp"
#include "gearwright/job/fit_answer.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/measures.hpp"
#include "gearwright/job/result_rows.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

// A verb that runs after the gears and the pair have been solved.
template <class Found>
struct Solving {
  Analysis<Found> analysis;
  Json (*record)(const SolvedJob&, const Found&) = nullptr;  // instead of the quantities alone
  std::string (*listing)(const SolvedJob&, const Found&);
  std::string (*csv)(const SolvedJob&, const Found&) = nullptr;
  std::vector<Json> (*specs)(const Found&) = nullptr;
  std::vector<std::vector<std::string>> (*notes)(const Found&) = nullptr;
  Json (*rows)(const Found&, UnitSystem) = nullptr;
  bool rack = false;  // true if the verb accepts a rack
};

template <class Found>
Result<Answer> solved_answer(const Solving<Found>& how, const JobSpec& spec, Progress* progress) {
  struct State {
    SolvedJob job;
    Found found;
  };
  const Analysis<Found>& analysis = how.analysis;
  auto solved = how.rack ? solve_any(spec, analysis.scope) : solve(spec, analysis.scope);
  if (!solved) return solved.error();
  SolvedJob job = std::move(solved).take();
  auto found = analysis.find(job, progress);
  if (!found) return found.error();
  Answer answer;
  answer.record = how.record ? how.record(job, *found) : titled_record(analysis, job, *found);
  answer.warnings = job.warnings;
  answer.verdict = analysis.judge(job, *found);
  if (how.specs != nullptr) answer.specs = how.specs(*found);
  if (how.notes != nullptr) answer.notes = how.notes(*found);
  const auto state = std::make_shared<const State>(State{std::move(job), std::move(found).take()});
  answer.listing = [state, form = how.listing] { return form(state->job, state->found); };
  if (how.csv != nullptr)
    answer.csv = [state, form = how.csv] { return form(state->job, state->found); };
  if (how.rows != nullptr)
    answer.rows = [state, form = how.rows](UnitSystem units) { return form(state->found, units); };
  return answer;
}

template <const auto& (*quantities)(), class Found>
Json table_rows(const Found& found, UnitSystem units) {
  const QuantityTable& table = quantities().table();
  return rows_json(units, {.name = table.name,
                           .quantities = table,
                           .records = {quantities().of(found)},
                           .range = RowRange::shown});
}

// The result of verbs that need only the gears and the pair. It is empty.
struct AsSolved {};

constexpr Analysis<AsSolved> as_solved(Scope scope) {
  return {.scope = scope,
          .find = [](SolvedJob&, Progress*) { return Result<AsSolved>(AsSolved{}); },
          .judge = [](const SolvedJob& job, const AsSolved&) { return judge(job); }};
}

Json solved_record(const SolvedJob& job, const AsSolved&) { return job_record(job); }

std::string solved_csv(const SolvedJob& job, const AsSolved&) { return quantities_csv(job); }

Result<Answer> run_pair(const JobSpec& spec, Progress* progress) {
  return solved_answer<AsSolved>(
      {.analysis = as_solved(Scope::pair),
       .record = solved_record,
       .listing = [](const SolvedJob& job,
                     const AsSolved&) { return gear_listing(job) + pair_listing(job); },
       .csv = solved_csv,
       .rack = true},
      spec, progress);
}

Result<Answer> run_gear(const JobSpec& spec, Progress* progress) {
  if (spec.rack) return run_pair(spec, progress);
  return solved_answer<AsSolved>(
      {.analysis = as_solved(Scope::gears),
       .record = solved_record,
       .listing = [](const SolvedJob& job, const AsSolved&) { return gear_listing(job); },
       .csv = solved_csv},
      spec, progress);
}

using Measures = std::vector<GearMeasures>;

Result<Answer> run_measure(const JobSpec& spec, Progress* progress) {
  return solved_answer<Measures>(
      {.analysis = {.scope = Scope::gears,
                    .find = [](SolvedJob& job, Progress*) { return measure_gears(job); },
                    .judge = [](const SolvedJob& job, const Measures&) { return judge(job); }},
       .record = measures_record,
       .listing = measure_listing,
       .csv = measure_csv},
      spec, progress);
}

Result<Answer> run_contact(const JobSpec& spec, Progress* progress) {
  return solved_answer<ContactAnswer>({.analysis = kContactAnalysis,
                                       .listing = contact_listing,
                                       .csv = contact_csv,
                                       .rows = table_rows<contact_quantities, ContactAnswer>,
                                       .rack = true},
                                      spec, progress);
}

Result<Answer> run_compensate(const JobSpec& spec, Progress* progress) {
  return solved_answer<CompensateAnswer>(
      {.analysis = kCompensateAnalysis,
       .listing = compensate_listing,
       .specs = [](const CompensateAnswer& a) { return std::vector{a.corrected->tables}; }},
      spec, progress);
}

Result<Answer> run_propose(const JobSpec& spec, Progress* progress) {
  return solved_answer<ProposeAnswer>(
      {.analysis = kProposeAnalysis,
       .listing = propose_listing,
       .csv = [](const SolvedJob& job, const ProposeAnswer& a) { return propose_csv(job, a); },
       .specs = [](const ProposeAnswer& a) { return a.specs; },
       .notes = [](const ProposeAnswer& a) { return a.notes; }},
      spec, progress);
}

Result<Answer> run_scatter(const JobSpec& spec, Progress* progress) {
  auto answer = solved_answer<ScatterAnswer>(
      {.analysis = kScatterAnalysis,
       .listing = scatter_listing,
       .csv = scatter_csv,
       .specs =
           [](const ScatterAnswer& a) {
             return a.robust ? std::vector{a.robust->corrected->tables} : std::vector<Json>{};
           }},
      spec, progress);
  if (!answer) return answer.error();
  Answer found = std::move(answer).take();
  if (found.specs.empty())
    found.why_none =
        "the spec has no table [scatter.robust], which lists the corrections that are to be "
        "computed";
  return found;
}

Result<Answer> run_load(const JobSpec& spec, Progress* progress) {
  return solved_answer<LoadAnalysis>(
      {.analysis = kLoadAnalysis, .listing = load_listing, .csv = load_csv}, spec, progress);
}

// Returns a function that gives the source of a quantity of a rating. The source is the clause of
// the standard and, if the clause distinguishes cases, the case that applies.
auto sources_of(const RatingAnswer& answer, UnitSystem units) {
  return [&answer, units](const QuantityInfo& info) {
    return sentence_in(units, source_text(answer.rating, info.key));
  };
}

// Returns a table of the inputs, factors and safety factors. Each row contains the symbol, the
// values, the unit and the source of a quantity.
std::string rating_listing(const SolvedJob& job, const RatingAnswer& answer) {
  const auto& quantities = rating_quantities();
  return title_listing(job.spec, "\n") + quantity_listing(job.spec.units(), quantities.table(),
                                                          {quantities.of(answer)}, gear_columns(2),
                                                          sources_of(answer, job.spec.units()));
}

Json rating_rows(const RatingAnswer& answer, UnitSystem units) {
  const auto& quantities = rating_quantities();
  return rows_json(units, {.name = "rating",
                           .quantities = quantities.table(),
                           .records = {quantities.of(answer)},
                           .note = sources_of(answer, units)});
}

Result<Answer> run_rate(const JobSpec& spec, Progress* progress) {
  if (spec.drive) return answer_drive_rating(spec, progress);
  return solved_answer<RatingAnswer>({.analysis = kRatingAnalysis,
                                      .listing = rating_listing,
                                      .csv = rating_csv,
                                      .rows = rating_rows},
                                     spec, progress);
}

// Returns the answer of a verb that completes an incomplete spec. Answer::specs contains the
// completed specs.
template <class Found>
Answer proposals(UnitSystem units, Found&& found, Json (*record)(const Found&),
                 std::string (*listing)(const Found&, UnitSystem)) {
  Answer answer;
  answer.record = record(found);
  answer.specs = found.specs;
  const auto state = std::make_shared<const Found>(std::move(found));
  answer.listing = [state, listing, units] { return listing(*state, units); };
  return answer;
}

Result<Answer> run_identify(const JobSpec& spec, Progress*) {
  auto found = answer_identify(spec);
  if (!found) return found.error();
  auto notes = found->notes;
  auto warnings = found->warnings;
  Answer answer = proposals(spec.units(), std::move(found).take(), identify_json, identify_listing);
  answer.notes = std::move(notes);
  answer.warnings = std::move(warnings);
  return answer;
}

Result<Answer> run_fit(const JobSpec& spec, Progress* progress) {
  auto found = answer_fit(spec, progress);
  if (!found) return found.error();
  std::string reason = found->fit.reason;
  Answer answer = proposals(spec.units(), std::move(found).take(), fit_json, fit_listing);
  answer.why_none = std::move(reason);
  return answer;
}

Result<Answer> run_drive(const JobSpec& spec, Progress* progress) {
  return answer_drive(spec, progress);
}

// Runs the whole search in memory. For a search in a folder, by one process or by several, the
// programs call run_search() themselves, with the options of the folder.
Result<Answer> run_search_in_memory(const JobSpec& spec, Progress* progress) {
  if (searches_drives(spec)) return answer_drive_search(spec, kDefaultDrives, 0, progress);
  if (!spec.search) return no_search();
  const auto search = std::make_shared<const Search>(*spec.search);
  SearchOptions options;
  options.progress = [progress](const SearchProgress&) { count_step(progress); };
  auto found = run_search(spec, *search, options);
  if (!found) return found.error();
  const auto run = std::make_shared<const SearchRun>(std::move(found).take());
  Answer answer;
  answer.record = search_json(*search, *run, UnitSystem::mm);
  const auto& designs = run->answer.designs;
  for (std::size_t i = 0; i < std::min(designs.size(), kListedDesigns); ++i)
    answer.specs.push_back(pair_spec(spec, *search, designs[i]));
  answer.listing = [=, units = spec.units()] { return search_listing(*search, *run, units); };
  answer.json = [=, units = spec.units()] { return search_json_text(*search, *run, units); };
  return answer;
}

using Take = Verb::Take;

constexpr Verb kVerbs[] = {
    {"gear", "Geometry of each gear: diameters, tooth thicknesses, limits",
     "gearwright gear examples/helical_pair.toml --json", SpecUse::geometry, true, true, false,
     Take::none, "", run_gear},
    {"pair", "The mounted pair: distances, angles, contact ratios, backlash, sliding",
     "gearwright pair examples/helical_pair.toml", SpecUse::pair, true, true, false, Take::none, "",
     run_pair},
    {"contact",
     "Tooth contact under [errors] of the spec: transmission error, contact points, edges, "
     "ellipses",
     "gearwright contact examples/misaligned_pair.toml", SpecUse::pair, true, true, true,
     Take::none, "", run_contact, "contact", quantities_table<contact_quantities>},
    {"compensate",
     "Corrections of tool settings, leads and flanks that compensate [errors] of the spec",
     "gearwright compensate examples/misaligned_pair.toml --take", SpecUse::compensate, false, true,
     true, Take::flag, "Print only the corrected spec", run_compensate, "compensate",
     quantities_table<compensate_quantities>},
    {"propose",
     "Tip and root relief, helix crowning and slope for the load, and the effect of each proposal",
     "gearwright propose examples/quiet_pair.toml", SpecUse::propose, true, true, true,
     Take::number,
     "Print only the spec of the proposal with this number; proposal 1 is the spec as given",
     run_propose, "propose", quantities_table<propose_quantities>},
    {"scatter",
     "Effect of tolerances on the pair: percentiles, probabilities, influence of each tolerance, "
     "worst case",
     "gearwright scatter examples/scattered_pair.toml", SpecUse::scatter, true, true, true,
     Take::flag, "Print only the spec with the corrections of [scatter.robust]", run_scatter,
     "scatter", quantities_table<scatter_quantities>},
    {"load",
     "Teeth under torque: load sharing, loaded transmission error, stiffness, pressure, root "
     "stress",
     "gearwright load examples/loaded_pair.toml", SpecUse::load, true, true, true, Take::none, "",
     run_load, "load", quantities_table<load_quantities>},
    {"rate",
     "Strength by ISO 6336: every factor with its clause of the standard, stresses, safeties",
     "gearwright rate examples/rated_pair.toml", SpecUse::rate, true, true, false, Take::none, "",
     run_rate, "rating", quantities_table<rating_quantities>},
    {"drive",
     "Whole drives (planetary sets and trains): ratios, power, assembly, phases, backlash, "
     "transmission error",
     "gearwright drive examples/drives/planetary_set.toml", SpecUse::geometry, true, true, false,
     Take::number,
     "Print only the spec of the mesh with this number as a pair; 1 is the first mesh", run_drive,
     "drive", quantities_table<drive_quantities>},
    {"measure", "Spans, dimensions over balls and pins, chords, tolerances of the flanks",
     "gearwright measure examples/helical_pair.toml", SpecUse::geometry, true, true, false,
     Take::none, "", run_measure},
    {"identify", "The gears that match the readings of an unknown gear, the likeliest first",
     "gearwright identify examples/broken_gear.toml", SpecUse::geometry, false, false, false,
     Take::number, "Print only the spec of the candidate with this number", run_identify,
     "identify", quantities_table<identify_quantities>},
    {"fit",
     "Computation of absent values: gears for given shafts, or shaft positions for given gears",
     "gearwright fit examples/crossed_fit.toml", SpecUse::geometry, false, false, true,
     Take::number, "Print only the spec of the branch with this number", run_fit, "fit",
     quantities_table<fit_quantities>},
    {"search",
     "All designs that satisfy the table [search] of the spec, ranked, with the region of feasible "
     "profile shifts of each design",
     "gearwright search examples/gearbox_search.toml --out found\n"
     "  gearwright search examples/gearbox_search.toml --take 1 > pair.toml\n"
     "  gearwright search wide.toml --out wide --shard 3/8     on each of eight machines",
     SpecUse::geometry, false, false, true, Take::number,
     "Print the spec of the design with this rank and nothing else", run_search_in_memory, "search",
     quantities_table<search_quantities>},
};

Json with_verdict(Json json, const Answer& answer) {
  if (answer.verdict || !answer.warnings.empty()) json["warnings"] = warnings_json(answer.warnings);
  if (answer.verdict) json["verdict"] = verdict_json(*answer.verdict);
  if (answer.units == UnitSystem::mm) return json;
  return in_units(answer.units, json);
}

}  // namespace

Json answer_json(const Answer& answer) { return with_verdict(answer.record, answer); }

std::string answer_json_text(const Answer& answer) {
  return answer.json ? answer.json() : json_text(answer_json(answer), 2) + "\n";
}

std::string answer_text(const Answer& answer) {
  return answer.listing() + warning_listing(answer.warnings, answer.units) +
         (answer.verdict ? verdict_listing(*answer.verdict, answer.units) : "");
}

Result<Answer> Verb::run(const JobSpec& spec, Progress* progress) const {
  auto found = solve(spec, progress);
  return found ? Result<Answer>(in_units_of(spec, std::move(found).take())) : found;
}

Answer in_units_of(const JobSpec& spec, Answer answer) {
  if (spec.units() == UnitSystem::mm) return answer;
  const UnitSystem units = answer.units = spec.units();
  const auto convert = [units](std::vector<Json>& specs, auto& notes_of_specs) {
    for (Json& each : specs) each = spec_in(units, each);
    for (auto& notes : notes_of_specs)
      for (std::string& note : notes) note = sentence_in(units, note);
  };
  convert(answer.specs, answer.notes);
  if (answer.drive_specs)
    answer.drive_specs = [convert, units, make = std::move(answer.drive_specs)] {
      DriveSpecs made = make();
      made.expanded = spec_in(units, made.expanded);
      convert(made.meshes, made.notes);
      return made;
    };
  answer.why_none = sentence_in(answer.units, answer.why_none);
  return answer;
}

std::span<const Verb> verbs() { return kVerbs; }

const Verb* find_verb(std::string_view name) {
  const auto it = std::find_if(std::begin(kVerbs), std::end(kVerbs),
                               [&](const Verb& verb) { return verb.name == name; });
  return it == std::end(kVerbs) ? nullptr : it;
}

std::string verb_names() {
  std::string names;
  for (const Verb& verb : kVerbs) names += (names.empty() ? "" : ", ") + std::string(verb.name);
  return names;
}

Result<Json> answer_json(std::string_view name, const JobSpec& spec, Progress* progress) {
  const Verb* const verb = find_verb(!name.empty()                ? name
                                     : spec.gears[1] || spec.rack ? "pair"
                                                                  : "gear");
  GW_EXPECTS(verb != nullptr);
  auto found = verb->run(spec, progress);
  if (!found) return found.error();
  Answer answer = std::move(found).take();
  return with_verdict(std::move(answer.record), answer);
}

BatchLine batch_line(const std::function<Result<Json>(const JobSpec&)>& answer,
                     const std::string& text, SpecUse use) {
  using enum BatchLine::Outcome;
  const auto failure = [](const Error& error) {
    return BatchLine{json_text(error_json(error)),
                     error.kind == FailureKind::defect ? violated : failed};
  };
  if (text.size() > kMaxSpec) {
    return failure({"", "",
                    fmt::format("this line has {} bytes; at most {} are allowed for a spec",
                                text.size(), kMaxSpec)});
  }
  try {
    const auto spec = read_spec(text, SpecFormat::json, {}, use);
    if (!spec) return failure(spec.error());
    const auto json = answer(*spec);
    return json ? BatchLine{json_text(*json)} : failure(spelled(json.error(), spec->given));
  } catch (const IoError& e) {  // a file named in the spec
    return failure({"", "", e.what(), FailureKind::file});
  } catch (const ContractViolation& e) {
    return failure({"", "", e.what(), FailureKind::defect});
  }
}

BatchLine batch_line(std::string_view name, const std::string& text) {
  const Verb* const verb = find_verb(name);
  return batch_line([name](const JobSpec& spec) { return answer_json(name, spec); }, text,
                    verb ? verb->use : SpecUse::geometry);
}

}  // namespace gearwright
