# SPDX-License-Identifier: MIT
"""python3 -m cor: the command cor."""

import sys

from ._command import main

sys.exit(main())
