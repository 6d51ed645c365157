"""Kills `selvedge batch` at random moments, and shows that no result is lost.

    kill_batches.py PROGRAM SOURCE_FOLDER [KILLS]

Each round begins a batch of 12 jobs and kills it within the time of a few jobs; the same command then goes on, until the
batch ends by itself. After each kill all earlier results must be there, unchanged. What a batch ends with must have the
bytes of a batch that nobody killed. Half of the kills hit all processes, the others the main one alone.
"""
import hashlib
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path


def command(program, source, out, cache):
    patterns = source / "patterns"
    return [program, "batch", "--patterns", patterns / "vest.json", "--patterns", patterns / "two_squares.json",
            "--bodies", "mannequin", "--bodies", "mannequin:sex=male", "--fabrics", "silk,denim,linen", "--no-pictures",
            "--set", "seconds=1", "--jobs", "2", "--cache", cache, "-o", out]


def results_in(out):
    """The results by job: a hash of all that is in its folder."""
    found = {}
    for folder in (out / "jobs").glob("[!.]*"):
        if "@" in folder.name or not (folder / "job.json").exists():  # with @: unfinished, or about to be replaced
            continue
        digest = hashlib.sha256()
        for file in sorted(folder.glob("[!.]*")):
            digest.update(file.name.encode() + b"\0" + file.read_bytes())
        found[folder.name] = digest.hexdigest()
    return found


def final_bytes(out):
    return [(out / name).read_bytes() for name in ("results.jsonl", "results.csv", "index.html")]


def kill(process, whole):
    if whole:
        os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
    process.wait()


def main():
    program, source = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    kills_wanted = int(sys.argv[3]) if len(sys.argv) > 3 else 200
    chance = random.Random(1)
    kills = rounds = lost = most = 0
    with tempfile.TemporaryDirectory() as work:
        work = Path(work)
        cache = work / "cache"
        whole = work / "whole" / "out"
        whole.parent.mkdir()
        run = command(program, source, whole, cache)
        subprocess.run(run, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)  # fills the cache
        start = time.monotonic()
        subprocess.run(run + ["--again"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        longest = 4 * (time.monotonic() - start) / 12  # s, of which two jobs take two quarters
        expected = final_bytes(whole)
        assert len(results_in(whole)) == 12, "the batch that nobody kills does not do its 12 jobs"
        while kills < kills_wanted:
            rounds += 1
            out = work / f"round{rounds}" / "out"
            out.parent.mkdir()
            before = {}
            while True:
                process = subprocess.Popen(command(program, source, out, cache), stdout=subprocess.DEVNULL,
                                           stderr=subprocess.DEVNULL, start_new_session=True)
                try:
                    process.wait(timeout=chance.uniform(0, longest))
                    break
                except subprocess.TimeoutExpired:
                    kill(process, whole=chance.random() < 0.5)
                    kills += 1
                    time.sleep(chance.uniform(0, 0.2))
                now = results_in(out)
                lost += sum(1 for job, digest in before.items() if now.get(job) != digest)
                before = now
                most = max(most, len(now))
            assert final_bytes(out) == expected, f"round {rounds} ends with other results"
    print(f"{kills} kills in {rounds} rounds, {lost} results lost")
    assert most > 0, "no kill found a result"
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main())
