// Lets Eigen compile its vectors of two doubles (SSE2) for WebAssembly, where emscripten has all of its
// headers except this one. Eigen includes it before those vectors. They contain instructions of x86 for the
// versions of GCC before 6.3, and clang reports version 4.2.
#pragma once
#undef EIGEN_COMP_GNUC
#define EIGEN_COMP_GNUC 0
