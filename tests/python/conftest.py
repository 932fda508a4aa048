# SPDX-License-Identifier: MIT
"""Provides the C compiler, with which tests use the headers and the library without the package.

COR_TEST_PREFIX names the prefix of an installed static cor.
"""

import os
import subprocess
from pathlib import Path

import pytest

import cor

PREFIX = Path(os.environ["COR_TEST_PREFIX"])


MODULES = (cor.contact, cor.disk, cor.law, cor.sphere, cor.status, cor.version)


def module_of(c_name):
    """Returns the module with a function of C, and the function's name there. Searches only by names."""
    for module in MODULES:
        for prefix in (f"cor_{module.__name__.split('.')[1]}_", "cor_"):
            if c_name.startswith(prefix) and c_name[len(prefix) :] in module.__all__:
                return module, c_name[len(prefix) :]
    raise AssertionError(f"{c_name} is not in the package")


class Compiler:
    def __init__(self, folder):
        self.folder = folder
        self.count = 0

    def preprocessed(self):
        """Returns all public headers with expanded macros."""
        command = ["cc", "-E", "-P", "-DCOR_WITH_DISK", f"-I{PREFIX}/include", "-x", "c", "-"]
        run = subprocess.run(command, input="#include <cor/cor.h>\n", stdout=subprocess.PIPE, text=True, check=True)
        return " ".join(run.stdout.split())

    def program(self, text):
        """Returns the path of a compiled program."""
        self.count += 1
        path = self.folder / f"program_{self.count}"
        libraries = [str(next(PREFIX.glob(f"lib*/**/{name}.a"))) for name in ("libcor", "libcor_disk")]
        flags = ["-std=c99", "-DCOR_WITH_DISK", f"-I{PREFIX}/include", *"-x c - -x none".split(), *libraries, "-lm"]
        subprocess.run(["cc", *flags, "-o", str(path)], input=text, text=True, check=True)
        return path


@pytest.fixture(scope="session")
def compiler(tmp_path_factory):
    return Compiler(tmp_path_factory.mktemp("programs"))
