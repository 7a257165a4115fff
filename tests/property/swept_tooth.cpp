// The oracle's walk over the finished tooth, compiled into this set of tests too.
#include "tests/oracle/swept_tooth.cpp"
