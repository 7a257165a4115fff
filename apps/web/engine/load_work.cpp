#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/web/engine/stopwatch.hpp"
#include "apps/web/engine/work.hpp"
#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/figure/load_figures.hpp"
#include "gearwright/job/analysis.hpp"
#include "gearwright/job/result_rows.hpp"
#include "gearwright/load/load_summary.hpp"

namespace gearwright::web {

namespace {

constexpr int kTableSteps = 32;       // a table takes about as long as 32 positions
constexpr std::size_t kMostKept = 4;  // the tables of both gears, in draft and in full accuracy

// A result with its figures. The scene of the figures contains pointers into `job_`.
class LoadAnswerWork : public Work {
 public:
  LoadAnswerWork(std::shared_ptr<Session> session, SolvedJob job)
      : Work(std::move(session)), job_(std::move(job)) {}
  Json result() const override { return result_; }
  Result<Json> figures(int torque, double width) const override;
  Result<Json> rows() const override;

 protected:
  void take(const LoadAnalysis& answer, LoadScene scene);

  SolvedJob job_;
  Json result_;

 private:
  std::optional<LoadScene> scene_;
  std::vector<ValueRecord> torques_;
};

// A double-helical pair. Its halves are computed in one step.
class LoadHalvesWork : public LoadAnswerWork {
 public:
  using LoadAnswerWork::LoadAnswerWork;
  Result<Steps> step(double) override;
};

class LoadWork : public LoadAnswerWork {
 public:
  LoadWork(std::shared_ptr<Session> session, SolvedJob job, LoadTask task,
           std::shared_ptr<ToothTables> tables)
      : LoadAnswerWork(std::move(session), std::move(job)),
        task_(std::move(task)),
        kept_(std::move(tables)) {}

  Result<Steps> step(double milliseconds) override;

 private:
  std::optional<Error> make_table();
  std::optional<Error> close();

