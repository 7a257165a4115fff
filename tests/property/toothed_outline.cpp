// The oracle's sweep, compiled into this set of tests too.
#include "tests/oracle/toothed_outline.cpp"
