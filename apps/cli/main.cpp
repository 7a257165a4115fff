// The program gearwright. It parses the command line, calls the functions of gearwright/job and
// prints the results.
//
// Exit status:
//   0   success
//   1   the input is wrong, the gears are impossible, or `verify` found differences
//   2   the command line is wrong
//   3   the system failed, for example because of a full disk, or a signal stopped the program
//   4   --strict is given, and the verdict is not green
//   5   a defect of Gearwright itself
#include <cstdio>
#include <exception>
#include <new>

#include "apps/cli/command_line.hpp"
#include "gearwright/base/system.hpp"

int main(int argc, char** argv) {
  try {
    return gearwright::apps::CommandLine().run(gearwright::start_program(argc, argv));
  } catch (const std::bad_alloc&) {
    std::fputs(
        "gearwright: out of memory; a narrower face, fewer teeth or a coarser tolerance would "
        "help\n",
        stderr);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "gearwright: %s\n", e.what());
  }
  return 3;
}
