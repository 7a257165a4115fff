// Computes, with vector instructions, the values that a search compares with its limits. A
// candidate is a pair of gears with given profile shifts. The values of a batch of candidates are
// stored in columns. A trial is a pair whose shifts are not yet chosen. For a trial, the filter
// (`sieve`) decides whether any shifts within given ranges can meet the limits.
//
// The formulas are written once (design/candidate_formulas.inc) and compiled for double and for
// every instruction set. At run time, the program uses the best instruction set of the processor.
// The last bits of the vector results therefore depend on the machine. If a value is within
// kSieveDoubt of a limit, or if it is printed, it is computed with the scalar formulas of the pair.
//
//   Laws  (1) the vector results agree with the scalar results to 1e-12
//         (2) the verdicts are the same on every machine
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace gearwright {

/// Number of candidates in a batch, small enough for the columns to stay in the cache.
inline constexpr std::size_t kBatch = 1024;

/// Data that all candidates of a batch share. Axes are parallel, and lengths are in normal modules.
struct CandidateConstants {
  double tan_alpha = 0.0;                                      ///< tan α_n
  std::array<double, 2> addendum{}, dedendum{}, edge_depth{};  ///< dimensions of the two racks
  std::array<double, 2> flank_depth{};  ///< depth of the straight edge, for the interference limit
  bool tight = false, shorten = false;
};

/// The input columns are z1, z2 (< 0 for an internal gear), sin β, x1 and x2. The output columns
/// are in normal modules.
struct CandidateBatch {
  enum In { z1, z2, sin_beta, x1, x2, kIn };
  enum Out {
    center_distance,
    tan_working,         ///< tan α_wt
    contact_ratio,       ///< ε_α
    contact_ratio_true,  ///< ε_α of the path clipped to the usable flanks
    sliding,             ///< greatest specific sliding |ζ|; ∞ if the path extends beyond a base
                         ///< tangent point
    tip_1,
    tip_2,  ///< s_an
    clearance_1,
    clearance_2,
    interference_1,
    interference_2,  ///< curvature radius of the flank at the point that the mating tip touches,
                     ///< minus the curvature radius ρ_F at the start of the involute; ∞ for an
                     ///< internal gear, because this limit does not apply to it
    residual,        ///< residual of inv α_wt; residual/tan² α_wt is the error of α_wt
    kOut
  };
  std::array<std::vector<double>, kIn> in;
  std::array<std::vector<double>, kOut> out;
  std::size_t size() const { return in[0].size(); }
  void resize(std::size_t n);
};

/// Evaluates the batch with vector instructions. If a tip lies inside its base circle, or if the
/// gears cannot mesh, the values are NaN.
void evaluate(const CandidateConstants& constants, CandidateBatch& batch);
void evaluate_scalar(const CandidateConstants& constants, CandidateBatch& batch);

/// If a value is nearer to its limit than this, modules, the vector result is not used.
inline constexpr double kSieveDoubt = 1e-10;
/// Verdicts of the filter for a trial. The first three verdicts name the limit that certainly
/// rejects the trial. kSievePass means that the shifts with the longest path of contact meet these
/// three limits. kSieveAsk means that the filter cannot decide. After kSievePass or kSieveAsk, the
/// s1–s2 graph of the trial decides (design/shift_graph.hpp).
inline constexpr double kSieveShiftLimits = 0.0, kSieveCenterDistance = 1.0,
                        kSieveContactRatio = 2.0, kSievePass = 3.0, kSieveAsk = 4.0;

/// The constants of the filter for one rack, helix angle and mounting.
struct SieveConstants {
  double cos_transverse = 1.0;       ///< cos α_t
  double involute_transverse = 0.0;  ///< inv α_t
  double sum_per_involute = 0.0;  ///< Σ/(R Δinv α) = cos β/tan α_n, Σ = x1 + x2, R = r_1 + r_2
  double min_path = 0.0;          ///< K, least length of the path of contact
  std::array<double, 2> addendum{};
  bool tight = false, internal = false;
  bool path = false;  ///< true if the limit of the contact ratio is evaluated; only for external
                      ///< pairs at extended centres
};

struct SieveBatch {
  enum In { r_1, x1_lo, x1_hi, r_2, x2_lo, x2_hi, a_lo, a_hi, kIn };  ///< modules
  std::array<std::vector<double>, kIn> in;
  std::vector<double> verdict;
  std::size_t size() const { return in[0].size(); }
  void resize(std::size_t n);
};

void sieve(const SieveConstants& constants, SieveBatch& batch);
void sieve_scalar(const SieveConstants& constants, SieveBatch& batch);

/// Returns the name of the instruction set in use, for example "AVX3" or "AVX2".
std::string lanes_name();
std::size_t lanes();

}  // namespace gearwright
