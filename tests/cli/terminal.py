#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""terminal.py CORGEN [SEED]: tests progress on a terminal: of four slow commands, or of all if SEED is "all". The first
line appears within a second, and later lines at least about once a second, also between rows. Ctrl-C leaves no file."""
import os
import pty
import random
import re
import select
import subprocess
import sys
import tempfile
import time

SILENT = 1.5  # seconds; a loaded machine may delay a line
SLOW = """series --order {order}
series --elastic {exponent} --order 30
series --order {order} --end zero-force --exact
trajectory --order {order} --terms 1000
disk-modes --poisson 0.33 --count 10000000
sample --speed-min 0.01 --speed-max 10 --tolerance 1e-10 --young 7e10 --poisson 0.2 --radius 0.01 --density 2500 \
--wall --gravity 9.81 --dissipation-time 1e-6
collide --beta 0.{order} --digits 10000000
collide --beta 0.{order} --digits 20000 --elastic {exponent} --damping 23
collide --beta 0.{order} --threshold --digits 3000
disk-collide --rayleigh --modes 10000000 --speed 0.1 --poisson 0.33
disk-collide --hard-wall --speed 0.001 --poisson 0.33 --tolerance 1e-7
pade --numerator 60 --denominator {exponent}
embed --speed-min 1e-4 --speed-max 1e4 --tolerance 1e-14 --g-star 0.2
plan --disks --poisson 0.2 --speed-min 0.01 --speed-max 0.1 --tolerance 0.01 --points 50
law --elastic {exponent} --damping 1/2 --name x
contact --g-star 0.2 --speed 0.001:100:log:100000 --steps 50"""
ROWS = "disk-collide --speed 0.1:0.2:lin:9 --poisson 0.33 --alpha 1000 --modes 100 --format json"
LINE = r"\r\x1b\[K[^\r\n]+: [^\r\n]*\d s[^\r\n]*"
corgen, seed = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else str(time.time_ns())
draw = random.Random(seed)


class Terminal:
    def __init__(self, command):
        self.command, self.screen, self.times = command, "", [time.monotonic()]
        self.process, self.file = pty.fork()
        if self.process == 0:
            os.execv(corgen, [corgen, *command.split()])

    def ended(self):
        """Reads the available output."""
        self.times.append(time.monotonic())
        try:
            self.screen += os.read(self.file, 1 << 16).decode().replace("\r\n", "\n")
        except OSError:
            return True
        return False

    def stop(self):
        os.write(self.file, b"\x03")
        os.waitpid(self.process, 0)
        self.times.append(time.monotonic())


def watch(terminals, seconds):
    end = time.monotonic() + seconds
    while terminals and time.monotonic() < end:
        ready = select.select([terminal.file for terminal in terminals], [], [], 0.1)[0]
        terminals = [terminal for terminal in terminals if terminal.file not in ready or not terminal.ended()]


commands = SLOW.format(order=draw.randint(400, 999), exponent=draw.randint(12, 24)).splitlines()
with tempfile.TemporaryDirectory() as folder:
    slow = [Terminal(f"{command} --output {folder}/{number}")
            for number, command in enumerate(commands if seed == "all" else draw.sample(commands, 4))]
    rows = Terminal(ROWS)
    expected = subprocess.Popen([corgen, *ROWS.split()], stdout=subprocess.PIPE, text=True)
    watch([*slow, rows], 2 if seed != "all" else 6)
    for each in slow:
        each.stop()
    watch([rows], 20)
    left = [name for name in os.listdir(folder) if not name.endswith(".part")]
wrong = [each for each in slow if not re.search(LINE, each.screen)
         or max(b - a for a, b in zip(each.times, each.times[1:])) > SILENT]
printed = re.sub(LINE, "", rows.screen).replace("\r\x1b[K", "")
if not re.search('"speed".*' + LINE, rows.screen, re.S) or printed != expected.communicate()[0]:
    wrong.append(rows)
for each in wrong:
    print(f"corgen {each.command}: {each.screen[-1000:]!r}, {each.times}")
print(f"seed {seed}; left: {left}")
sys.exit(bool(wrong or left))
