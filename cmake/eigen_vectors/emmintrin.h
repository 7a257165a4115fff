// Vectors of two doubles for WebAssembly, computed with scalar instructions.
//
// Eigen adds the terms of a sum in an order that depends on its vectors. With the functions of SSE2 below, it has the same
// order in WebAssembly as on x86-64, so the results have the same bits. The vectors of WebAssembly itself are not used,
// because clang 14 compiles them wrongly (cmake/gw_wasm.cmake). This folder precedes those of the compiler.
//
// The functions for doubles, and those for integers that Eigen uses for indices and for masks of doubles, compute here.
// All other functions that Eigen names are only declared, because no room uses vectors of float or bool. If a source does,
// the linker reports the missing function.
#pragma once

// For an old compiler, Eigen writes the smaller of two numbers as an instruction of x86-64. clang claims to be g++ 4.2.
#undef EIGEN_COMP_GNUC
#define EIGEN_COMP_GNUC 63

extern "C++" {

struct alignas(16) __m128 {
  float x[4];
};
struct alignas(16) __m128d {
  double x[2];
};
struct alignas(16) __m128i {
  int x[4];
};
struct __m64;

#define GW_VECTOR static inline __attribute__((always_inline))

// ---- doubles ----
GW_VECTOR __m128d _mm_set_pd(double high, double low) { return {{low, high}}; }
GW_VECTOR __m128d _mm_set1_pd(double a) { return {{a, a}}; }
GW_VECTOR __m128d _mm_set_sd(double a) { return {{a, 0.0}}; }
GW_VECTOR __m128d _mm_setzero_pd() { return {{0.0, 0.0}}; }
GW_VECTOR double _mm_cvtsd_f64(__m128d a) { return a.x[0]; }
GW_VECTOR __m128d _mm_loadu_pd(const double* from) { return {{from[0], from[1]}}; }
GW_VECTOR __m128d _mm_load_pd(const double* from) { return _mm_loadu_pd(from); }
GW_VECTOR __m128d _mm_load_sd(const double* from) { return {{*from, 0.0}}; }
GW_VECTOR void _mm_storeu_pd(double* to, __m128d a) {
  to[0] = a.x[0];
  to[1] = a.x[1];
}
GW_VECTOR void _mm_store_pd(double* to, __m128d a) { _mm_storeu_pd(to, a); }
GW_VECTOR __m128d _mm_add_pd(__m128d a, __m128d b) { return {{a.x[0] + b.x[0], a.x[1] + b.x[1]}}; }
GW_VECTOR __m128d _mm_sub_pd(__m128d a, __m128d b) { return {{a.x[0] - b.x[0], a.x[1] - b.x[1]}}; }
GW_VECTOR __m128d _mm_mul_pd(__m128d a, __m128d b) { return {{a.x[0] * b.x[0], a.x[1] * b.x[1]}}; }
GW_VECTOR __m128d _mm_div_pd(__m128d a, __m128d b) { return {{a.x[0] / b.x[0], a.x[1] / b.x[1]}}; }
GW_VECTOR __m128d _mm_sqrt_pd(__m128d a) {
  return {{__builtin_sqrt(a.x[0]), __builtin_sqrt(a.x[1])}};
}
// If a number is NaN or both are zero, the result is b, as on x86-64.
GW_VECTOR double gw_min(double a, double b) { return a < b ? a : b; }
GW_VECTOR double gw_max(double a, double b) { return a > b ? a : b; }
GW_VECTOR __m128d _mm_min_pd(__m128d a, __m128d b) {
  return {{gw_min(a.x[0], b.x[0]), gw_min(a.x[1], b.x[1])}};
}
GW_VECTOR __m128d _mm_max_pd(__m128d a, __m128d b) {
  return {{gw_max(a.x[0], b.x[0]), gw_max(a.x[1], b.x[1])}};
}
GW_VECTOR __m128d _mm_add_sd(__m128d a, __m128d b) { return {{a.x[0] + b.x[0], a.x[1]}}; }
GW_VECTOR __m128d _mm_mul_sd(__m128d a, __m128d b) { return {{a.x[0] * b.x[0], a.x[1]}}; }
GW_VECTOR __m128d _mm_min_sd(__m128d a, __m128d b) { return {{gw_min(a.x[0], b.x[0]), a.x[1]}}; }
GW_VECTOR __m128d _mm_max_sd(__m128d a, __m128d b) { return {{gw_max(a.x[0], b.x[0]), a.x[1]}}; }
GW_VECTOR __m128d _mm_unpacklo_pd(__m128d a, __m128d b) { return {{a.x[0], b.x[0]}}; }
GW_VECTOR __m128d _mm_unpackhi_pd(__m128d a, __m128d b) { return {{a.x[1], b.x[1]}}; }
GW_VECTOR __m128d _mm_shuffle_pd(__m128d a, __m128d b, int which) {
  return {{a.x[which & 1], b.x[which >> 1 & 1]}};
}

// ---- integers ----
GW_VECTOR __m128i _mm_setr_epi32(int a, int b, int c, int d) { return {{a, b, c, d}}; }
GW_VECTOR __m128i _mm_set_epi32(int d, int c, int b, int a) { return {{a, b, c, d}}; }
GW_VECTOR __m128i _mm_set1_epi32(int a) { return {{a, a, a, a}}; }
GW_VECTOR __m128i _mm_set1_epi64x(long long a) {
  const int low = static_cast<int>(a), high = static_cast<int>(a >> 32);
  return {{low, high, low, high}};
}
GW_VECTOR __m128i _mm_setzero_si128() { return {{0, 0, 0, 0}}; }
GW_VECTOR int _mm_cvtsi128_si32(__m128i a) { return a.x[0]; }
GW_VECTOR __m128i _mm_loadu_si128(const __m128i* from) {
  const int* p = reinterpret_cast<const int*>(from);
  return {{p[0], p[1], p[2], p[3]}};
}
GW_VECTOR __m128i _mm_load_si128(const __m128i* from) { return _mm_loadu_si128(from); }
GW_VECTOR void _mm_storeu_si128(__m128i* to, __m128i a) {
  int* p = reinterpret_cast<int*>(to);
  for (int i = 0; i < 4; ++i) p[i] = a.x[i];
}
GW_VECTOR void _mm_store_si128(__m128i* to, __m128i a) { _mm_storeu_si128(to, a); }
#define GW_EACH(expression)                                          \
  __m128i c;                                                         \
  for (int i = 0; i < 4; ++i) c.x[i] = static_cast<int>(expression); \
  return c
GW_VECTOR __m128i _mm_add_epi32(__m128i a, __m128i b) { GW_EACH(0u + a.x[i] + b.x[i]); }
GW_VECTOR __m128i _mm_sub_epi32(__m128i a, __m128i b) { GW_EACH(0u + a.x[i] - b.x[i]); }
GW_VECTOR __m128i _mm_and_si128(__m128i a, __m128i b) { GW_EACH(a.x[i] & b.x[i]); }
GW_VECTOR __m128i _mm_andnot_si128(__m128i a, __m128i b) { GW_EACH(~a.x[i] & b.x[i]); }
GW_VECTOR __m128i _mm_or_si128(__m128i a, __m128i b) { GW_EACH(a.x[i] | b.x[i]); }
GW_VECTOR __m128i _mm_xor_si128(__m128i a, __m128i b) { GW_EACH(a.x[i] ^ b.x[i]); }
GW_VECTOR __m128i _mm_cmpeq_epi32(__m128i a, __m128i b) { GW_EACH(-(a.x[i] == b.x[i])); }
GW_VECTOR __m128i _mm_cmplt_epi32(__m128i a, __m128i b) { GW_EACH(-(a.x[i] < b.x[i])); }
GW_VECTOR __m128i _mm_cmpgt_epi32(__m128i a, __m128i b) { GW_EACH(-(a.x[i] > b.x[i])); }
GW_VECTOR __m128i _mm_shuffle_epi32(__m128i a, int which) { GW_EACH(a.x[which >> 2 * i & 3]); }
#undef GW_EACH
GW_VECTOR __m128i _mm_unpackhi_epi64(__m128i a, __m128i b) {
  return {{a.x[2], a.x[3], b.x[2], b.x[3]}};
}

// ---- bits of doubles ----
GW_VECTOR __m128i _mm_castpd_si128(__m128d a) { return __builtin_bit_cast(__m128i, a); }
GW_VECTOR __m128d _mm_castsi128_pd(__m128i a) { return __builtin_bit_cast(__m128d, a); }
#define GW_BITS(name)                                                                      \
  GW_VECTOR __m128d _mm_##name##_pd(__m128d a, __m128d b) {                                \
    return _mm_castsi128_pd(_mm_##name##_si128(_mm_castpd_si128(a), _mm_castpd_si128(b))); \
  }
GW_BITS(and)
GW_BITS(andnot)
GW_BITS(or)
GW_BITS(xor)
#undef GW_BITS
#define GW_COMPARED(name, test)                                        \
  GW_VECTOR __m128d _mm_##name##_pd(__m128d a, __m128d b) {            \
    const auto holds = [&](int i) { return -static_cast<int>(test); }; \
    const int low = holds(0), high = holds(1);                         \
    return _mm_castsi128_pd({{low, low, high, high}});                 \
  }
