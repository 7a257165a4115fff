// Replaces the fused multiply-adds of Eigen on 64-bit ARM by a product and a sum, so that results have
// the same bits as on x86-64. This folder precedes those of the compiler, whose header is included first.
#pragma once
#include_next <arm_neon.h>

#undef __ARM_FEATURE_FMA
#undef vfmaq_n_f64
#undef vfmaq_laneq_f64
#define vfmaq_n_f64(c, a, b) vaddq_f64(c, vmulq_n_f64(a, b))
#define vfmaq_laneq_f64(c, a, b, lane) vaddq_f64(c, vmulq_laneq_f64(a, b, lane))
