"""Rules that are used while the interpreter ends."""

from __future__ import annotations

import subprocess
import sys

import pytest

IN_DEL = """
import numpy as np, thinbench
class Worker:
    def __init__(self):
        self.thin, self.rule, self.image = thinbench.thin, thinbench.Rule.named("majority"), np.ones((40, 40), bool)
    def __del__(self):
        self.thin(self.image, self.rule)
        print("done")
worker = Worker()
worker.itself = worker
"""
REGISTERED_BEFORE_THE_IMPORT = """
import atexit
atexit.register(lambda: (thinbench.thin(np.ones((40, 40), bool), rule), print("done")))
import numpy as np, thinbench
rule = thinbench.Rule.named("majority")
"""
DAEMONS = """
import threading, time
import numpy as np, thinbench
rules = [thinbench.Rule(np.random.default_rng(i).random(512) < 0.5, max_iterations=3) for i in range(4)]
def work(rule):
    while True:
        thinbench.thin(np.ones((64, 640), bool), rule)
for rule in rules:
    threading.Thread(target=work, args=(rule,), daemon=True).start()
time.sleep(0.05)
print("done")
"""


@pytest.mark.parametrize(("program", "times"),
                         [(IN_DEL, 1), (REGISTERED_BEFORE_THE_IMPORT, 1), (DAEMONS, 5)],
                         ids=["in __del__", "registered before the import", "in daemon threads"])
def test_rule_lives_as_long_as_it_is_used(program: str, times: int) -> None:
    """Handles of living objects are not destroyed."""
    for _ in range(times):
        done = subprocess.run([sys.executable, "-c", program], check=False, capture_output=True, text=True)
        assert (done.returncode, done.stdout, done.stderr) == (0, "done\n", "")