GW_COMPARED(cmpeq, a.x[i] == b.x[i])
GW_COMPARED(cmplt, a.x[i] < b.x[i])
GW_COMPARED(cmple, a.x[i] <= b.x[i])
GW_COMPARED(cmpgt, a.x[i] > b.x[i])
GW_COMPARED(cmpnge, !(a.x[i] >= b.x[i]))
#undef GW_COMPARED
#undef GW_VECTOR

// ---- declared only ----
using GwFloats2 = __m128(__m128, __m128);
GwFloats2 _mm_add_ps, _mm_sub_ps, _mm_mul_ps, _mm_div_ps, _mm_min_ps, _mm_max_ps, _mm_and_ps,
    _mm_andnot_ps, _mm_or_ps, _mm_xor_ps, _mm_cmpeq_ps, _mm_cmplt_ps, _mm_cmple_ps, _mm_cmpgt_ps,
    _mm_cmpnge_ps, _mm_movelh_ps, _mm_movehl_ps, _mm_unpacklo_ps, _mm_unpackhi_ps, _mm_add_ss,
    _mm_mul_ss, _mm_min_ss, _mm_max_ss;
using GwFloats1 = __m128(__m128);
GwFloats1 _mm_sqrt_ps, _mm_sqrt_ss, _mm_rsqrt_ps;
using GwFloatsOfOne = __m128(float);
GwFloatsOfOne _mm_set_ps1, _mm_set_ss;
using GwFloatsAt = __m128(const float*);
GwFloatsAt _mm_load_ps, _mm_loadu_ps;
using GwFloatsTo = void(float*, __m128);
GwFloatsTo _mm_store_ps, _mm_storeu_ps;
__m128 _mm_setzero_ps(), _mm_set_ps(float, float, float, float),
    _mm_shuffle_ps(__m128, __m128, int), _mm_castpd_ps(__m128d), _mm_castsi128_ps(__m128i),
    _mm_cvtpd_ps(__m128d), _mm_cvtepi32_ps(__m128i);
