// Eigen includes this header of x86-64 beside emmintrin.h, which contains everything that it uses.
#pragma once
