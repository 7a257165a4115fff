// Runs the verbs. Each function reads a spec, calls the functions of gearwright/job, prints the
// result and returns the exit status.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/job/files.hpp"
#include "gearwright/job/verbs.hpp"
#include "gearwright/spec/spec_text.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright::apps {

struct Options {
  std::string spec;
  bool json = false;
  bool strict = false;  // if true, a verdict that is not green gives status 4
  bool csv = false;
  std::optional<std::string> out;
  std::optional<std::string> only;  // for run: names of parts, from kRunParts
  std::optional<int> gear;
  std::string part;  // for export: "1", "2", or the name of a part or gear of a drive
  int points = 50;
  std::string step, stl, glb, threemf, dxf, svg, drawing, rexs;
  std::string sheet;  // "A4", "A3", or empty if the scale determines the size
  std::string step_schema = "ap242";
  FileOptions files;
  std::vector<std::string> cases;
  std::optional<std::string> as_rack;  // for gear: "module,angle"
  std::optional<int> take;             // number of the design or proposal whose spec is printed
  bool expand = false;                 // if true, the graph of a drive is printed
  std::optional<int> harmonics;        // for drive: number of harmonics
  std::optional<std::string> grid;     // for measure: grid of nominal points of the flanks, "9x5"
  std::optional<int> fillet_points;    // for measure: number of points along each root fillet
  std::string schema;                  // for schema: spec or result
  std::string shell;                   // for completion: bash, zsh or fish
  std::vector<std::string> words;      // for batch: a verb and a file
  int threads = 0;                     // for batch; 0 means all cores
};

// All functions of this file throw IoError if the system fails.
/// Runs any verb of the table. Prints the answer as JSON, CSV or text. If a proposal or the graph
/// of a drive is requested, prints the spec of this proposal or graph instead. If the spec has
/// already been read, it is passed as `text`.
int answering_verb(const Verb& verb, const Options& o, const SpecText* text = nullptr);
/// `gear --as-rack`: prints how another rack describes the same teeth.
int gear_as_rack(const Options& o);
/// `measure --points`: prints nominal points of the flanks.
int nominal_points(const Options& o);
int run_verb(const Options& o);
int outline_verb(const Options& o);
int export_verb(const Options& o);
int import_verb(const Options& o);
int verify_verb(const Options& o);
int schema_verb(const Options& o);

/// Reads the spec of a verb once, from a file or a pipe, and reports its errors with
/// their lines.
class Door {
 public:
  /// `text` is the spec if it has already been read.
  explicit Door(const Options& o, const SpecText* text = nullptr) : options_(o) {
    if (text) text_ = *text;
  }

  /// Reads the spec. Returns an error if the spec is wrong, or if an input that `use` requires is
  /// missing.
  Result<JobSpec> read(SpecUse use = SpecUse::geometry);
  Result<SolvedJob> solve(Scope scope, SpecUse use = SpecUse::geometry);
  /// Reports the error with the keys of the spec and returns the exit status.
  int fail(const Error& error) const;

 private:
  const Options& options_;
  std::optional<SpecText> text_;
  std::optional<GivenKeys> given_;
};

// Returns 4 if --strict is given and the verdict is not green, so that scripts can react. Otherwise
// returns 0.
inline int status(const Options& o, const Verdict& verdict) {
  return o.strict && verdict.level != Level::green ? 4 : 0;
}

// The verb batch, which computes many specs in one process.

/// Reads specs from lines of JSON and writes answers as lines of JSON. Returns 1 if an answer is
/// the error of a spec, and 5 if an answer reports a defect of Gearwright.
/// Throws    IoError
int batch_verb(const Options& o);

}  // namespace gearwright::apps
