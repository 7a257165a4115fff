#include "gearwright/catalogue/contact_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

constexpr const char* kContact = "Tooth contact";

bool touches(const ContactPoint& p) { return p.kind != TouchKind::none; }

// Returns a getter for a quantity of a single contact point. The quantity has no value if no teeth
// touch. It also has no value for a whole double-helical pair, because each half has its own point.
template <class F>
auto at_place(F get) {
  return [get](const ContactPoint& p) {
    return touches(p) && !std::isnan(p.diameter[0]) ? std::optional(std::invoke(get, p))
                                                    : std::nullopt;
  };
}

template <class F>
auto touching(F get) {
  return [get](const ContactPoint& p) {
    return touches(p) ? std::optional(std::invoke(get, p)) : std::nullopt;
  };
}

// The results of a rack are travels, and the results of a gear are angles.
const auto is_rack = [](const auto& x) { return static_cast<bool>(x.rack); };
const auto is_gear = [](const auto& x) { return !x.rack; };
bool of_rack(const ContactView& v) { return is_rack(v.driving); }
bool of_gear(const ContactView& v) { return !of_rack(v); }

double travel_um(const RackTravel& rack, Angle angle) { return kUmPerMm * rack.of(angle); }

const Quantities<ContactEllipse>& ellipse_quantities() {
  using E = ContactEllipse;
  return define("contact.positions ellipse", [](Quantities<E>& q) {
    q.number("semi_major_mm", "semi-major axis", "", "null for line contact", &E::semi_major);
    q.number("semi_minor_mm", "semi-minor axis", "", "√(2δ/k2)", &E::semi_minor);
    q.number("angle_deg", "direction of the major axis", "",
             "angle about the flank normal; 0 along the projection of axis 1 onto the tangent "
             "plane",
             &E::angle);
  });
}

const Quantities<ContactRidge>& ridge_quantities() {
  using R = ContactRidge;
  return define("contact.positions ridge", [](Quantities<R>& q) {
    q.term("gear", "gear whose flank has the ridge", &R::gear);
    q.number("along_per_mm", "curvature of the gap along the ridge", "",
             "the curvature is the same on both sides", &R::along);
    q.number("slope", "slopes of the gap", "",
             "slopes away from the ridge, first towards the smaller diameter (for an end relief, "
             "towards the smaller height), then in the other direction",
             [](const R& r) {
               return ValueList{r.side[0].slope, r.side[1].slope};
             })
        .list({2});
    q.term("gap_curvature_per_mm",
           "curvatures of the gap on both sides of the ridge, in the order of `slope`",
           [](const R& r) {
             return ValueList{Value(r.side[0].curvature), Value(r.side[1].curvature)};
           })
        .list({2, 2});
  });
}

