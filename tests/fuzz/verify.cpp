// Interprets any bytes as a file of cases. The result is a list of outcomes, or one error message
// about the file.
#include "gearwright/job/verify.hpp"

#include "tests/fuzz/fuzzing.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gearwright;
  using fuzz::require;
  const auto outcomes = verify_cases(fuzz::text_of(data, size));
  if (!outcomes) {
    require(!outcomes.error().message().empty());
    return 0;
  }
  require(!outcomes->empty());
  for (const CaseOutcome& c : *outcomes) {
    require(c.values > 0);
    for (const std::string& d : c.differences) require(!d.empty());
  }
  return 0;
}
