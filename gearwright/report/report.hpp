// Writes one self-contained HTML page about the gears and their pair, with words, tables and
// pictures for users.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/catalogue/drawing_keys.hpp"
#include "gearwright/catalogue/propose_quantities.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/catalogue/scatter_quantities.hpp"
#include "gearwright/figure/load_scene.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/pair/rack_pair.hpp"
#include "gearwright/report/contact_report.hpp"
#include "gearwright/report/k_diagram.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// A file that was written together with the report.
struct ReportFile {
  std::string name;  ///< relative to the report, "gear1.step"
  std::string what;  ///< "STEP AP242 solid of gear 1"
  std::string note;  ///< numbers about the file, such as "within 0.9 µm"; may be empty
};

/// The content of the page of any subject, a pair or a drive.
struct PageInput {
  std::string title;  ///< if empty, a title is made from the tooth numbers
  Verdict verdict;    ///< on the gears, the pair and the contact, or on the drive
  std::vector<ReportFile> files;
  std::string spec_text;              ///< the spec, verbatim; omitted if empty
  UnitSystem units = UnitSystem::mm;  ///< units of tables and sentences
};

struct ReportInput : PageInput {
  DrawingInput drawing;            ///< the title block; may be empty
  std::vector<const Gear*> gears;  ///< one or two; if there is a pair, its gears
  /// The halves of each double-helical gear. If there are any, `gears` contains one half of each of
  /// these gears.
  std::array<std::optional<Halves>, 2> halves{};
  std::optional<Pair> pair;        ///< none if the gears are not mounted
  const RackPair* rack = nullptr;  ///< null without a rack; with a rack, its pinion is the only
                                   ///< gear in `gears`
  /// Quantities of the pair at both ends of the tolerances, least backlash first; may be empty.
  std::vector<ValueRecord> pair_ends;
  std::vector<double> masses;         ///< kg, of the gears whose mass is known
  std::vector<ValueRecord> measures;  ///< inspection dimensions of each gear; may be empty
  /// For each gear, the values of `measures` that differ between the ends of the tolerances; may be
  /// empty.
  std::vector<std::vector<ValueRecord>> measure_ends;
  std::vector<KDiagram> k_diagrams;  ///< of flanks with modifications or a grade; may be empty
  const ContactReport* contact = nullptr;      ///< null if the spec requests no contact
  const LoadScene* load = nullptr;             ///< null if the spec requests no load
  const ProposeView* propose = nullptr;        ///< null if there are no proposals for the flanks
  const CompensateView* compensate = nullptr;  ///< null if the spec requests no corrections
  const ScatterView* scatter = nullptr;        ///< null if the spec has no [scatter]
  const RatingAnswer* rating = nullptr;        ///< null if the spec requests no rating
};

/// Returns the page in UTF-8.
///
///   Laws      (1) the same input gives the same bytes
///             (2) the page loads nothing; style, script and pictures are in it
///             (3) title, spec, findings and file names may contain any text
/// Units     lengths in `units`, to 0.1 µm if in mm, angles in degrees to 0.00001°; missing values
///           are “–”
/// Accuracy  outlines within 1e-4 normal modules (kOutlineTolerance in figure/gear_shape.hpp)
/// Domain    one or two gears, none null; two if there is a pair, one if there is a rack (contract)
std::string report_html(const ReportInput& input);

}  // namespace gearwright
