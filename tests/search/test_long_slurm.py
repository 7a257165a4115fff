"""Tests an array job during which a node fails. Slurm starts the task of this node again on the other
node, and the search finishes without further action.

Slurm waits two minutes before it starts the task of a failed node again. The requirements are those of
test_slurm.py.
"""
import time

from searching import chunks, wait_until
from test_slurm import CHUNK, SCRIPTS, Slurm as Short
from two_nodes import main


class LongSlurm(Short):
    # This file uses only the cluster and the search of test_slurm.py.
    test_an_array_whose_tasks_on_one_node_are_killed = None
    test_an_array_of_another_size_takes_over = None
    test_ranks_of_one_job = None

    def test_a_node_dies(self):
        out = self.where / "dies"
        job = self.submit("--array=0-1", SCRIPTS / "search_array.sbatch", "case.toml", "dies", *CHUNK)
        self.assertTrue(wait_until(lambda: chunks(out) > 0 and self.cluster.processes("n2", "gearwright")), self.log(job))
        self.cluster.lose("n2")
        self.assertTrue(wait_until(lambda: "n2 down" in self.cluster.ask("sinfo", "-h", "-N", "-o", "%N %T").replace("*", ""),
                                   120, 1.0), self.log(job))
        self.assertFalse((out / "search.json").exists(), "the node failed too late to test anything")
        began = time.monotonic()
        self.cluster.wait_for_job(job, 400)
        self.finish(job, "dies")
        print(f"the other node finished the task of the failed node after {time.monotonic() - began:.0f} s")


del Short  # otherwise unittest would run its tests again
if __name__ == "__main__":
    main()
