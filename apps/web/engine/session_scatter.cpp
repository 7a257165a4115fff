#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/web/engine/session.hpp"
#include "apps/web/engine/stopwatch.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/distribution_figures.hpp"
#include "gearwright/job/scatter_answer.hpp"
#include "gearwright/math/statistics.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/scatter/linear_family.hpp"

namespace gearwright::web {

namespace {

constexpr int kSketched = 128, kSketchedPositions = 16;  // samples and positions of the estimate
// The first complete analysis has kFirstSamples samples in each replicate. No analysis has more
// than kMostSamples samples in a replicate, or more than kMostReplicates replicates.
constexpr int kFirstSamples = 4, kMostSamples = 128, kMostReplicates = 8;
constexpr int kPatterns = 32;        // samples of the density of patterns
constexpr double kLongestMs = 1000;  // longest expected time of an analysis with twice the samples

Json figures_of(const DistributionScene& scene, double width) {
  return Json::array(
      {shape(histogram_figure(scene), width), shape(cumulative_figure(scene), width)});
}

Json point(double percent, double arcsec) { return {{"percent", percent}, {"arcsec", arcsec}}; }

}  // namespace

Result<Json> Session::scatter_sketch(double width) {
  if (auto error = two_gears_error(job_.spec)) return *error;
  SolvedJob job = job_;
  if (auto error = one_helix_error(job)) return *error;
  auto made = prepared_scatter(job);
  if (!made) return made.error();
  ScatterAnswer prepared = std::move(made).take();
  ScatterTask& task = prepared.task;
  task.member.positions = std::min(task.member.positions, kSketchedPositions);
  auto spans = linear_spans(prepared.setup, task, kSketched);
  if (!spans) return of_scatter(task, spans.error());
  std::vector<double> values = std::move(spans).take();
  for (double& v : values) v *= kArcsecPerRad;
  std::sort(values.begin(), values.end());
  const SpreadEntry& entry = scatter_entries()[0];
  DistributionScene scene{
      "scatter-te", entry.words, std::string(unit_text(entry.unit)), values, {}};
  Json percentiles = Json::array();
  for (const double percent : task.percentiles) {
    const double at = quantile(values, percent / 100.0);
    scene.percentiles.emplace_back(percent, at);
    percentiles.push_back(point(percent, at));
  }
  const bool varies = values.front() < values.back();
  return Json{{"percentiles", percentiles},
              {"figures", varies ? figures_of(scene, width) : Json::array()}};
}

// The number of samples is doubled until the next analysis is expected to take longer than
// kLongestMs. The time of a contact analysis varies. Flanks with reliefs and waves take many times
// as long as smooth flanks.
Result<Json> Session::scatter(double width) {
  if (auto error = two_gears_error(job_.spec)) return *error;
  SolvedJob job = job_;
  ScatterInput& input = job.spec.scatter;
  const int most = std::min(input.samples, kMostSamples);
  input.replicates = std::min(input.replicates, kMostReplicates);
  input.indices = input.worst_case = input.loosening = input.loaded = input.pattern = false;
  input.robust.reset();
  input.samples = std::min(kFirstSamples, most);
  Stopwatch watch;
  auto answer = answer_scatter(job);
  while (answer && input.samples < most && 2 * watch.ms() < kLongestMs) {
    input.samples *= 2;
    watch = Stopwatch();
    answer = answer_scatter(job);
  }
  if (!answer) return answer.error();
  ScatterView view = scatter_view(job, *answer);
  std::optional<PatternDensity> density;
  if (!job.halves[0]) density = density_of(job, *answer, nullptr, kPatterns);
  if (density) view.density = &*density;
  const auto& spread = view.spread[0];
  Json percentiles = Json::array();
  for (std::size_t i = 0; spread && i < spread->spread->percentiles.size(); ++i) {
    const Percentile& p = spread->spread->percentiles[i];
    percentiles.push_back(point(p.percent, p.estimate.value * kArcsecPerRad));
  }
  Json figures = Json::array();
  for (const Figure& figure : scatter_figures(view)) figures.push_back(drawn(figure, width));
  const auto share = [](const char* words, const Probability& p) {
    return Json{{"words", words}, {"count", p.count}, {"of", p.of}, {"upper", p.interval.upper}};
  };
  const Scatter& s = answer->scatter;
  return Json{{"percentiles", percentiles},
              {"figures", figures},
              {"samples", answer->scatter.samples.size()},
              {"events", Json::array({share("an edge of a tooth touches", s.edge_contact),
                                      share("the gears jam", s.jam),
                                      share("contact is lost", s.contact_lost)})}};
}

}  // namespace gearwright::web
