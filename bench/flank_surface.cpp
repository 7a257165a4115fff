// The oracle's flanks for the race in contact_bench.cpp.
#include "tests/oracle/flank_surface.cpp"
