#include "apps/web/engine/load_work.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/web/engine/stopwatch.hpp"
#include "gearwright/arrange/stiffness_reasons.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/load_text.hpp"
#include "gearwright/job/value_json.hpp"
#include "gearwright/load/load_summary.hpp"

namespace gearwright::web {

namespace {

constexpr int kTableSteps = 32;       // a table takes about as long as so many positions
constexpr std::size_t kMostKept = 4;  // both gears, draft and full

// A table and what it was made of.
struct Kept {
  int which;
  std::array<std::shared_ptr<const Gear>, 2> gears;
  LoadRequest request;
  std::shared_ptr<const ToothTable> table;
};
std::vector<Kept>& kept_tables() {
  static std::vector<Kept> kAll;
  return kAll;
}

LoadPicture::Tooth& tooth_of(LoadPicture::Torque& torque, int pair, std::size_t positions,
                             std::size_t slices) {
  for (LoadPicture::Tooth& tooth : torque.teeth)
    if (tooth.pair == pair) return tooth;
  const Numbers none(positions * slices, kNaN);
  torque.teeth.push_back({pair, Numbers(positions, kNaN), none, none, none});
  return torque.teeth.back();
}

LoadPicture picture_of(const LoadedContact& found) {
  LoadPicture picture;
  // Teeth that touch at points have no slices that press.
  const int count = found.regime == LoadRegime::line ? found.slices[0].count : 0;
  const auto slices = static_cast<std::size_t>(count);
  for (int j = 0; j < count; ++j) picture.height.push_back(found.slices[0].middle(j));
  for (const LoadedTorque& t : found.torques) {
    LoadPicture::Torque& torque = picture.torques.emplace_back();
    for (std::size_t i = 0; i < t.positions.size(); ++i) {
      torque.stiffness.push_back(t.positions[i].stiffness);
      for (const LoadedPair& p : t.positions[i].pairs) {
        LoadPicture::Tooth& tooth = tooth_of(torque, p.pair, t.positions.size(), slices);
        tooth.share[i] = share_of(t.positions[i], p.pair);
        for (std::size_t j = 0; j < slices; ++j) {
          const double pressure = p.pressure[static_cast<Eigen::Index>(j)];
          if (!(p.radius[j][0] > 0.0)) continue;
          const std::size_t at = i * slices + j;
          tooth.pressure[at] = pressure;
          tooth.diameter_1[at] = 2 * p.radius[j][0];
          tooth.diameter_2[at] = 2 * p.radius[j][1];
        }
      }
    }
    std::sort(torque.teeth.begin(), torque.teeth.end(),
              [](const auto& a, const auto& b) { return a.pair < b.pair; });
  }
  return picture;
}

}  // namespace

Result<std::shared_ptr<LoadWork>> LoadWork::begin(std::shared_ptr<Session> session,
                                                  std::optional<ComplianceAccuracy> accuracy) {
  SolvedJob job = session->job();
  if (accuracy) job.spec.load.accuracy = *accuracy;
  auto task = load_task(job);
  if (!task) return task.error();
  return std::shared_ptr<LoadWork>(new LoadWork(std::move(job), std::move(task).take()));
}

std::optional<Error> LoadWork::make_table(int which) {
  const std::array<const Gear*, 2> gears{&task_.setup.gear(1), &task_.setup.gear(2)};
  auto& kept = kept_tables();
  auto& table = tables_[static_cast<std::size_t>(which - 1)];
  const auto same = std::find_if(kept.begin(), kept.end(), [&](const Kept& k) {
    return k.which == which && same_compliance({k.gears[0].get(), k.gears[1].get()}, k.request,
                                               gears, task_.request, which);
  });
  if (same != kept.end()) {
    table = same->table;
    std::rotate(kept.begin(), same, same + 1);
    return std::nullopt;
  }
  auto made = tooth_compliance(*gears[0], *gears[1], which, task_.request);
  if (!made) return made.error();
  table = *made;
  kept.insert(kept.begin(),
              {which,
               {std::make_shared<const Gear>(*gears[0]), std::make_shared<const Gear>(*gears[1])},
               task_.request,
               table});
  if (kept.size() > kMostKept) kept.pop_back();
  return std::nullopt;
}

Result<Steps> LoadWork::step(double milliseconds) {
  const Stopwatch watch;
  if (!turn_) {
    const int which = tables_[0] ? 2 : 1;
    if (auto error = make_table(which)) return *error;
    if (which == 2) {
      pair_ = task_.pair();
      auto made = pair_compliance(task_.setup.gear(1), task_.setup.gear(2), task_.request, tables_);
      if (!made) return made.error();
      compliance_ = std::move(made).take();
      perfect_ = task_.perfect_pair();
      turn_.emplace(*pair_, task_.setup.gear(1), task_.setup.gear(2), *compliance_, task_.request,
                    perfect_ ? &*perfect_ : nullptr);
    }
  } else {
    while (next_ < turn_->positions() && watch.ms() < milliseconds) {
      turn_->solve(next_, next_ + 1);
      ++next_;
    }
    if (next_ == turn_->positions() && !finished())
      if (auto error = close()) return *error;
  }
  const int tables = turn_ ? 2 : tables_[0] ? 1 : 0;
  const auto positions = static_cast<std::int64_t>(
      task_.request.rotations.empty() ? task_.request.positions : task_.request.rotations.size());
  return Steps{tables * kTableSteps + static_cast<std::int64_t>(next_), 2 * kTableSteps + positions,
               finished()};
}

std::optional<Error> LoadWork::close() {
  LoadAnalysis answer;
  answer.contact = turn_->result();
  answer.compliance = *compliance_;
  if (auto error = judge_load(task_, *answer.contact, job_.warnings)) return error;
  explain_stiffness(job_, task_, answer, job_.warnings);
  json_ = json_text(load_json(job_, answer, judge(job_, {.load = true})), 2) + "\n";
  picture_ = picture_of(*answer.contact);
  return std::nullopt;
}

}  // namespace gearwright::web
