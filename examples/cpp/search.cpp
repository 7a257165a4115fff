// A search for pairs with a ratio near 2 and a centre distance of 99 to 101 mm, the best first.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;
using namespace gearwright::literals;

int main() {
  SearchProblem problem;
  problem.ratio = {1.95, 2.05};
  problem.center_distance = {{99.0, 101.0}};
  problem.modules = {1.5, 2.0, 2.5};
  problem.pinion_teeth = {17, 40};
  problem.helix = {0_deg, 8_deg};
  problem.limits.sliding = 1.2;
  problem.limits.tip_thickness = 0.25;  // modules

  const Search search(problem);
  const auto candidates = search.space().size();
  if (!candidates) return 1;  // too many to count
  std::vector<DesignRow> rows;
  const SearchCounts counts = search.range(0, *candidates, rows);
  BestDesigns best(problem, 5);
  for (const DesignRow& row : rows) best.add(row);
  const SearchAnswer answer = std::move(best).answer(counts);

  std::printf("%lld candidates, %lld feasible\n", static_cast<long long>(counts.tested),
              static_cast<long long>(counts.feasible));
  for (const DesignRow& row : answer.designs)
    std::printf("m %.2f  %d : %d  a %.4f mm  x %.4f %.4f  contact ratio %.4f\n", row.trial.module,
                row.trial.z1, row.trial.z2, row.center_distance, row.shift[0], row.shift[1],
                row.contact_ratio);
}

/* prints
408 candidates, 34 feasible
m 2.00  34 : 67  a 101.0000 mm  x 0.0371 -0.5334  contact ratio 1.7914
m 2.00  34 : 67  a 101.0000 mm  x 0.2042 -0.2042  contact ratio 1.7164
m 2.00  33 : 67  a 100.0000 mm  x 0.2125 -0.2125  contact ratio 1.7111
m 2.00  33 : 66  a 99.0000 mm  x 0.2083 -0.2083  contact ratio 1.7110
m 2.00  33 : 67  a 100.9828 mm  x 0.2125 -0.2125  contact ratio 1.6874
*/
