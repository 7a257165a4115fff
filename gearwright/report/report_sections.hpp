// Writes the sections of the report, each in HTML from <section> to </section>. `shapes` are the
// names of the SVG definitions of the gears (gear_shape.hpp).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/catalogue/propose_quantities.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/catalogue/scatter_quantities.hpp"
#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/figure/distribution_figures.hpp"
#include "gearwright/figure/load_scene.hpp"
#include "gearwright/pair/arc_pair.hpp"
#include "gearwright/pair/rack_pair.hpp"
#include "gearwright/report/contact_report.hpp"
#include "gearwright/report/k_diagram.hpp"
#include "gearwright/report/page_parts.hpp"
#include "gearwright/report/report.hpp"

namespace gearwright {

/// Writes the findings, worst first. If a finding belongs to no single gear, its subject is
/// `whole`.
std::string finding_list(const Verdict& verdict, std::string_view whole);

/// Writes the section about a pair of involute gears, with pictures, quantities and interference.
/// `head` is the beginning of the section, in HTML.
std::string pair_section(const ParallelPair& pair, const std::array<std::string, 2>& shapes,
                         const FigureForm& form, std::string_view head = "<h2>Pair</h2>\n");
std::string pair_section(const CrossedPair& pair, const std::array<std::string, 2>& shapes,
                         const FigureForm& form);

/// Writes the text `shared` about both halves of a double-helical pair, followed by the pictures of
/// each half under a heading. If there are pictures of only one half, the sentence `alike` is
/// added.
std::string halves_part(std::string_view shared, std::string_view alike,
                        const std::vector<std::string>& pictures);

/// Returns the page, which contains `page` and the members of `input`: the verdict, links to the
/// files, the spec and the control that turns gears. `page.title` is used if `input` has no title.
std::string page_of(const PageInput& input, ReportPage page);

/// Writes the inspection dimensions, with a column for each gear. They consist of the records of
/// catalogue/gear_quantities.hpp, the values at both ends of the tolerances if there are any, and
/// the K-diagrams. The result is empty if there are no dimensions.
std::string measure_section(const std::vector<ValueRecord>& measures,
                            const std::vector<std::vector<ValueRecord>>& ends,
                            const std::vector<KDiagram>& diagrams, UnitSystem units);

/// Writes the section about a pair of circular-arc gears, with its quantities and a picture of each
/// contact in the transverse section through the contact point. `head` is as in pair_section().
std::string arc_pair_section(const ArcPair& pair, const std::array<std::string, 2>& shapes,
                             const FigureForm& form, std::string_view head = "<h2>Pair</h2>\n");

/// Returns the rotations of both gears in the transverse section through a contact point, as
/// counter-clockwise angles of their x axes, rad.
std::array<double, 2> angles_at_contact(const ArcPair& pair, const ArcPairContact& contact);

/// Writes the section about tooth contact, with pictures and with text for users without experience
/// of contact analysis.
///
/// Domain    two gears with teeth, or a pinion and its rack; `driving` and `other` have the same
///           positions over one pitch, and `driving` has contact at some position; rasters of at
///           least 2 × 2 nodes (contract)
std::string contact_section(const ContactReport& report, const FigureForm& form = {},
                            std::string_view title = "Tooth contact");

/// Writes the section about teeth under load. Each subject has one paragraph and its pictures.
///
/// Domain    at least one torque; positions evenly spaced over one pitch, with contact at some of
///           them (contract)
std::string load_section(const LoadScene& report, const std::array<std::string, 2>& shapes,
                         const FigureForm& form = {});

/// Draws the root stress along the fillet of each gear, over the face and during a mesh. The result
/// is empty if root stresses were not computed.
std::string root_stress_figures(const LoadScene& report, const std::array<std::string, 2>& shapes,
                                UnitSystem units);

/// Writes the section about proposed flank modifications and their effects.
///
/// Domain    at least one proposal (contract)
std::string propose_section(const ProposeView& view, UnitSystem units);

/// Writes the section about corrections, with the changes to make and their effect on each
/// objective.
///
/// Domain    `before` has contact at some position; at least one correction (contract)
std::string compensate_section(const CompensateView& view, UnitSystem units = UnitSystem::mm);

/// Writes the section about the effect of tolerances on the pair. It contains percentiles, figures
/// of the distributions, and the influence of each tolerance.
///
/// Domain    a scatter with samples (contract)
std::string scatter_section(const ScatterView& view, UnitSystem units);
/// Returns the values of a quantity in all samples, and its percentiles. Returns none if the
/// quantity is the same in all samples, or if the view has no spread of it. `id` becomes the id of
/// the figures.
std::optional<DistributionScene> distribution_scene(const ScatterView& view,
                                                    ScatterQuantity quantity, const char* id);
/// Returns the figures of a scatter for the report, the web page and notebooks. They are two
/// figures of the peak-to-peak transmission error and one of the least backlash, each only if the
/// quantity varies, and the density of contact patterns if the view contains it.
std::vector<Figure> scatter_figures(const ScatterView& view);

/// Writes the section about strength, with inputs, factors, stresses and safety factors and their
/// clauses of the standard.
std::string rating_section(const RatingAnswer& view, UnitSystem units);

/// Returns the SVG definitions to which the pictures of a page refer. They are the shape of each
/// gear and, if `rack` is not null, the shape of the rack with the name shapes[1]. The result is
/// empty if there are no shapes.
std::string shape_definitions(const std::vector<const Gear*>& gears, const RackPair* rack,
                              const std::array<std::string, 2>& shapes);

/// Writes the section about a rack and its pinion, with a picture of the mesh and the quantities of
/// both. The page must contain the definitions of both shapes. If the rack has no outline, a
/// paragraph with the reason replaces the picture. `head` is as in pair_section().
std::string rack_section(const RackPair& pair, const std::array<std::string, 2>& shapes,
                         const FigureForm& form,
                         std::string_view head = "<h2>Rack and pinion</h2>\n");

}  // namespace gearwright
