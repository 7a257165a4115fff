// The oracle's sweep, compiled into this set of tests too.
#include "tests/oracle/swept_pinion.cpp"
