// One function per verb: each reads a spec, calls the job room, prints, and gives the exit status.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gearwright::cli {

struct Options {
  std::string spec;
  bool json = false;
  bool strict = false;  // a verdict that is not green ends in status 4
  bool csv = false;
  std::optional<std::string> out;
  std::optional<std::string> only;  // of run: words of kRunParts
  std::optional<int> gear;
  int points = 50;
  std::string step, stl, glb, threemf, dxf, svg, drawing;
  std::string sheet = "A4";
  std::string step_schema = "ap242";
  double mesh_tolerance = 0.005;     // mm
  double drawing_tolerance = 0.001;  // mm
  bool drawing_splines = false;
  std::vector<std::string> cases;
  std::optional<std::string> as_rack;  // of gear: "module,angle"
  std::optional<int> take;             // of fit, identify: the answer whose spec is printed
  std::optional<std::string> grid;     // of measure: the nominal points of the flanks, "9x5"
  std::optional<int> fillet_points;    // of measure: as many along each root fillet
  bool spec_only = false;              // of compensate: print the corrected spec
  std::string schema;                  // of schema: of what
  std::string shell;                   // of completion
  std::vector<std::string> words;      // of batch: a verb, a file
  int threads = 0;                     // of batch; 0: all
};

// All throw IoError when the outside world fails.
int run_verb(const Options& o);
int gear_verb(const Options& o);
int outline_verb(const Options& o);
int pair_verb(const Options& o);
int measure_verb(const Options& o);
int fit_verb(const Options& o);
int identify_verb(const Options& o);
int contact_verb(const Options& o);
int compensate_verb(const Options& o);
int load_verb(const Options& o);
int rate_verb(const Options& o);
int export_verb(const Options& o);
int verify_verb(const Options& o);
int schema_verb(const Options& o);

}  // namespace gearwright::cli
