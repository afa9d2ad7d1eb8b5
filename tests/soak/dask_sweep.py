"""The recipe of examples/dask, run for real: 10,000 plants, with a worker killed half-way, and its pace against the plain loop.

    python dask_sweep.py <bough-sweep> <rounds>

A core's pace is counted in seconds of processor time, of scheduler, client and workers together: others who use the machine do not
count. Seconds on the wall are told beside it.
"""

import concurrent.futures
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "examples" / "dask"))

from dask.distributed import Client, LocalCluster  # noqa: E402
from sweep import sweep  # noqa: E402

PLANTS = 10_000
WORKERS = 2


def line(number: int) -> bytes:
    """Plants that differ in four parameters; of row 7,000 no plant can be grown."""
    params = {
        "axis": {"segments": 300, "segmentLength": 0.005, "elevation": 10 + number % 80},
        "material": {"youngsModulus": 5e8 + 1e5 * (number % 977)},
        "tropism": {"strength": 0.1 * (number % 31)},
        "growth": {"thickening": "pipes"},
        "loads": {"gravity": -1 if number == 7000 else 0.001 * number},
    }
    return json.dumps(params).encode() + b"\n"


def spent() -> float:
    """Processor time of this process and of its children that have ended, s."""
    user, system, children_user, children_system, _ = os.times()
    return user + system + children_user + children_system


class Clock:
    """Measures what is done in a `with` block."""

    def __init__(self, client: Client | None = None) -> None:
        self.client = client

    def everything_spent(self) -> float:
        return spent() + (sum(self.client.run(spent).values()) if self.client else 0)

    def __enter__(self) -> "Clock":
        self.wall, self.processor = time.perf_counter(), self.everything_spent()
        return self

    def __exit__(self, *_) -> None:
        self.wall, self.processor = time.perf_counter() - self.wall, self.everything_spent() - self.processor


def plain(binary: str, parts: list[list[bytes]]) -> bytes:
    """The binary by itself, one process for each part, all at the same time."""

    def grow(part: list[bytes]) -> bytes:
        return subprocess.run([binary], input=b"".join(part), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout

    with concurrent.futures.ThreadPoolExecutor(len(parts)) as threads:
        return b"".join(threads.map(grow, parts))


def main() -> None:
    binary, rounds = sys.argv[1], int(sys.argv[2])
    lines = [line(number) for number in range(1, PLANTS + 1)]
    halves = [lines[: PLANTS // 2], lines[PLANTS // 2 :]]
    expected = plain(binary, [lines])
    loops, engines = [], []
    local = LocalCluster(n_workers=WORKERS, threads_per_worker=1, dashboard_address=None)
    with local as cluster, Client(cluster) as client:
        sweep(client, binary, lines[:500])  # Dask sends its code to the workers once.
        for _ in range(rounds):
            with Clock() as loop:
                plain(binary, halves)
            with Clock(client) as engine:
                results = sweep(client, binary, lines)
            loops.append(loop)
            engines.append(engine)
            assert b"".join(results) == expected, "the engine's results differ from those of one process"

        killed = []

        def kill_half_way(share: float) -> None:
            if share >= 0.5 and not killed:
                worker = next(iter(client.run(os.getpid).values()))
                os.kill(worker, signal.SIGKILL)
                killed.append(worker)

        results = sweep(client, binary, lines, on_progress=kill_half_way)
        assert killed, "no worker was killed"
        assert b"".join(results) == expected, "with a worker killed, the results differ from those of one process"

    rows = [json.loads(row) for row in expected.splitlines()]
    bad = [row for row in rows if "error" in row]
    assert [row["line"] for row in rows] == list(range(1, PLANTS + 1))
    assert [row["line"] for row in bad] == [7000], bad
    loop, engine = (min(clock.processor for clock in clocks) for clocks in (loops, engines))
    loop_wall, engine_wall = (min(clock.wall for clock in clocks) for clocks in (loops, engines))
    ratio = loop / engine
    print(f"{PLANTS} plants of 300 segments on {WORKERS} local workers of Dask, one killed half-way: equal to the single process")
    print(f"row 7000 alone is bad: {bad[0]['error']}")
    print(f"plants a second of one core, best of {rounds}: plain loop {PLANTS / loop:.0f}, Dask {PLANTS / engine:.0f}")
    print(f"that is {ratio:.3f} of the plain loop, wanted >= 0.9")
    print(f"on the wall, {WORKERS} cores: plain loop {loop_wall:.1f} s, Dask {engine_wall:.1f} s")
    assert ratio >= 0.9, f"the engine costs too much: {ratio:.3f}"


if __name__ == "__main__":
    main()
