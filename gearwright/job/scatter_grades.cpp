#include "gearwright/job/scatter_grades.hpp"

#include <algorithm>

#include "gearwright/base/units.hpp"
#include "gearwright/gear/gear_field.hpp"
#include "gearwright/inspection/thickness_series.hpp"
#include "gearwright/scatter/grades.hpp"

namespace gearwright {

namespace {

// The tolerances of a grade that the spec does not give individually.
class Grades {
 public:
  Grades(const SolvedJob& job, std::vector<ScatterTolerance>& all) : job_(job), all_(all) {}

  std::optional<Error> add() {
    const ScatterInput& input = job_.spec.scatter;
    for (const int which : {1, 2}) {
      const auto i = static_cast<std::size_t>(which - 1);
      const ToleranceInput& own = job_.completed.gear(which).tolerance;
      const std::optional<int> quality =
          input.quality ? std::optional((*input.quality)[i]) : own.quality;
      if (!quality) {
        if (auto error = needs_grade(which)) return error;
        continue;
      }
      if (!has_class(own.edition, *quality))
        return Error{"scatter.quality", std::to_string(*quality),
                     own.edition == FlankTolerances::iso_2013
                         ? "is not a grade of ISO 1328-1:2013; its grades are 1 to 11"
                         : "is not a grade of ISO 1328-1:1995; its grades are 0 to 12"};
      const auto flank = graded_flank(job_.pair->gear(which), own.edition, *quality);
      if (!flank)
        return Error{
            "scatter.quality", std::to_string(*quality),
            "is for involute teeth with a usable flank; give the ranges in [scatter.errors]"};
      add_flank(which, *flank);
      helix_total_ = std::max(helix_total_, flank->helix_total);
    }
    if (helix_total_ > 0.0) return add_housing();
    return std::nullopt;
  }

 private:
  // An error if a key needs a grade that is not given.
  std::optional<Error> needs_grade(int which) const {
    const ScatterGear& gear = job_.spec.scatter.gears[static_cast<std::size_t>(which - 1)];
    const char* const key = gear.pitch           ? "pitch"
                            : gear.profile_waves ? "profile_waves"
                            : gear.helix_waves   ? "helix_waves"
                                                 : nullptr;
    if (!key) return std::nullopt;
    return Error{"scatter." + gear_field(which) + "." + key, "",
                 "needs a grade, quality = 6 in [scatter] for example"};
  }

  bool given(const std::string& name) const {
    return std::any_of(all_.begin(), all_.end(),
                       [&](const ScatterTolerance& t) { return t.name == name; });
  }
  template <class Of>
  void add(const std::string& name, double unit, double half, const Of& of) {
    if (given(name)) return;
    all_.push_back({name, unit, Distribution::of({{-half / unit, half / unit}}).value(), of});
  }
  void add_error(VaryingError error, double half) {
    const ErrorEntry& e = error_entries()[static_cast<std::size_t>(error)];
    add("errors." + std::string(e.key), e.si(), half, error);
  }

  void add_flank(int which, const GradedFlank& f) {
    const ScatterGear& gear = job_.spec.scatter.gears[static_cast<std::size_t>(which - 1)];
    const std::string table = gear_field(which) + ".";
    add_error(which == 1 ? VaryingError::helix_slope1 : VaryingError::helix_slope2, f.helix_slope);
    add(table + "modifications.profile_slope_um", kMmPerUm, f.profile_slope,
        VaryingModification{which, RemovalField::Parameter::profile_slope});
    constexpr std::array<int, 2> kWaves{1, 4};
    const Distribution share = Distribution::of({{0.0, 1.0}}).value();
    all_.push_back(
        {table + "profile_waves", 1.0, share,
         VaryingWave{which, false, gear.profile_waves.value_or(kWaves), f.profile_form}});
    all_.push_back({table + "helix_waves", 1.0, share,
                    VaryingWave{which, true, gear.helix_waves.value_or(kWaves), f.helix_form}});
    all_.push_back(
        {table + "pitch", 1.0, share, VaryingPitch{which, f.total_pitch, f.single_pitch}});
  }

  std::optional<Error> add_housing() {
    const PairInput& pair = job_.completed.pair;
    std::optional<std::array<double, 2>> distance = pair.distance_deviations;
    if (!distance && pair.distance_tolerance) {
      const auto half = js_deviation(*pair.distance_tolerance, job_.pair->center_distance());
      if (!half) return half.error();
      distance = {-*half, *half};
    }
    if (job_.spec.scatter.bearings) return std::nullopt;
    const ErrorEntry& e = error_entries()[0];
    const std::string name = "errors." + std::string(e.key);
    if (distance && !given(name))
      all_.push_back(
          {name, e.si(), Distribution::of({*distance}).value(), VaryingError::center_distance});
    if (job_.pair->crossed()) return std::nullopt;
    const double face =
        std::min(job_.pair->gear(1).spec.face_width, job_.pair->gear(2).spec.face_width);
    const GradedAxes axes = graded_axes(helix_total_, face);
    add_error(VaryingError::crossing, axes.crossing);
    add_error(VaryingError::intersecting, axes.intersecting);
    return std::nullopt;
  }

  const SolvedJob& job_;
  std::vector<ScatterTolerance>& all_;
  double helix_total_ = 0.0;  // F_β of the worse gear  mm
};

}  // namespace

std::optional<Error> add_graded(const SolvedJob& job, std::vector<ScatterTolerance>& all) {
  return Grades(job, all).add();
}

}  // namespace gearwright
