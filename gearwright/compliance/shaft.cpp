#include "gearwright/compliance/shaft.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

// Stiffness of a shaft section: bending stiffness E I and shear stiffness κ G A.
struct ShaftSection {
  double bending, shear;
};

double shaft_modulus_of_shear(const Shaft& s) {
  return s.youngs_modulus / (2 + 2 * s.poisson_ratio);
}

double shaft_diameter_at(const Shaft& s, double z) {
  const auto step = std::upper_bound(s.steps.begin(), s.steps.end(), z);
  return s.diameters[static_cast<std::size_t>(step - s.steps.begin())];
}

ShaftSection shaft_section_at(const Shaft& s, double z) {
  const double d = shaft_diameter_at(s, z);
  const double area = std::numbers::pi * d * d / 4;
  const double kappa = 6 * (1 + s.poisson_ratio) / (7 + 6 * s.poisson_ratio);
  return {s.youngs_modulus * area * d * d / 16, kappa * shaft_modulus_of_shear(s) * area};
}

// Transverse force Q, bending moment K = E I ψ', slope ψ and deflection w of the shaft at z.
struct ShaftState {
  double z = 0.0, Q = 0.0, K = 0.0, psi = 0.0, w = 0.0;
};

// Returns the state at z from a state at a smaller z. Section and load must be constant in between.
// The equations are  Q' = −q,  K' = −Q − m,  ψ' = K/(E I),  w' = ψ + Q/(κ G A).
ShaftState shaft_state_at(const Shaft& s, const ShaftState& from, double z, double q, double m) {
  const double t = z - from.z;
  const ShaftSection section = shaft_section_at(s, from.z + t / 2);
  const double v = from.Q + m;
  ShaftState to;
  to.z = z;
  to.Q = from.Q - q * t;
  to.K = from.K - v * t + q * t * t / 2;
  to.psi = from.psi + t * (from.K + t * (-v / 2 + t * q / 6)) / section.bending;
  to.w = from.w + from.psi * t + t * t * (from.K / 2 + t * (-v / 6 + t * q / 24)) / section.bending;
  if (s.shear) to.w += t * (from.Q - q * t / 2) / section.shear;
  return to;
}

bool shaft_list_grows(const std::vector<double>& list) {
  return std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end();
}

}  // namespace

bool Shaft::possible() const {
  const auto positive = [](double x) { return x > 0.0; };
  return bearings[0] < bearings[1] && shaft_list_grows(steps) &&
         diameters.size() == steps.size() + 1 &&
         std::all_of(diameters.begin(), diameters.end(), positive) && youngs_modulus > 0.0 &&
         poisson_ratio >= 0.0 &&
         (!bearing_stiffness ||
          std::all_of(bearing_stiffness->begin(), bearing_stiffness->end(), positive));
}

std::array<double, 2> bearing_reactions(const Shaft& shaft, const ShaftLoad& load) {
  GW_EXPECTS(shaft.possible());
  const double middle = (load.lo + load.hi) / 2;
  const double second = -(load.force * (middle - shaft.bearings[0]) + load.moment) /
                        (shaft.bearings[1] - shaft.bearings[0]);
  return {-load.force - second, second};
}

ShaftDeflection shaft_deflection(const Shaft& shaft, const ShaftLoad& load,
                                 const std::vector<double>& z) {
  GW_EXPECTS(shaft.possible() && load.lo < load.hi);
  const std::array<double, 2> R = bearing_reactions(shaft, load);
  const double b = load.hi - load.lo;

  // Between neighbouring points of this list, section and load are constant.
  std::vector<double> points(z);
  points.insert(points.end(), shaft.steps.begin(), shaft.steps.end());
  points.insert(points.end(), {shaft.bearings[0], shaft.bearings[1], load.lo, load.hi});
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());

  std::vector<ShaftState> states;
  states.reserve(points.size());
  ShaftState at;
  at.z = points.front();
  for (const double next : points) {
    const bool loaded = at.z >= load.lo && at.z < load.hi;
    at = shaft_state_at(shaft, at, next, loaded ? load.force / b : 0.0,
                        loaded ? load.moment / b : 0.0);
    states.push_back(at);
    for (std::size_t i = 0; i < 2; ++i)
      if (next == shaft.bearings[i]) at.Q -= R[i];
  }
  const auto state_at = [&](double place) -> const ShaftState& {
    return *std::lower_bound(states.begin(), states.end(), place,
                             [](const ShaftState& s, double value) { return s.z < value; });
  };

  // A rigid displacement and a rigid rotation of the shaft are added, so that the deflection of
  // the shaft at each bearing equals the deflection of this bearing.
  std::array<double, 2> off{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double place = shaft.bearing_stiffness ? -R[i] / (*shaft.bearing_stiffness)[i] : 0.0;
    off[i] = place - state_at(shaft.bearings[i]).w;
  }
  const double turn = (off[1] - off[0]) / (shaft.bearings[1] - shaft.bearings[0]);
  ShaftDeflection found;
  for (const double place : z) {
    const ShaftState& state = state_at(place);
    found.w.push_back(state.w + off[0] + turn * (place - shaft.bearings[0]));
    found.slope.push_back(state.psi + turn);
  }
  return found;
}

double shaft_twist_per_length(const Shaft& shaft, double body) {
  const double polar = std::numbers::pi * body * body * body * body / 32;
  return 1 / (shaft_modulus_of_shear(shaft) * polar);
}

std::vector<double> shaft_twist(const Shaft& shaft, double torque, double body, double lo,
                                double hi, const std::vector<double>& z) {
  GW_EXPECTS(shaft.possible() && body > 0.0 && lo < hi);
  const bool left = shaft.torque_from == ShaftSide::left;
  const double per_length = shaft_twist_per_length(shaft, body);
  std::vector<double> twist;
  twist.reserve(z.size());
  for (const double place : z) {
    GW_EXPECTS(place >= lo && place <= hi);
    // t is the distance from the end at which the torque acts. From this end, the torque
    // decreases linearly to 0 over the face width b. Its integral from 0 to t is t (1 − t/(2b))
    // times the whole torque.
    const double t = left ? place - lo : hi - place;
    twist.push_back(torque * t * (1 - t / (2 * (hi - lo))) * per_length);
  }
  return twist;
}

}  // namespace gearwright
