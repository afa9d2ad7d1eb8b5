"""A sweep on a Dask cluster: a plant for every line of a file of params, in order, whatever becomes of single workers.

    python sweep.py plants.jsonl > measures.jsonl
    python sweep.py plants.jsonl --scheduler tcp://head:8786 --binary /shared/bough-sweep > measures.jsonl

Every worker must reach the binary `bough-sweep` at the same path.
"""

import argparse
import subprocess
import sys

from dask.distributed import Client, LocalCluster, as_completed


def grow(binary: str, first: int, lines: bytes) -> bytes:
    """One piece of the sweep. Bad lines are lines of the output; only a binary that cannot run at all is an error."""
    command = [binary, "--first", str(first)]
    done = subprocess.run(command, input=lines, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode not in (0, 1):
        raise RuntimeError(done.stderr.decode())
    return done.stdout


def sweep(client: Client, binary: str, lines: list[bytes], piece: int = 250, on_progress=None) -> list[bytes]:
    """The output for all lines, in their order. Dask gives the pieces of a worker that dies to another."""
    starts = range(0, len(lines), piece)
    firsts = [start + 1 for start in starts]
    pieces = [b"".join(lines[start : start + piece]) for start in starts]
    futures = client.map(grow, [binary] * len(pieces), firsts, pieces, retries=3)
    for done, _ in enumerate(as_completed(futures), start=1):
        if on_progress:
            on_progress(done / len(futures))
    return client.gather(futures)


def main() -> int:
    arguments = argparse.ArgumentParser(description="A sweep on a Dask cluster.")
    arguments.add_argument("file")
    arguments.add_argument("--binary", default="bough-sweep")
    arguments.add_argument("--scheduler", help="address of a cluster; workers of this machine if left out")
    given = arguments.parse_args()
    with open(given.file, "rb") as file:
        lines = file.readlines()
    address = given.scheduler or LocalCluster(threads_per_worker=1, dashboard_address=None)
    with Client(address) as client:
        results = sweep(client, given.binary, lines)
    sys.stdout.buffer.writelines(results)
    return 1 if any(b'"error":' in rows for rows in results) else 0


if __name__ == "__main__":
    sys.exit(main())
