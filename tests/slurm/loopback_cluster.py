# SPDX-License-Identifier: Apache-2.0
"""A Slurm cluster of several nodes on one machine: daemons, keys, sockets and ports of its own."""
import os
import shutil
import signal
import socket
import subprocess
import time

TOOLS = ["munged", "slurmctld", "slurmd", "sbatch", "scancel", "sinfo", "squeue"]

CONFIGURATION = """
ClusterName=loopback
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1
CommunicationParameters=NoInAddrAny
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
SlurmdParameters=config_overrides
SlurmdTimeout=5
KillWait=1
ReturnToService=2
JobRequeue=1
{nodes}
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


class CannotRun(Exception):
    """The daemons do not come up on this machine."""


def why_not():
    """Why a cluster cannot run here, or None."""
    missing = [tool for tool in TOOLS if shutil.which(tool) is None]
    if missing:
        return "not installed: " + ", ".join(missing)
    return None if os.geteuid() == 0 else "not root"


def free_ports(count):
    """Ports that nobody listens on now; taken from below those that the kernel gives to clients."""
    found = []
    for port in range(20000 + os.getpid() % 9000, 32000):
        with socket.socket() as probe:
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            try:
                probe.bind(("127.0.0.1", port))
            except OSError:
                continue
        found.append(port)
        if len(found) == count:
            return found
    raise RuntimeError("no free ports")


def processes_on(node):
    """Processes of jobs that run on a node, each with the slurmstepd above it."""
    found = set()
    for entry in os.listdir("/proc"):
        if not entry.isdigit():
            continue
        try:
            with open(f"/proc/{entry}/environ", "rb") as file:
                if f"SLURMD_NODENAME={node}".encode() not in file.read().split(b"\0"):
                    continue
            with open(f"/proc/{entry}/stat", encoding="ascii") as file:
                parent = int(file.read().rsplit(")", 1)[1].split()[1])
            with open(f"/proc/{parent}/comm", encoding="ascii") as file:
                if file.read().startswith("slurmstepd"):
                    found.add(parent)
        except (OSError, ValueError):
            continue  # it is gone
        found.add(int(entry))
    return found


class Cluster:
    """`with Cluster(folder, 4) as cluster:` nodes n1 to n4, one processor each."""

    def __init__(self, folder, nodes):
        self.folder, self.names = folder, [f"n{i + 1}" for i in range(nodes)]
        self.daemons = {}
        os.makedirs(os.path.join(folder, "state"))
        os.chmod(folder, 0o755)  # munged asks for that
        host = socket.gethostname().split(".")[0]
        ports = free_ports(nodes + 1)
        lines = [f"NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs=1 State=UNKNOWN"
                 for name, port in zip(self.names, ports[1:])]
        self.configuration = os.path.join(folder, "slurm.conf")
        with open(self.configuration, "w", encoding="ascii") as file:
            file.write(CONFIGURATION.format(host=host, port=ports[0], folder=folder, nodes="\n".join(lines)))
        self.environment = dict(os.environ, SLURM_CONF=self.configuration)

    def __enter__(self):
        try:
            self._start_munge()
            self._start("slurmctld", ["slurmctld", "-D", "-f", self.configuration])
            for name in self.names:
                self.start_node(name)
            self.wait_for(self._is_up, 120, "idle nodes")
        except TimeoutError as late:
            self.__exit__(None, None, None)
            raise CannotRun(str(late)) from late
        except BaseException:
            self.__exit__(None, None, None)
            raise
        return self

    def __exit__(self, *_):
        for name in self.names:
            self._kill_jobs(name)
        for process in reversed(list(self.daemons.values())):
            process.terminate()
        for process in self.daemons.values():
            try:
                process.wait(timeout=5)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        for name in self.names:
            self._kill_jobs(name)

    def _start_munge(self):
        key = os.path.join(self.folder, "munge.key")
        with open(os.open(key, os.O_WRONLY | os.O_CREAT, 0o400), "wb") as file:
            file.write(os.urandom(1024))
        path = lambda name: os.path.join(self.folder, name)
        self._start("munged", ["munged", "--foreground", "--force", "--num-threads=2", "--key-file=" + key,
                               "--socket=" + path("munge.socket"), "--pid-file=" + path("munged.pid"),
                               "--log-file=" + path("munged.log"), "--seed-file=" + path("munged.seed")])
        self.wait_for(lambda: os.path.exists(path("munge.socket")), 60, "munged")

    def _start(self, name, command):
        with open(os.path.join(self.folder, name + ".out"), "ab") as out:
            self.daemons[name] = subprocess.Popen(command, stdout=out, stderr=out, stdin=subprocess.DEVNULL,
                                                  env=self.environment)

    def start_node(self, name):
        os.makedirs(os.path.join(self.folder, "spool-" + name), exist_ok=True)
        self._start(name, ["slurmd", "-D", "-f", self.configuration, "-N", name])

    def _kill_jobs(self, name):
        for process in processes_on(name):
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def lose_node(self, name):
        """As if its power had failed: slurmd and all that runs on it are gone at once."""
        daemon = self.daemons.pop(name)
        daemon.kill()
        self._kill_jobs(name)
        daemon.wait()

    def _is_up(self):
        for name, daemon in self.daemons.items():
            if daemon.poll() is not None:
                raise CannotRun(f"{name} ends at once: {self._first_error(name)}")
        return self._states().count("idle") == len(self.names)

    def _first_error(self, name):
        """The first error that a daemon has named, for a reader without its log."""
        for file in (f"slurmd-{name}.log", name + ".log", name + ".out"):
            path = os.path.join(self.folder, file)
            if os.path.exists(path):
                with open(path, encoding="utf-8", errors="replace") as log:
                    for line in log:
                        if "error:" in line:
                            return line.split("error:", 1)[1].strip()
        return "no error in its log"

    def _states(self):
        shown = self.run(["sinfo", "-h", "-N", "-o", "%T"]).stdout.split()
        return shown

    def run(self, command, **options):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False, **options)

    @staticmethod
    def wait_for(condition, seconds, what):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                raise TimeoutError(f"no {what} after {seconds} s")
            time.sleep(0.1)
