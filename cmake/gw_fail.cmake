# ctest runs this in place of a test set that could not be built. It reports the reason and fails.
message(FATAL_ERROR "${WHAT}; `make test` installs what is missing")