  LoadTask task_;
  std::shared_ptr<ToothTables> kept_;
  std::array<std::shared_ptr<const ToothTable>, 2> tables_;
  std::optional<ContactPair> pair_;
  std::optional<ContactPair> perfect_;
  std::optional<PairCompliance> compliance_;
  std::optional<LoadedTurn> turn_;
  std::size_t next_ = 0;
};

// Makes the table of the next gear. As soon as both tables exist, the computation of positions
// starts.
std::optional<Error> LoadWork::make_table() {
  const Gear &gear_1 = task_.setup.gear(1), &gear_2 = task_.setup.gear(2);
  const int which = tables_[0] ? 2 : 1;
  auto table = kept_->of({&gear_1, &gear_2}, which, task_.request);
  if (!table) return table.error();
  tables_[which - 1] = *table;
  if (which == 1) return std::nullopt;
  pair_ = task_.pair();
  auto made = pair_compliance(gear_1, gear_2, task_.request, tables_);
  if (!made) return made.error();
  compliance_ = std::move(made).take();
  perfect_ = task_.perfect_pair();
  turn_.emplace(*pair_, gear_1, gear_2, *compliance_, task_.request,
                perfect_ ? &*perfect_ : nullptr);
  return std::nullopt;
}

Result<Steps> LoadWork::step(double milliseconds) {
  const Stopwatch watch;
  if (!turn_) {
    if (auto error = make_table()) return *error;
  } else {
    while (next_ < turn_->positions() && watch.ms() < milliseconds) {
      turn_->solve(next_, next_ + 1);
      ++next_;
    }
    if (next_ == turn_->positions() && result_.is_null())
      if (auto error = close()) return *error;
  }
  const int tables = turn_ ? 2 : 1;
  const auto positions = static_cast<std::int64_t>(
      task_.request.rotations.empty() ? task_.request.positions : task_.request.rotations.size());
  return Steps{tables * kTableSteps + static_cast<std::int64_t>(next_), 2 * kTableSteps + positions,
               !result_.is_null()};
}

std::optional<Error> LoadWork::close() {
  LoadAnalysis answer;
  answer.contact = turn_->result();
  // The default number of slices is halved until there is a solution, as by the verb `load`.
  if (answer.contact->slices_too_fine && !job_.spec.load.slices &&
      halve_slices(task_.request.slices)) {
    turn_.reset();
    tables_ = {};
    next_ = 0;
    return std::nullopt;
  }
  answer.compliance = *compliance_;
  answer.standard = load_standard(job_, answer);
  if (auto error = judge_load(task_, *answer.contact, job_.warnings)) return error;
  explain_stiffness(job_, task_, answer, job_.warnings);
  take(answer, {{&task_.setup.gear(1), &task_.setup.gear(2)},
                nullptr,
                job_.spec.load.driver == 2,
                *answer.contact,
                {}});
  return std::nullopt;
}

Result<Steps> LoadHalvesWork::step(double) {
  if (result_.is_null()) {
    auto made = load_with_scene(job_);
    if (!made) return made.error();
    GW_EXPECTS(made->report);  // load_work() makes this work only for torques
    take(made->answer, std::move(*made->report));
  }
  return Steps{1, 1, true};
}

void LoadAnswerWork::take(const LoadAnalysis& answer, LoadScene scene) {
  scene_ = std::move(scene);
  Json json = titled_record(kLoadAnalysis, job_, answer);
  json["warnings"] = warnings_json(job_.warnings);
  json["verdict"] = verdict_json(kLoadAnalysis.judge(job_, answer));
  result_["json"] = json_text(json, 2) + "\n";
  for (const LoadTorqueView& torque : torque_views(*answer.contact, answer.standard))
    torques_.push_back(load_torque_quantities().of(torque));
}

Result<Json> LoadAnswerWork::rows() const {
  Json tables = Json::array();
  for (const ValueRecord& torque : torques_)
    tables.push_back(rows_json(session().units(), {.name = "load",
                                                   .quantities = load_torque_quantities().table(),
                                                   .records = {torque},
                                                   .range = RowRange::shown}));
  return tables;
}

Result<Json> LoadAnswerWork::figures(int torque, double width) const {
  if (!scene_) return Error{"", "", "there are no figures until the computation is finished"};
  if (torque < 0 || torque >= static_cast<int>(scene_->contact.torques.size()))
    return refused("torque", torque, "is not one of the torques of [load]");
  Json list = Json::array();
  const auto add = [&](const std::optional<Figure>& f) {
    if (f) list.push_back(session().drawn(*f, width));
  };
  LoadScene whole = *scene_;
  whole.chosen = static_cast<std::size_t>(torque);
  add(loaded_te_figure(whole));
  add(harris_figure(whole));
  const bool lines = whole.contact.regime == LoadRegime::line;
  for (LoadScene scene : whole.halves.empty() ? std::vector{whole} : whole.halves) {
    scene.chosen = whole.chosen;
    for (const auto make :
         {pair_share_figure, share_figure, stiffness_figure, root_turn_figure, root_face_figure})
      add(make(scene));
    for (const std::size_t i : {0, 1})
      add(lines ? pressure_figure(scene, i) : ellipse_figure(scene, i));
    add(lines ? pressure_along_figure(scene) : point_pressure_figure(scene));
  }
  return list;
}

}  // namespace

Result<std::shared_ptr<const ToothTable>> ToothTables::of(const std::array<const Gear*, 2>& gears,
                                                          int which, const LoadRequest& request) {
  const auto same = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) {
    return k.which == which &&
           same_compliance({k.gears[0].get(), k.gears[1].get()}, k.request, gears, request, which);
  });
  if (same != kept_.end()) {
    std::rotate(kept_.begin(), same, same + 1);
    return kept_.front().table;
  }
  auto made = tooth_compliance(*gears[0], *gears[1], which, request);
  if (!made) return made.error();
  kept_.insert(kept_.begin(),
               {which,
                {std::make_shared<const Gear>(*gears[0]), std::make_shared<const Gear>(*gears[1])},
                request,
                *made});
  if (kept_.size() > kMostKept) kept_.pop_back();
  return *made;
}

MadeWork load_work(std::shared_ptr<Session> session, std::optional<ComplianceAccuracy> accuracy,
                   std::shared_ptr<ToothTables> tables) {
  SolvedJob job = session->job();
  if (auto error = two_gears_error(job.spec)) return *error;
  if (accuracy) job.spec.load.accuracy = *accuracy;
  if (job.halves[0] && !job.spec.load.torques.empty())
    return std::shared_ptr<Work>(
        std::make_shared<LoadHalvesWork>(std::move(session), std::move(job)));
  auto task = load_task(job);
  if (!task) return task.error();
  return std::shared_ptr<Work>(std::make_shared<LoadWork>(
      std::move(session), std::move(job), std::move(task).take(), std::move(tables)));
}

}  // namespace gearwright::web
