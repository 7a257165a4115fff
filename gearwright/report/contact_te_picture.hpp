// Transmission error over the rotation of gear 1, with the tooth pairs and kinds of contact that
// make it, and its spectrum.
#pragma once

#include <string>
#include <vector>

#include "gearwright/report/contact_report.hpp"

namespace gearwright {

/// A run of positions of one tooth pair, of edges or of flanks alone.
struct TeRun {
  int pair = 0;  ///< k
  bool edge = false;
  std::vector<double> rotation, te;  ///< rad; ends are shared with the neighbouring runs
};

/// The curve in runs, over one pitch as it is; positions without contact end a run. Where a tooth
/// pair hands over to the next, both curves are prolonged to where they cross, but not beyond the
/// greatest and the least value computed.
std::vector<TeRun> te_runs(const std::vector<ContactPoint>& positions);

/// Arc seconds with the digits that a reader can use.
std::string shown_arcsec(double arcsec);

/// One figure each; of the non-working flanks a shorter caption.
std::string te_figure(const ContactReport& report, bool other_flanks);
/// Whether nothing but rounding is left of the waves.
bool waves_are_rounding(const std::vector<Angle>& waves);
/// Empty when contact is lost, for what does not repeat has no spectrum, and when there is no wave.
std::string te_spectrum_figure(const ContactReport& report);

}  // namespace gearwright
