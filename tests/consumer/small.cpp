// Calls one function of the installed library.
#include "gearwright/math/statistics.hpp"

int main() { return gearwright::normal_cdf(0.0) == 0.5 ? 0 : 1; }
