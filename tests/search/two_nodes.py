"""Starts a Slurm cluster of two nodes on this machine: munged, slurmctld and two slurmd, all in one
folder and on free ports.

The daemons run in the foreground as children of the test. When the test ends, the kernel ends them, too.
The processes that they start are identified by the variable SLURM_CONF, which names the folder.

The cluster needs root, slurm-wlm, munge and control groups of the kernel. A plain container or chroot does
not have these. If the cluster cannot run, a test is skipped with exit status 77 and the reason. If the
variable CI is set, the test fails instead.
"""
import ctypes
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

NODES = ("n1", "n2")
NEEDED = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "scancel")
CONF = """ClusterName=gearwright
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.sock
CryptoType=crypto/munge
SlurmctldPort={ports[0]}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
SlurmdTimeout=10
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=2,bf_interval=2
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
AccountingStorageType=accounting_storage/none
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[1]} CPUs=2 RealMemory=1000 State=UNKNOWN
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[2]} CPUs=2 RealMemory=1000 State=UNKNOWN
PartitionName=test Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
"""


def why_not():
    """Returns the reason why no cluster can be started here, or None if it can."""
    if os.name != "posix" or os.geteuid() != 0:
        return "the Slurm daemons need root"
    missing = [name for name in NEEDED if not shutil.which(name)]
    if missing:
        return f"not installed: {', '.join(missing)} (Debian: slurm-wlm, munge)"
    try:
        with TwoNodes():
            return None
    except NoCluster as reason:
        return f"the daemons do not run: {reason}"


def main():
    """Runs the tests of the calling script. If there can be no cluster, prints the reason and exits."""
    reason = why_not()
    if not reason:
        unittest.main()
    elif os.environ.get("CI"):
        sys.exit(f"failed, because CI is set: {reason}")
    print(f"skipped: {reason}", flush=True)
    sys.exit(77)


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for s in sockets:
        s.bind(("127.0.0.1", 0))
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


def end_with_the_test():
    libc = ctypes.CDLL(None, use_errno=True)
    libc.prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG


def kill(process):
    try:
        os.kill(process, signal.SIGKILL)
    except ProcessLookupError:
        pass


def parent_of(process):
    """Returns the number and the name of the parent of a process. If the process has ended, returns 0 and
    ""."""
    try:
        stat = pathlib.Path(f"/proc/{process}/stat").read_text()
        parent = int(stat.rsplit(")", 1)[1].split()[1])
        return parent, pathlib.Path(f"/proc/{parent}/comm").read_text().strip()
    except OSError:
        return 0, ""


class NoCluster(Exception):
    """Raised if the cluster cannot be started here."""


class TwoNodes:
    """The cluster, for use as a context: with TwoNodes() as cluster: ..."""

    def __init__(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="gearwright_slurm_"))
        self.folder.chmod(0o755)  # munged requires it
        self.daemons = {}
        self.environment = os.environ | {"SLURM_CONF": str(self.folder / "slurm.conf"), "OMPI_ALLOW_RUN_AS_ROOT": "1",
                                         "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}

    def __enter__(self):
        try:
            self.begin()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        # The other daemons need munged to shut down.
        for name in sorted(self.daemons, key=lambda name: name == "munged"):
            self.end(name, signal.SIGTERM)
        for process in self.processes():
            kill(process)
        shutil.rmtree(self.folder, ignore_errors=True)

    def begin(self):
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        for name in ("state", *(f"spool.{node}" for node in NODES)):
            (self.folder / name).mkdir()
        host = socket.gethostname().split(".")[0]
        (self.folder / "slurm.conf").write_text(CONF.format(folder=self.folder, host=host, ports=free_ports(3)))
        self.daemon("munged", "munged", "--foreground", "--force", *(f"--{what}={self.folder}/munge{end}" for what, end in (
            ("key-file", ".key"), ("socket", ".sock"), ("pid-file", "d.pid"), ("log-file", "d.log"), ("seed-file", "d.seed"))))
        self.wait_to_begin(lambda: (self.folder / "munge.sock").exists(), 10, "munged does not open its socket")
        self.daemon("slurmctld", "slurmctld", "-D")
        for node in NODES:
            self.begin_node(node)
        self.wait_to_begin(lambda: self.ask("sinfo", "-h", "-o", "%t %D").split() == ["idle", "2"], 30, "no nodes start")

    def wait_to_begin(self, true, seconds, what):
        def begun():
            for name, daemon in self.daemons.items():
                if daemon.poll() is not None:
                    said = (self.folder / f"{name}.out").read_text(errors="replace").splitlines()
                    errors = [line for line in said if "error:" in line]
                    raise NoCluster(f"{name} has ended: {'; '.join(errors or said[-1:])}")
            return true()

        try:
            self.wait_for(begun, seconds, what)
        except TimeoutError as late:
            raise NoCluster(late) from None

    def begin_node(self, node):
        self.daemon(node, "slurmd", "-D", "-N", node)

    def daemon(self, name, *command):
        with open(self.folder / f"{name}.out", "w") as out:
            self.daemons[name] = subprocess.Popen(command, env=self.environment, cwd=self.folder, stdin=subprocess.DEVNULL,
                                                  stdout=out, stderr=out, preexec_fn=end_with_the_test)

    def end(self, name, how):
        daemon = self.daemons.pop(name)
        daemon.send_signal(how)
        try:
            daemon.wait(10)
        except subprocess.TimeoutExpired:
            daemon.kill()
            daemon.wait()

    def wait_for(self, true, seconds, what):
        last = time.monotonic() + seconds
        while not true():
            if time.monotonic() > last:
                raise TimeoutError(f"{what}\n{self.logs()}")
            time.sleep(0.1)

    def logs(self):
        return "\n".join(f"{path.name}: {line}" for path in sorted(self.folder.glob("*.log")) + sorted(self.folder.glob("*.out"))
                         for line in path.read_text(errors="replace").splitlines()[-8:])

    def ask(self, *command):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, timeout=60).stdout

    def submit(self, cwd, *args):
        """Submits a job and returns its number."""
        p = subprocess.run(["sbatch", "--parsable", "--export=ALL", *map(str, args)], env=self.environment, cwd=cwd,
                           capture_output=True, text=True, timeout=60)
        if p.returncode:
            raise RuntimeError(f"sbatch: {p.stderr}")
        return p.stdout.strip()

    def queued(self, job):
        return bool(self.ask("squeue", "-h", "-j", job).strip())

    def wait_for_job(self, job, seconds=120):
        self.wait_for(lambda: not self.queued(job), seconds, f"job {job} does not end: {self.ask('squeue')}")

    def lose(self, node):
        """Simulates a power failure of a node. Its daemon and its helpers are killed first, so that they
        cannot report anything."""
        jobs = self.processes(node)
        helpers = {parent for parent, name in map(parent_of, jobs) if name == "slurmstepd"}
        self.daemons[node].kill()
        for process in (*helpers, *jobs):
            kill(process)
        self.end(node, signal.SIGKILL)

    def processes(self, node=None, name=None):
        """Returns the processes of all jobs. If a node or a name is given, returns only those with it."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            if not entry.name.isdigit() or int(entry.name) == os.getpid():
                continue
            try:
                environment = (entry / "environ").read_bytes().split(b"\0")
                comm = (entry / "comm").read_text().strip()
            except OSError:  # the process has ended
                continue
            if f"SLURM_CONF={self.folder}/slurm.conf".encode() not in environment:
                continue
            if node and f"SLURMD_NODENAME={node}".encode() not in environment:
                continue
            if name and comm != name[:15]:
                continue
            found.append(int(entry.name))
        return found