void add_position(Quantities<ContactPoint>& q) {
  q.term("rotation1_deg", "clockwise seen from +z", &ContactPoint::rotation1);
  q.number("rotation2_deg", "rotation of gear 2", "φ_2", "position of gear 2 when gear 1 drives it",
           touching([](const ContactPoint& p) { return p.rotation2.deg(); }))
      .when(is_gear);
  q.number("travel_mm", "travel of the rack", "",
           "position of the rack when gear 1 drives it, > 0 along −y",
           touching([](const ContactPoint& p) { return p.rack.of(p.rotation2); }))
      .when(is_rack);
  q.term("transmission_error_arcsec",
         "rotation of gear 2 minus |z1/z2| times the rotation of gear 1; the mean is not removed; "
         "> 0 if gear 2 is ahead [T8.2]",
         touching([](const ContactPoint& p) { return p.te.arcsec(); }))
      .when(is_gear);
  q.term("transmission_error_um",
         "travel of the rack minus r times the rotation of gear 1; the mean is not removed; > 0 if "
         "the rack is ahead [T8.29]",
         touching([](const ContactPoint& p) { return travel_um(p.rack, p.te); }))
      .when(is_rack);
  q.whole("tooth", "tooth pair", "k",
          "number of the tooth pair in contact; tooth pair k reaches the centre line k pitches "
          "after tooth pair 0",
          touching(&ContactPoint::pair));
  q.term("kind",
         "whether the contact is inside the flanks, along a line or at an edge; `form1` and "
         "`form2` are the ends of the usable flanks at the roots, and `ridge` is the start of a "
         "linear relief",
         touching([](const ContactPoint& p) { return to_string(p.kind); }))
      .one_of({"interior", "line", "tip1", "tip2", "face1", "face2", "form1", "form2", "ridge",
               "corner"});
  q.term("point_mm", "in the housing frame", at_place(&ContactPoint::point))
      .words("point of contact");
  q.term("normal", "unit vector in the housing frame that points out of gear 1",
         at_place(&ContactPoint::normal));
  q.number("diameter_mm", "diameter of contact", "", "per gear; null for a rack",
           at_place([](const ContactPoint& p) {
             return ValueList{Value(p.diameter[0]), p.rack ? Value() : Value(p.diameter[1])};
           }))
      .per_gear();
  q.number("rack_height_mm", "height of contact on the rack", "", "above the datum line",
           at_place([](const ContactPoint& p) { return p.diameter[1]; }))
      .when(is_rack);
  q.number("height_mm", "height of contact", "z",
           "per gear, from the middle of its face; for double-helical gears, from the middle of "
           "the face of the half",
           at_place(&ContactPoint::height))
      .per_gear();
  q.number(
      "rack_angle_deg", "normal angle of the rack", "θ",
      "angle of the rack that cut gear 1, at the point of contact; equal to α_n on an involute",
      &ContactPoint::rack_angle);
  q.term("gap_curvature_per_mm", "k1 ≤ k2 [T8.15]; k1 = 0 for a line; null at an edge or a ridge",
         &ContactPoint::gap_curvature)
      .list({2});
  q.record<ellipse_quantities>("ellipse",
                               "contour on which the gap equals the thickness of the marking "
                               "compound [T8.16]; null at an edge or a ridge",
                               &ContactPoint::ellipse);
  q.record<ridge_quantities>("ridge",
                             "growth of the gap on both sides of a ridge; absent without a ridge",
                             &ContactPoint::ridge)
      .when([](const ContactPoint& p) { return p.ridge.has_value(); });
  q.number("line_mm", "contact line", "", "both ends of the line; null for other kinds",
           [](const ContactPoint& p) {
             return p.line ? Value(ValueList{(*p.line)[0], (*p.line)[1]}) : Value();
           })
      .list({2, 3});
}

const Quantities<ContactResult>& non_working_quantities() {
  using R = ContactResult;
  return define("contact.non_working_flank", [](Quantities<R>& q) {
    const auto each = [](auto get) {
      return [get](const R& r) {
        ValueList list;
        for (const ContactPoint& p : r.positions)
          list.push_back(touches(p) ? Value(std::invoke(get, p)) : Value());
        return list;
      };
    };
    q.term("transmission_error_arcsec", "at each position",
           each([](const ContactPoint& p) { return p.te.arcsec(); }))
        .when(is_gear)
        .doors(kJson);
    q.term("transmission_error_um", "at each position",
           each([](const ContactPoint& p) { return travel_um(p.rack, p.te); }))
        .when(is_rack)
        .doors(kJson);
    q.term("kind", "at each position",
           each([](const ContactPoint& p) { return to_string(p.kind); }))
        .doors(kJson);
    q.term("peak_to_peak_arcsec", "over the positions with contact", &R::peak_to_peak)
        .words("transmission error of the non-working flanks, peak to peak")
        .when(is_gear);
    q.term("peak_to_peak_um", "over the positions with contact",
           [](const R& r) { return travel_um(r.rack, r.peak_to_peak); })
        .words("transmission error of the non-working flanks, peak to peak")
        .when(is_rack);
    q.flag("contact_lost", "contact of the non-working flanks is lost",
           "true if there is a position at which no tooth pair touches", &R::contact_lost)
        .doors(kJson);
  });
}

// Returns the derivatives of the transmission error and of the contact point at every position, in
// the units of the keys.
Value sensitivities(const ContactView& v) {
  ValueMap all;
  const RackTravel rack = v.driving.rack;
  const double unit = rack ? kUmPerMm * rack.radius : kArcsecPerRad;
  for (std::size_t i = 0; i < v.slopes.size(); ++i) {
    ValueList te, points;
    for (std::size_t k = 0; k < v.driving.positions.size(); ++k) {
      const Sensitivity& s = v.driving.sensitivities[i][k];
      const TouchKind kind = v.driving.positions[k].kind;
      te.push_back(kind == TouchKind::none ? Value() : Value(s.te * v.slopes[i].unit * unit));
      // A contact line has no single contact point.
      const bool point = kind != TouchKind::none && kind != TouchKind::line;
      points.push_back(point ? Value(Vec3(s.point * v.slopes[i].unit)) : Value());
    }
    all.emplace_back(
        v.slopes[i].name,
        ValueMap{{rack ? "transmission_error_um" : "transmission_error_arcsec", std::move(te)},
                 {"point_mm", std::move(points)}});
  }
  return all;
}

