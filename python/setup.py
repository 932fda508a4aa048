# SPDX-License-Identifier: MIT
"""Builds the package cor: Python modules and a C module, both written from the headers of cor.

The library is compiled into the package from ../runtime, with the flags of cmake/CorArraySets.cmake. A source
distribution has the necessary files in library/. With COR_PYTHON_LIBRARY=installed in the environment, the package is
linked with the installed library that pkg-config finds, and written from its headers.
"""

import os
import platform
import re
import shlex
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Dict, List, Tuple

from cffi import FFI
from setuptools import Extension, find_packages, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist

HERE = Path(__file__).resolve().parent
ROOT = HERE / "library" if (HERE / "library").is_dir() else HERE.parent
sys.path.insert(0, str(HERE))

from bindings import cffi_source, python_source  # noqa: E402
from bindings.declarations import Declarations  # noqa: E402

PLAIN_FLAGS = ["-O2", "-DNDEBUG", "-DCOR_ROWS_SHARED", "-std=c99", "-fvisibility=hidden"]  # of cmake/CorDefaults.cmake
PLAIN_FLAGS += ["-ffp-contract=off"] + ["-fexcess-precision=fast"] * (platform.machine() == "s390x")


def pkg_config(*arguments: str) -> List[str]:
    command = [os.environ.get("PKG_CONFIG", "pkg-config"), *arguments, "cor-scene", "cor-disk", "cor"]
    return shlex.split(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)


def choose_library() -> Tuple[bool, Path]:
    """Returns True if the library is compiled in, and the folder that has cor/cor.h."""
    choice = os.environ.get("COR_PYTHON_LIBRARY", "bundled")
    if choice == "bundled":
        return True, ROOT / "include"
    if choice == "installed":
        return False, Path(pkg_config("--variable=includedir")[0])
    sys.exit(f"COR_PYTHON_LIBRARY={choice}: allowed are bundled and installed")


BUNDLED, INCLUDE = choose_library()
DECLARED = Declarations(INCLUDE / "cor")


def cmake_list(name: str, file: str = "CorArraySets.cmake") -> List[str]:
    """Returns the words of set(<name> ...) in a file of cmake/. Of $<IF:...> it uses the second choice."""
    text = (ROOT / "cmake" / file).read_text(encoding="utf-8")
    found = re.search(rf"^\s*set\({name} (.*)\)$", text, re.M)
    if not found:
        sys.exit(f"cmake/{file}: no set({name} ...)")
    return re.sub(r"\$<IF:\$<[^>]*>,[^,]*,([^>]*)>", r"\1", found[1]).split()


def library_parts() -> List[Tuple[str, str, List[str]]]:
    """Returns the library's sources, each with a folder for its object and its flags. A kernel occurs once for each
    instruction set."""
    x86 = platform.machine() in ("x86_64", "AMD64", "amd64")
    plain = PLAIN_FLAGS + [f"-Werror={what}" for what in cmake_list("cor_errors", "CorDefaults.cmake")]
    plain += ["-DCOR_X86_SETS"] if x86 else []
    kernel = plain + cmake_list("cor_array_options")
    parts = []
    for path in sorted((ROOT / "runtime").glob("*/*.c")):
        if not path.stem.endswith("_kernel"):
            parts.append((str(path), "plain", plain))
            continue
        parts.append((str(path), "portable", kernel))
        for instruction_set in ("avx2", "avx512") if x86 else ():
            flags = [f"-DCOR_SET={instruction_set}", *cmake_list(instruction_set)]
            parts.append((str(path), instruction_set, kernel + flags))
    return parts


class BuildModules(build_py):
    """Writes the generated modules next to the others."""

    def run(self) -> None:
        super().run()
        folder = Path(self.build_lib) / "cor"
        folder.mkdir(parents=True, exist_ok=True)
        texts: Dict[str, str] = python_source.modules(DECLARED)
        texts["_docs"] = python_source.docs(DECLARED)
        for name, text in texts.items():
            (folder / f"{name}.py").write_text(text, encoding="utf-8")


class BuildLibrary(build_ext):
    """Compiles each source of the library with its flags, and links the objects into the C module."""

    def build_extension(self, ext: Extension) -> None:
        temp = Path(self.build_temp)
        temp.mkdir(parents=True, exist_ok=True)
        ffi = FFI()
        ffi.cdef(cffi_source.declarations(DECLARED) + cffi_source.scene_declarations(INCLUDE / "cor"))
        ffi.set_source("cor._cor", cffi_source.source(DECLARED))
        ffi.emit_c_code(str(temp / "_cor.c"))
        ext.sources = [str(temp / "_cor.c")]
        if BUNDLED:
            with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
                for objects in pool.map(self.compile_source, *zip(*library_parts())):
                    ext.extra_objects += objects
        super().build_extension(ext)

    def compile_source(self, source: str, folder: str, flags: List[str]) -> List[str]:
        objects: List[str] = self.compiler.compile(
            [source],
            output_dir=os.path.join(self.build_temp, folder),
            include_dirs=[str(INCLUDE), str(ROOT)],
            extra_postargs=flags,
        )
        return objects


class SourceDistribution(sdist):
    """Adds the generators of the modules and the library's sources."""

    def make_release_tree(self, base_dir: str, files: List[str]) -> None:
        super().make_release_tree(base_dir, files)
        ignore = shutil.ignore_patterns("__pycache__")
        shutil.copytree(HERE / "bindings", Path(base_dir) / "bindings", ignore=ignore)
        for folder in ("runtime", "include", "generated", "cmake"):
            shutil.copytree(ROOT / folder, Path(base_dir) / "library" / folder)
        shutil.copy(ROOT / "LICENSE", base_dir)


EXTENSION = Extension(
    "cor._cor",
    [],  # build_extension writes and adds _cor.c
    include_dirs=[str(INCLUDE)],
    libraries=["m"],
    extra_compile_args=[] if BUNDLED else pkg_config("--cflags"),
    extra_link_args=[] if BUNDLED else pkg_config("--libs"),
)

# Build files are in a folder that git ignores.
BUILD = ROOT / "build" / "python" if (ROOT / "runtime").is_dir() else HERE / "build"
BUILD.mkdir(parents=True, exist_ok=True)

setup(
    version=DECLARED.constants["COR_VERSION_STRING"].text.strip('"'),
    packages=find_packages(include=["cor", "cor.*"]),
    package_data={"cor": ["py.typed", "*.pyi"]},
    ext_modules=[EXTENSION],
    cmdclass={"build_py": BuildModules, "build_ext": BuildLibrary, "sdist": SourceDistribution},
    options={"build": {"build_base": str(BUILD)}, "egg_info": {"egg_base": str(BUILD)}},
)
