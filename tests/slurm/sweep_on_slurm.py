#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""gnomon sweep --slurm on a cluster of four nodes on this machine: the same table as a local run, also after a lost node.

Usage: sweep_on_slurm.py GNOMON TEST...   exit status 77: Slurm cannot run here
"""
import os
import sqlite3
import subprocess
import sys
import tempfile

from loopback_cluster import CannotRun, Cluster, why_not

CUBE = """v -1 -1 -1
v 1 -1 -1
v -1 1 -1
v 1 1 -1
v -1 -1 1
v 1 -1 1
v -1 1 1
v 1 1 1
f 1 5 7 3
f 2 4 8 6
f 1 2 6 5
f 3 7 8 4
f 1 3 4 2
f 5 6 8 7
"""
SPECIFICATION = """scenes = ["cube.obj"]
[fixed]
plane = 64
[axes]
res = [{res}]
technique = ["voxel-offset", "plain-map"]
depth_bits = [12, 20]
light = [[0.45, -1, -0.4], [1, -0.25, -0.3]]
"""


class Failed(Exception):
    """A check that did not hold."""


def check(holds, what):
    if not holds:
        raise Failed(what)
    print("ok:", what, flush=True)


class Sweep:
    """One specification, and what its tables hold."""

    def __init__(self, program, folder, resolutions):
        self.program, self.folder = program, folder
        self.points = 8 * len(resolutions)
        with open(os.path.join(folder, "cube.obj"), "w", encoding="ascii") as file:
            file.write(CUBE)
        with open(os.path.join(folder, "spec.toml"), "w", encoding="ascii") as file:
            file.write(SPECIFICATION.format(res=", ".join(map(str, resolutions))))

    def command(self, output, *more):
        return [self.program, "sweep", os.path.join(self.folder, "spec.toml"), "-o", os.path.join(self.folder, output),
                "-q", *more]

    def rows(self, output, name="results.sqlite"):
        """Key to configuration, status and figures but for wall times."""
        path = os.path.join(self.folder, output, name)
        if not os.path.exists(path):
            return {}
        database = sqlite3.connect(f"file:{path}?mode=ro", uri=True, timeout=10)
        try:
            points = database.execute("SELECT id, key, scene, configuration, status FROM point").fetchall()
            figures = {}
            for point, figure, value in database.execute("SELECT point, name, value FROM figure"):
                if not figure.startswith(("seconds.", "host.")):
                    figures.setdefault(point, {})[figure] = value
        except sqlite3.OperationalError:
            return {}  # it is just being made
        finally:
            database.close()
        return {key: (scene, configuration, status, figures.get(point, {}))
                for point, key, scene, configuration, status in points}

    def shard_rows(self, output, shard, count):
        return self.rows(output, f"shard-{shard}-of-{count}.sqlite")

    def undisturbed(self):
        subprocess.run(self.command("local"), check=True, capture_output=True)
        rows = self.rows("local")
        check(len(rows) == self.points and all(row[2] == "done" for row in rows.values()),
              f"the local run measured {self.points} points")
        compared = sum(len(row[3]) for row in rows.values())
        check(compared > 20 * self.points, f"{compared} figures to compare")
        return rows


def same_table(cluster, sweep):
    """Eight shards on four nodes against one local run."""
    local = sweep.undisturbed()
    done = cluster.run(sweep.command("remote", "--slurm", "8", "--wait"), timeout=600)
    check(done.returncode == 0, "submitted and merged " + done.stderr)
    check(sweep.rows("remote") == local, "the same table")
    logs = os.listdir(os.path.join(sweep.folder, "remote", "slurm"))
    check(sum(name.startswith("shard-") for name in logs) == 8, "eight tasks have run")
    again = cluster.run(sweep.command("remote", "--slurm", "8", "--wait"), timeout=600)
    check(again.returncode == 0 and sweep.rows("remote") == local, "the same again adds nothing")
    other = cluster.run(sweep.command("other", "--slurm", "2", "--slurm-option=--partition=none"))
    check(other.returncode == 2 and "artition" in other.stderr, "what sbatch refuses is said: " + other.stderr.strip())


def lost_node(cluster, sweep):
    """A node dies while its shard is half measured."""
    local = sweep.undisturbed()
    done = cluster.run(sweep.command("remote", "--slurm", "4"))
    check(done.returncode == 0, "submitted")
    cluster.wait_for(lambda: 0 < len(sweep.shard_rows("remote", 2, 4)), 300, "point of shard 2")
    where = cluster.run(["squeue", "-h", "-r", "-t", "R", "-o", "%K %N"]).stdout.split("\n")
    node = {line.split()[0]: line.split()[1] for line in where if len(line.split()) == 2}.get("2")
    check(node is not None, f"shard 2 runs on {node}")
    cluster.lose_node(node)
    measured = len(sweep.shard_rows("remote", 2, 4))
    check(0 < measured < sweep.points // 4, f"{measured} of its {sweep.points // 4} points measured when the node died")
    cluster.wait_for(lambda: len(sweep.rows("remote")) == sweep.points, 600, "merged table")
    check(sweep.rows("remote") == local, "the same table")


def cancelled(cluster, sweep):
    """The array is cancelled; the merge says what is missing, and the same command measures it."""
    local = sweep.undisturbed()
    with subprocess.Popen(sweep.command("remote", "--slurm", "4", "--wait"), env=cluster.environment,
                          stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as waiting:
        cluster.wait_for(lambda: 0 < len(sweep.shard_rows("remote", 3, 4)), 300, "point of shard 3")
        cluster.run(["scancel", "--name=gnomon-sweep"])
        said = waiting.communicate(timeout=600)[1]
    check(waiting.returncode == 2 and "points are missing" in said, "it is said: " + said.strip())
    check(0 < len(sweep.rows("remote")) < sweep.points, f"{len(sweep.rows('remote'))} points merged")
    done = cluster.run(sweep.command("remote", "--slurm", "4", "--wait"), timeout=600)
    check(done.returncode == 0, "the same command again " + done.stderr)
    check(sweep.rows("remote") == local, "the same table")


TESTS = {"same_table": (same_table, [16, 20]), "lost_node": (lost_node, [48, 56, 64]),
         "cancelled": (cancelled, [48, 56, 64])}


def main():
    reason = why_not()
    if reason is not None:
        print("skipped: Slurm cannot run here:", reason)
        return 77
    for name in sys.argv[2:]:
        test, resolutions = TESTS[name]
        with tempfile.TemporaryDirectory(prefix="gnomon-slurm-") as folder:
            os.makedirs(os.path.join(folder, "sweep"))
            try:
                with Cluster(os.path.join(folder, "cluster"), 4) as cluster:
                    test(cluster, Sweep(os.path.abspath(sys.argv[1]), os.path.join(folder, "sweep"), resolutions))
            except CannotRun as reason:
                print("skipped: Slurm cannot run here:", reason)
                return 77
            except (Failed, TimeoutError, subprocess.SubprocessError) as problem:
                print(f"{name}: FAILED: {problem}")
                print(logs_of(folder))
                return 1
    return 0


def logs_of(folder):
    """The end of what the daemons and the shards said."""
    text = ""
    for where in ("cluster", os.path.join("sweep", "remote", "slurm")):
        path = os.path.join(folder, where)
        for name in sorted(os.listdir(path)) if os.path.isdir(path) else []:
            if name.endswith((".log", ".out", ".txt")):
                with open(os.path.join(path, name), encoding="utf-8", errors="replace") as file:
                    text += f"--- {name}\n" + "".join(file.readlines()[-12:])
    return text


if __name__ == "__main__":
    sys.exit(main())