struct RasterView {
  const FlankRaster* raster;
  double marking;
};

const Quantities<RasterView>& raster_quantities() {
  using R = RasterView;
  return define("contact.pattern gear", [](Quantities<R>& q) {
    q.term("diameter_mm", "diameters of the rows", [](const R& r) { return r.raster->diameter; });
    q.term("height_mm", "heights of the columns", [](const R& r) { return r.raster->height; });
    q.number("gap_mm", "gap", "",
             "least normal gap during the mesh at each point; null at points that the mating gear "
             "never reaches",
             [](const R& r) {
               ValueList rows;
               for (std::size_t i = 0; i < r.raster->diameter.size(); ++i) {
                 ValueList row;
                 for (std::size_t k = 0; k < r.raster->height.size(); ++k) {
                   const double gap = r.raster->at(i, k);
                   row.push_back(std::isfinite(gap) ? Value(gap) : Value());
                 }
                 rows.push_back(std::move(row));
               }
               return rows;
             })
        .list({0, 0});
    q.number("marked", "marked share of the flank", "",
             "share of the flank on which the marking compound would show contact, 0 to 1",
             [](const R& r) {
               const auto& gap = r.raster->gap;
               const auto n =
                   std::count_if(gap.begin(), gap.end(), [&](double g) { return g <= r.marking; });
               return Value(static_cast<double>(n) / static_cast<double>(gap.size()));
             });
  });
}

const Quantities<ContactView>& pattern_quantities() {
  return define("contact.pattern", [](Quantities<ContactView>& q) {
    const auto gear = [](std::size_t i) {
      return [i](const ContactView& v) {
        return raster_quantities().of({&(*v.pattern)[i], v.marking});
      };
    };
    q.record<raster_quantities>("gear1", "the flank of gear 1", gear(0));
    q.record<raster_quantities>("gear2", "the flank of gear 2; absent for a rack", gear(1))
        .when(of_gear);
  });
}

const Quantities<ContactView>& map_quantities() {
  return define("contact.map", [](Quantities<ContactView>& q) {
    q.word("x", "error of x", "key of [errors]",
           [](const ContactView& v) { return v.map_axes[0]; });
    q.number("x_values", "values of x", "", "in the unit of the key",
             [](const ContactView& v) { return v.map->x; });
    q.word("y", "error of y", "key of [errors]",
           [](const ContactView& v) { return v.map_axes[1]; });
    q.number("y_values", "values of y", "", "in the unit of the key",
             [](const ContactView& v) { return v.map->y; });
    q.term("peak_to_peak_arcsec", "one row for each y; null if no teeth touch",
           [](const ContactView& v) {
             ValueList rows;
             for (const auto& row : v.map->value) {
               ValueList line;
               for (const double te : row)
                 line.push_back(std::isnan(te) ? Value() : Value(te * kArcsecPerRad));
               rows.push_back(std::move(line));
             }
             return rows;
           })
        .words("peak to peak")
        .list({0, 0});
  });
}

