// A session contains a spec that has been read and solved, and the results that a page shows while
// the user changes the spec.
//
// Results are computed when they are requested. The solved pair and its contact are stored, because
// several requests need them.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "apps/web/engine/answering.hpp"
#include "apps/web/engine/shapes.hpp"
#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/job/contact_report.hpp"
#include "gearwright/job/files.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright::web {

/// Options of the figures of the contact.
struct ContactFigureView {
  double width = 560.0;               ///< px, width of a figure
  int positions = 64;                 ///< number of positions per pitch
  int index = 0;                      ///< index of the position whose gap is shown on the flanks
  std::vector<FlankRaster> patterns;  ///< result of `pattern`; empty if not yet computed
  bool curves = true;                 ///< if false, only the flanks are drawn
};

/// Options of the figure of the gears in section.
struct MeshView {
  MeshFrame frame = MeshFrame::mesh;
  double width = 560.0, height = 420.0;  ///< px, size of the figure
  std::optional<Bounds> window;          ///< mm; by default the window of the frame
  bool bodies = false;                   ///< if true, circles and lines are omitted
  std::string name = "mesh";             ///< name of the shapes, unique in the page
};

/// Options of the figure of the profile shifts.
struct ShiftView {
  double width = 560.0;          ///< px, width of the figure
  double aspect = 1.25;          ///< width of the plot divided by its height
  std::optional<Bounds> window;  ///< range of (x1, x2); by default around the region
};

class Session : public std::enable_shared_from_this<Session> {
 public:
  /// Errors    the errors of read_spec and solve; a spec in inch
  static Result<std::shared_ptr<Session>> open(std::string text);

  const SolvedJob& job() const { return job_; }
  const SpecText& text() const { return text_; }
  /// Returns the number of gears, including a rack.
  int gears() const { return job_.parts(); }
  bool has_pair() const { return job_.mounted(); }
  /// Returns one pitch of gear 1 in degrees; 0 for a drive.
  double pitch_deg() const {
    return job_.gears.empty() ? 0.0 : 360.0 / std::abs(job_.gears.front().spec.teeth);
  }

  /// Sets the system of units of figures, rows, report and drawings. All other results are in mm.
  void show_in(UnitSystem units) { units_ = units; }
  UnitSystem units() const { return units_; }
  /// Returns a figure in the system of units that show_in() has set.
  Json drawn(Figure figure, double width) const;

  // engine.d.ts describes these functions. A text is JSON.
  std::string json(const std::string& verb);
  Result<std::string> rows(const std::string& verb);
  Result<Json> mesh(int gear, double tolerance) const;
  Result<Json> drive_solids() const;
  Result<Json> drive_figures(double width) const;
  Result<Json> drive_load_figures(double width) const;
  Result<Json> lines() const;
  Result<Json> mesh_figure(const MeshView& view) const;
  Result<Json> pose(int gear, double rotation1_deg, bool nominal);

  Result<Json> contact_curve(int positions);
  Result<Json> contact_figures(const ContactFigureView& view);
  Result<std::string> contact_point(double rotation1_deg);
  Result<FlankRaster> gap_map(double rotation1_deg, int k, const RasterSize& size);
  Result<std::vector<FlankRaster>> pattern(int positions, const RasterSize& size);
  Result<Json> scatter_sketch(double width);
  Result<Json> scatter(double width);
  Result<Json> shift_region(const std::optional<ShiftView>& view) const;
  Result<Json> file(const std::string& kind, int gear, double tolerance);

  /// Returns the transmission error over a pitch, rad, with two of the errors replaced by `values`.
  /// `keys` are the indices of these two errors in error_entries().
  Result<std::vector<double>> te_under(const std::array<std::size_t, 2>& keys,
                                       const std::array<double, 2>& values, int positions);
  double marking() const { return job_.spec.contact.marking; }

 private:
  // The flanks that touch, mounted with the errors of the spec. For a double-helical pair, `pair`
  // is the half at z > 0.
  struct Touching {
    std::optional<ContactSetup> setup;  // none for a rack
    std::optional<HalvesSetup> halves;
    std::optional<HalvesPair> both;
    std::shared_ptr<const ContactPair> pair;
  };
  // The contact of the gears, and of each pair of their flanks.
  struct Found {
    ContactResult whole;
    std::vector<FlankContact> flanks;
  };
  explicit Session(SpecText text) : text_(std::move(text)) {}
  static Result<std::shared_ptr<Session>> opened(SpecText text);
  const Answered& answered(const std::string& verb);
  Result<Touching> make_touching() const;
  Result<const Touching*> touching();
  Result<Found> analyse(const ContactRequest& request);
  Result<ContactPoint> touch(double rotation1_deg);
  Result<const Found*> found(int positions);
  Result<ToothedBody> body(int gear) const;
  Result<Json> rack_figure(const MeshView& view) const;
  std::optional<Error> no_gear_2() const;  // the error of a result that needs two gears, if there
                                           // is no second gear or if gear 2 is a rack
  std::vector<NamedCircle> circles(int gear) const;

  SpecText text_;
  SolvedJob job_;
  UnitSystem units_ = UnitSystem::mm;
  std::optional<Result<Touching>> touching_;
  std::optional<Found> found_;  ///< for the last requested number of positions
  std::optional<Answered> answered_;
  std::string answered_verb_;  ///< the verb of `answered_`
};

}  // namespace gearwright::web
