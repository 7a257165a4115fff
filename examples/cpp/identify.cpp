// Identification: the standard gears that fit the measurements of a broken gear.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  IdentifyProblem broken;
  broken.teeth = 23;
  broken.spans = {{.teeth = 3, .value = 19.751}, {.teeth = 4, .value = 27.131}};
  broken.balls = {{.tool = 5, .value = 69.426}};
  broken.tip.value = 66.71;  // worn
  broken.lead.value = 585;   // rolled over paper
  const Result<Identification> found = identify(broken);
  if (!found) return fail(found.error());
  for (const IdentifiedGear& gear : found->candidates)
    std::printf("%5.1f %%  m_n %.4f mm, alpha_n %.1f deg, beta %.3f deg, x_E %.4f\n",
                100 * gear.likelihood, gear.normal_module, gear.normal_pressure_angle.deg(),
                gear.helix_angle.deg(), gear.generating_shift);
}

/* prints
 95.8 %  m_n 2.5000 mm, alpha_n 20.0 deg, beta 18.000 deg, x_E 0.2170
  4.2 %  m_n 2.5000 mm, alpha_n 20.0 deg, beta 18.001 deg, x_E 0.2169
  0.0 %  m_n 2.5400 mm, alpha_n 22.5 deg, beta 18.329 deg, x_E -0.0100
*/
