// The sections of the page, each in HTML from <section> to </section>. `shapes` are the names of
// the gears' definitions (gear_shape.hpp).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/catalogue/scatter_quantities.hpp"
#include "gearwright/figure/distribution_figures.hpp"
#include "gearwright/figure/load_scene.hpp"
#include "gearwright/pair/arc_pair.hpp"
#include "gearwright/report/contact_report.hpp"
#include "gearwright/report/k_diagram.hpp"
#include "gearwright/report/report.hpp"

namespace gearwright {

/// "Lengths are in mm", as part of a sentence.
std::string_view lengths_of_report(UnitSystem units);
/// A line for the head of a report whose tables and pictures have different units; otherwise empty.
std::string hint_of_units(UnitSystem units);

/// The findings, worst first. `whole` is the subject of findings that belong to no gear.
std::string finding_list(const Verdict& verdict, std::string_view whole);

/// A pair of involute gears: pictures, quantities, interference.
std::string pair_section(const ParallelPair& pair, const std::array<std::string, 2>& shapes,
                         UnitSystem units);
std::string pair_section(const CrossedPair& pair, const std::array<std::string, 2>& shapes,
                         UnitSystem units);

/// The text `shared` about the results of both halves of a double-helical pair, and the pictures of each
/// half under its heading. If there are pictures of one half only, the sentence `alike` is added.
std::string halves_part(std::string_view shared, std::string_view alike,
                        const std::vector<std::string>& pictures);

/// The files that accompany the page. Empty if there are none.
std::string file_section(const std::vector<ReportFile>& files);

/// The inspection dimensions, with a column per gear. They contain the records of
/// catalogue/measure_quantities.hpp, both ends for gears with tolerances, and the K-diagrams of
/// flanks. Empty if there are none.
std::string measure_section(const std::vector<ValueRecord>& measures,
                            const std::vector<std::vector<ValueRecord>>& ends,
                            const std::vector<KDiagram>& diagrams, UnitSystem units);

/// A pair of circular-arc gears: its quantities, and each contact in the transverse section through
/// it.
std::string arc_pair_section(const ArcPair& pair, const std::array<std::string, 2>& shapes,
                             UnitSystem units);

/// The rotations of the gears in the section through a contact, as counter-clockwise angles of
/// their x axes, rad.
std::array<double, 2> angles_at_contact(const ArcPair& pair, const ArcPairContact& contact);

/// Tooth contact: pictures, and text for users without experience of such an analysis.
///
/// Domain    two gears with teeth; results of the same positions over one pitch, at least one of
///           which has contact; rasters of at least 2 × 2 nodes (contract)
std::string contact_section(const ContactReport& report);

/// Teeth under load, with one paragraph and its pictures for each subject.
///
/// Domain    at least one torque; positions evenly spaced over one pitch, some of which have
///           contact (contract)
std::string load_section(const LoadScene& report, const std::array<std::string, 2>& shapes,
                         UnitSystem units = UnitSystem::mm);

/// The root stress, along the drawn fillet of each gear and over the face; empty if there is none.
std::string root_stress_figures(const LoadScene& report, const std::array<std::string, 2>& shapes);

/// Corrections: the changes for a workshop, and their effect on each objective.
///
/// Domain    the pair of `before` has contact at some position (contract)
std::string compensate_section(const CompensateView& view, UnitSystem units = UnitSystem::mm);

/// Effect of tolerances on the pair: percentiles, figures of the distributions, and the share of
/// each tolerance.
///
/// Domain    a scatter with samples (contract)
std::string scatter_section(const ScatterView& view);
/// The samples of a quantity with its percentiles; none if it does not vary. `id` is that of its
/// figures.
std::optional<DistributionScene> distribution_scene(const ScatterView& view,
                                                    ScatterQuantity quantity, const char* id);
/// The figures of a scatter, for the report, the page and notebooks: distributions that vary, and
/// the density of patterns if the view has it.
std::vector<Figure> scatter_figures(const ScatterView& view);

/// Strength: inputs, factors, stresses and safeties, each with its clause in the standard.
std::string rating_section(const RatingView& view, UnitSystem units);

}  // namespace gearwright