__m128d _mm_castps_pd(__m128), _mm_cvtps_pd(__m128), _mm_cvtepi32_pd(__m128i);
float _mm_cvtss_f32(__m128);
int _mm_movemask_ps(__m128);
void _mm_storel_pi(__m64*, __m128);
using GwIntegers2 = __m128i(__m128i, __m128i);
GwIntegers2 _mm_mul_epu32, _mm_cmpeq_epi8, _mm_unpacklo_epi8, _mm_unpackhi_epi8, _mm_unpacklo_epi16,
    _mm_unpackhi_epi16, _mm_unpacklo_epi32, _mm_unpackhi_epi32, _mm_unpacklo_epi64;
using GwShifted = __m128i(__m128i, int);
GwShifted _mm_slli_epi16, _mm_slli_epi32, _mm_slli_epi64, _mm_srli_epi16, _mm_srli_epi32,
    _mm_srli_epi64, _mm_srai_epi32, _mm_shufflelo_epi16, _mm_shufflehi_epi16;
__m128i _mm_castps_si128(__m128), _mm_cvttps_epi32(__m128), _mm_cvtpd_epi32(__m128d),
    _mm_loadl_epi64(const __m128i*), _mm_set1_epi8(char),
    _mm_set_epi8(char, char, char, char, char, char, char, char, char, char, char, char, char, char,
                 char, char);
void gw_transpose_of_floats();
#define _MM_TRANSPOSE4_PS(a, b, c, d) gw_transpose_of_floats()
#define _MM_SHUFFLE(d, c, b, a) ((d) << 6 | (c) << 4 | (b) << 2 | (a))

// ---- the processor's cache ----
#define _MM_HINT_T0 0
#define _mm_prefetch(address, hint) static_cast<void>(address)

}  // extern "C++"
