// A spec that was read and solved: what a page shows of it while the user moves something.
//
// Everything is computed by the rooms of the core when it is wanted; what several questions share,
// the solved pair and its contact, is kept.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "apps/web/engine/shapes.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/files.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright::web {

/// What a page wants to see of contact.
struct ContactView {
  double width = 560.0;                 ///< px, of a figure
  int positions = 64;                   ///< per pitch
  int index = 0;                        ///< of the position whose gap lies on the flanks
  std::array<FlankRaster, 2> patterns;  ///< as `pattern` made them; empty: not yet
  bool curves = true;                   ///< not the flanks alone
};

/// What a page wants to see of the gears in section.
struct MeshView {
  MeshFrame frame = MeshFrame::mesh;
  double width = 560.0, height = 420.0;  ///< px
  std::optional<Bounds> window;          ///< mm, in place of the frame's
  bool bodies = false;                   ///< the bodies alone
  std::string name = "mesh";             ///< of the shapes, unique in the page
};

/// What a page wants to see of the profile shifts.
struct ShiftView {
  double width = 560.0;          ///< px
  double aspect = 1.25;          ///< of the plot, width over height
  std::optional<Bounds> window;  ///< (x1, x2), in place of the region's
};

class Session : public std::enable_shared_from_this<Session> {
 public:
  /// Errors    as read_spec and solve
  static Result<std::shared_ptr<Session>> open(std::string text);

  const SolvedJob& job() const { return job_; }
  const SpecText& text() const { return text_; }
  int gears() const { return static_cast<int>(job_.gears.size()); }
  bool has_pair() const { return job_.pair.has_value(); }

  std::string json(std::string_view verb) const;
  Result<Json> section(int gear, double tolerance) const;
  Result<Json> mesh(int gear, double tolerance) const;
  Result<Json> lines() const;
  /// The gears in section, with all circles that the catalogue names.
  Result<Json> mesh_figure(const MeshView& view) const;
  /// Column-major, as three.js takes it.
  Result<Json> pose(int gear, double rotation1_deg, bool nominal);

  Result<ContactCurve> contact_curve(int positions);
  /// Transmission error, spectrum, and both flanks at one position; some may be missing.
  Result<Json> contact_figures(const ContactView& view);
  /// An object of contact.positions, JSON.
  Result<std::string> contact_point(double rotation1_deg);
  Result<FlankRaster> gap_map(double rotation1_deg, int k, const RasterSize& size);
  /// The pair as contact takes it; it lives as long as the session.
  Result<const ContactPair*> contact_pair();
  /// The same with two errors of other values, by their places in error_entries().
  Result<ContactPair> pair_under(const std::array<std::size_t, 2>& keys,
                                 const std::array<double, 2>& values);
  double marking() const { return job_.spec.contact.marking; }

  /// With a figure if a view is given and some shifts are left.
  Result<Json> shift_region(const std::optional<ShiftView>& view) const;
  Result<Json> file(const std::string& kind, int gear, double tolerance);

 private:
  explicit Session(SpecText text) : text_(std::move(text)) {}
  Result<ContactSetup*> setup();
  Result<ContactPoint> touch(double rotation1_deg);
  Result<const ContactResult*> found(int positions);
  Result<ToothedBody> body(int gear, bool in_place) const;
  std::vector<NamedCircle> circles(int gear) const;

  SpecText text_;
  SolvedJob job_;
  std::optional<Result<ContactSetup>> setup_;
  std::optional<ContactPair> pair_;
  std::optional<ContactResult> found_;  ///< of the number of positions that was asked last
};

}  // namespace gearwright::web
