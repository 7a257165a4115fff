// The program gearwright-mpi runs on many ranks. Its verbs are search, and scatter over the
// designs of a search.
//
//   mpirun -n 8 gearwright-mpi search spec.toml --out found
//   mpirun -n 8 gearwright-mpi scatter spec.toml --designs found --out ranked
//
// Every rank computes. An MPI window of rank 0 contains the number of the next chunk. All ranks
// increment this number by fetch-and-op, so no rank is reserved as a master. Finished chunks
// are saved in the folder. Rank 0 combines them in order, so the result equals the result of a
// single process byte for byte.
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <memory>

#include "apps/common/search_verb.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/job/verbs.hpp"

using namespace gearwright::apps;

namespace {

// A counter that all ranks increment.
class Queue {
 public:
  Queue() {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Win_allocate(rank == 0 ? sizeof(std::int64_t) : 0, sizeof(std::int64_t), MPI_INFO_NULL,
                     MPI_COMM_WORLD, &counter_, &window_);
    if (rank == 0) *counter_ = 0;
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_Win_lock_all(0, window_);
  }
  Queue(const Queue&) = delete;
  Queue& operator=(const Queue&) = delete;
  ~Queue() {
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
  }
  std::int64_t draw() {
    const std::int64_t one = 1;
    std::int64_t drawn = 0;
    MPI_Fetch_and_op(&one, &drawn, MPI_INT64_T, 0, 0, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return drawn;
  }

 private:
  std::int64_t* counter_ = nullptr;
  MPI_Win window_ = MPI_WIN_NULL;
};

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // if a file reaches its size limit, write() then returns an error
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);

  SearchCommand command;
  StudyCommand study;
  CLI::App app("Gearwright: the design search, and the scatter of its designs, on many ranks.",
               "gearwright-mpi");
  app.set_version_flag("--version", std::string("gearwright-mpi ") + gearwright::kVersion);
  app.require_subcommand(1);
  const gearwright::Verb& row = *gearwright::find_verb("search");
  CLI::App* search = add_campaign(app, row.name, row.meaning, command);
  search->add_option("--take", command.take, row.take_meaning)->check(CLI::Range(1, kMostTaken));
  add_search_options(search, command);
  CLI::App* scatter = add_campaign(
      app, "scatter",
      "Effect of the tolerances in [scatter] on the designs of a search, with a ranking", study);
  add_study_options(scatter, study);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const int status = rank == 0 ? app.exit(e) : e.get_exit_code();
    MPI_Finalize();
    return status == 0 ? 0 : 2;
  }
  int status = 3;
  // The queue must outlive the try block. Its destructor frees the MPI window, which waits for all
  // ranks. If an exception destroyed the queue before MPI_Abort, the program might never end,
  // because the other ranks may be waiting for this rank.
  auto queue = std::make_unique<Queue>();
  try {
    Together together;
    together.rank = rank;
    together.ranks = ranks;
    together.next_chunk = [&] { return queue->draw(); };
    together.folder_is_open = [](bool opened) {
      int all = opened ? 1 : 0;
      MPI_Bcast(&all, 1, MPI_INT, 0, MPI_COMM_WORLD);
      return all == 1;
    };
    together.finish_together = [rank] {
      MPI_Barrier(MPI_COMM_WORLD);
      return rank == 0;
    };
    if (provided < MPI_THREAD_SERIALIZED) command.threads = study.threads = 1;
    status = app.got_subcommand("scatter") ? run_study_verb(study, &together)
                                           : run_search_verb(command, &together);
  } catch (const std::exception& e) {
    // The other ranks wait for this rank, so they must also be ended.
    std::cerr << "gearwright-mpi: rank " << rank << ": " << e.what() << "\n";
    MPI_Abort(MPI_COMM_WORLD, 3);
  }
  queue.reset();
  MPI_Finalize();
  return status;
}
