# SPDX-License-Identifier: MIT
"""The list of symbols of the Debian package, debian/libcor0.symbols.

    python3 python/bindings/debian_symbols.py [--check]        adds new symbols with the version of the headers, or
                                                               fails if some are missing

A symbol that is in the list and not in the headers is an error: COR_ABI of CMakeLists.txt has to grow.
"""

import re
import sys
from pathlib import Path

if __package__ in (None, ""):
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from bindings.declarations import Declarations  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
LIST = ROOT / "debian" / "libcor0.symbols"


def main() -> int:
    if sys.argv[1:] not in ([], ["--check"]):
        print(__doc__, file=sys.stderr)
        return 2
    declared = Declarations(ROOT / "include" / "cor")
    public = set(declared.functions) | set(declared.objects)
    lines = LIST.read_text(encoding="utf-8").splitlines()
    head = [line for line in lines if not line.startswith(" ")]
    listed = dict(re.findall(r"^ (cor_\w+)@Base (\S+)$", "\n".join(lines), re.M))
    gone = sorted(set(listed) - public)
    if gone:
        print(f"no longer in the headers, so COR_ABI has to grow: {', '.join(gone)}")
        return 1
    new = sorted(public - set(listed))
    if new and sys.argv[1:]:
        print(f"run python3 python/bindings/debian_symbols.py to list {', '.join(new)}")
        return 1
    version = declared.constants["COR_VERSION_STRING"].text.strip('"')
    rows = [f" {name}@Base {listed.get(name, version)}" for name in sorted(public)]
    LIST.write_text("\n".join(head + rows) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
