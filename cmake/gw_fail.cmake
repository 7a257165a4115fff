# Run by ctest in place of a test set that could not be built: says why, and fails.
message(FATAL_ERROR "${WHAT}; `make test` installs what is missing")
