#include "gearwright/job/analysis.hpp"

#include "gearwright/job/judgement.hpp"

namespace gearwright {

namespace {

template <const auto& (*quantities)(), class Found>
ValueRecord record_of(const SolvedJob&, const Found& found) {
  return quantities().of(found);
}

}  // namespace

const Analysis<ContactAnswer> kContactAnalysis{
    .scope = Scope::pair,
    .find = answer_contact,
    .judge = [](const SolvedJob& job,
                const ContactAnswer& a) { return judge(job, {.contact = &a.judged()}); },
    .table = quantities_table<contact_quantities>,
    .record = record_of<contact_quantities>};

const Analysis<CompensateAnswer> kCompensateAnalysis{
    .scope = Scope::pair,
    .find = [](SolvedJob& job, Progress* h) { return answer_compensate(job, h); },
    .judge = [](const SolvedJob&, const CompensateAnswer& a) { return a.verdict; },
    .table = quantities_table<compensate_quantities>,
    .record = record_of<compensate_quantities>};

const Analysis<ProposeAnswer> kProposeAnalysis{
    .scope = Scope::pair,
    .find = answer_propose,
    .judge = [](const SolvedJob&, const ProposeAnswer& a) { return a.verdict; },
    .table = quantities_table<propose_quantities>,
    .record = record_of<propose_quantities>};

const Analysis<ScatterAnswer> kScatterAnalysis{
    .scope = Scope::pair,
    .find = [](SolvedJob& job, Progress* h) { return answer_scatter(job, h); },
    .judge = [](const SolvedJob& job, const ScatterAnswer&) { return judge(job); },
    .table = quantities_table<scatter_quantities>,
    .record = [](const SolvedJob& job,
                 const ScatterAnswer& a) { return scatter_quantities().of(scatter_view(job, a)); }};

const Analysis<LoadAnalysis> kLoadAnalysis{
    .scope = Scope::everything,
    .find = answer_load,
    .judge = [](const SolvedJob& job, const LoadAnalysis&) { return judge(job, {.load = true}); },
    .table = quantities_table<load_quantities>,
    .record = record_of<load_quantities>};

const Analysis<RatingAnswer> kRatingAnalysis{
    .scope = Scope::pair,
    .find = answer_rating,
    .judge = [](const SolvedJob& job, const RatingAnswer& a) { return judge(job, {.rating = &a}); },
    .table = quantities_table<rating_quantities>,
    .record = record_of<rating_quantities>};

}  // namespace gearwright