void add_contact_results(Quantities<ContactView>& q) {
  q.record<position_quantities>(
       "positions", "one entry for each rotation, in the given order",
       [](const ContactView& v) -> const auto& { return v.driving.positions; })
      .doors(kJson);
  q.under(kContact);
  q.term("peak_to_peak_arcsec", "over the positions with contact",
         [](const ContactView& v) { return v.driving.peak_to_peak; })
      .when(of_gear)
      .doors(kJson);
  q.term("peak_to_peak_um", "over the positions with contact, along the rack",
         [](const ContactView& v) { return travel_um(v.driving.rack, v.driving.peak_to_peak); })
      .when(of_rack)
      .doors(kJson);
  q.term("continuous_peak_to_peak_arcsec",
         "difference between the extremes of the curve [T14.11]; the difference does not depend on "
         "the computed positions; null if contact is lost at some rotation",
         &ContactView::continuous_span)
      .otherwise("contact is lost")
      .when(of_gear);
  q.term("continuous_peak_to_peak_um",
         "as `continuous_peak_to_peak_arcsec`, but for the travel of a rack",
         [](const ContactView& v) {
           return v.continuous_span ? Value(travel_um(v.driving.rack, *v.continuous_span))
                                    : Value();
         })
      .otherwise("contact is lost")
      .when(of_rack);
  q.number("mean_slope", "mean slope of the transmission error", "",
           "least-squares slope over the rotation of gear 1, in rad per rad",
           [](const ContactView& v) { return v.driving.mean_slope; })
      .or_null()
      .when(of_gear)
      .doors(kJson);
  q.term("harmonics_arcsec",
         "amplitudes at orders 1, 2, … of the mesh frequency, at most 20 and at most as many as "
         "`positions` can resolve [T8.18]; empty if `rotation1_deg` is given or contact is lost",
         [](const ContactView& v) { return v.driving.harmonics; })
      .when(of_gear)
      .doors(kJson);
  q.term("harmonics_um", "as `harmonics_arcsec`, but for the travel of a rack",
         [](const ContactView& v) {
           ValueList list;
           for (const Angle h : v.driving.harmonics) list.push_back(travel_um(v.driving.rack, h));
           return list;
         })
      .when(of_rack)
      .doors(kJson);
  q.term("contact_lost", "true if there is a position at which no tooth pair touches",
         [](const ContactView& v) { return v.driving.contact_lost; });
  q.record<non_working_quantities>("non_working_flank",
                                   "transmission error of the non-working flanks, at the same "
                                   "positions as for the working flanks",
                                   &ContactView::other)
      .always();
  q.number("least_play_deg", "minimum angular backlash of gear 2", "",
           "least play over all positions, measured from contact of the working flanks to contact "
           "of the non-working flanks; negative if the gears jam; null if the working or the "
           "non-working flanks never touch",
           &ContactView::min_play)
      .when(of_gear)
      .digits(6);
  q.number("least_play_mm", "minimum backlash along the rack", "",
           "least play over all positions, measured from contact of the working flanks to contact "
           "of the non-working flanks; negative if pinion and rack jam; null if the working or the "
           "non-working flanks never touch",
           [](const ContactView& v) {
             return v.min_play ? Value(v.driving.rack.of(*v.min_play)) : Value();
           })
      .when(of_rack);
  q.add(Type::map, "sensitivity", "sensitivities", "",
        "exact derivatives [T8.10] with respect to each error and each modification of the spec, "
        "under names such as `center_distance_per_mm`. Each derivative has two lists over the "
        "positions, `transmission_error_arcsec` and `point_mm`. Their values are null where no "
        "teeth touch, and `point_mm` is also null for line contact",
        sensitivities)
      .when([](const ContactView& v) { return v.halves.empty(); })
      .doors(kJson);
  q.number("axial_float_um", "axial movement of the floating gear", "Δz",
           "axial movement of gear 1 relative to gear 2 at each position; this movement makes both "
           "halves of a double-helical pair share the load; null without contact [T8.27]",
           [](const ContactView& v) {
             ValueList list;
             for (const double mm : v.float_axial)
               list.push_back(std::isnan(mm) ? Value() : Value(mm * kUmPerMm));
             return list;
           })
      .when([](const ContactView& v) { return !v.float_axial.empty(); })
      .doors(kJson);
  q.number("axial_float_peak_to_peak_um", "axial movement of the floating gear, peak to peak", "",
           "over the positions with contact",
           [](const ContactView& v) { return kUmPerMm * peak_to_peak(v.float_axial); })
      .or_null()
      .when([](const ContactView& v) { return !v.float_axial.empty(); });
  q.record<contact_quantities>("halves",
                               "contact of the two halves of a double-helical pair, in the order z "
                               "> 0, z < 0. All other numbers describe the whole gears; the "
                               "`positions` of the whole gears contain no point of contact",
                               &ContactView::halves)
      .list({2})
      .when([](const ContactView& v) { return !v.halves.empty(); })
      .doors(kJson);
  q.record<pattern_quantities>("pattern",
                               "pattern of both flanks; only with `pattern = true`; the pattern of "
                               "a double-helical pair is in `halves`")
      .when([](const ContactView& v) { return v.pattern.has_value(); })
      .doors(kJson);
  q.record<map_quantities>("map",
                           "peak-to-peak transmission error for each combination of values of the "
                           "two errors of [contact.map]")
      .when([](const ContactView& v) { return v.map.has_value(); })
      .doors(kJson);
}

}  // namespace

const Quantities<ContactPoint>& position_quantities() {
  return define<add_position>("contact.positions");
}

const Quantities<ContactView>& contact_quantities() {
  return define<add_contact_results>("contact");
}

}  // namespace gearwright
