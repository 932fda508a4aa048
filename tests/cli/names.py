#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""names.py CORGEN [SEED]: tests messages that contain names of random bytes. They must escape control characters and
bytes that are not UTF-8."""
import os
import random
import subprocess
import sys
import tempfile
import time
import unicodedata

INVALID = [b"\xc0\xaf", b"\xc1\xbf", b"\xe0\x9f\xbf", b"\xed\xa0\x80", b"\xf0\x8f\xbf\xbd", b"\xf4\x90\x80\x80",
           b"\xf8\x90\x80\x80"]
corgen, seed = os.path.abspath(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else str(time.time_ns())
draw = random.Random(seed)


def drawn_name():
    name = b"n"
    for _ in range(draw.randint(1, 12)):
        code = draw.choice([draw.randrange(0x100), draw.randrange(0x800), draw.randrange(0x110000), 0xFFFE, 0x7F, 0x9F, 0xA0])
        piece = chr(code).encode("utf-8", "surrogatepass")
        name += draw.choice([piece, piece[:-1], piece[1:], bytes([draw.randrange(256)]), draw.choice(INVALID)])
    return name.replace(b"/", b"").replace(b"\0", b"")


def escaped(name):
    def shown(character):
        hidden = unicodedata.category(character) in ("Cc", "Cs") or ord(character) & 0xFFFE == 0xFFFE
        return "".join(f"\\x{byte:02x}" for byte in character.encode("utf-8", "surrogateescape")) if hidden else character
    return "".join(map(shown, name.decode("utf-8", "surrogateescape")))


def run(*arguments):
    done = subprocess.run([corgen, *arguments], capture_output=True, check=False)
    return done.stdout.decode(), done.stderr.decode()


names = list({drawn_name() for _ in range(40)})
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    said = {name: run("series", "--order", "1", "--output", b"none/" + name)[1] for name in names}
    wrong = [name for name in names if f" none/{escaped(name)}: " not in said[name]]
print(f"seed {seed}; wrong: {wrong}")
sys.exit(bool(wrong))
