// The accuracy ledger compares every closed form of production with the same template in 50 digits.
//
// A row contains a quantity, the domain of the measurement, the claimed accuracy and the measured
// accuracy. Errors are usually relative. If a difference cancels (backlash near zero, curvature
// radii near a base tangent point), they are in normal modules. Teeth under load have no closed
// form; their errors are in percent of results from finite elements or finer divisions. The worst
// input of each row is kept as text. docs/accuracy.md is made from these rows:
// GW_WRITE_LEDGER=docs/accuracy.md build/release/tests/accuracy_tests
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <string>
#include <vector>

namespace gearwright::ledger {

using Exact = boost::multiprecision::cpp_bin_float_50;

struct Row {
  std::string name;
  std::string where;  ///< domain and number of inputs
  std::string unit;   ///< "relative" or "modules"
  double claimed;
  double measured = 0.0;
  std::string worst_input;

  /// Keeps the greatest error seen.
  void see(double error, const std::string& input) {
    if (!(error <= measured)) {
      measured = error;
      worst_input = input;
    }
  }
};

/// |got − exact| / |exact|; 0/0 is 0.
double relative_error(double got, const Exact& exact);
/// |got − exact| / m_n.
double error_in_modules(double got, const Exact& exact, double normal_module);

std::vector<Row> involute_rows();
std::vector<Row> gear_rows();
std::vector<Row> mesh_rows();
std::vector<Row> crossed_rows();
std::vector<Row> chord_rows();
std::vector<Row> curve_rows();
std::vector<Row> trochoid_rows();
std::vector<Row> few_teeth_rows();
std::vector<Row> pinion_envelope_rows();
std::vector<Row> contact_rows();
std::vector<Row> load_rows();

std::string markdown(const std::vector<Row>& rows);

}  // namespace gearwright::ledger
