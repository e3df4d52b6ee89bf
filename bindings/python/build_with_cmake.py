# SPDX-License-Identifier: MIT
"""Build backend for pyproject.toml. CMake builds the engine in build/python, and a second run continues there."""
import pathlib
import shutil
import subprocess
import sys

from setuptools import Extension
from setuptools.command.build_ext import build_ext

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70
    from wheel.bdist_wheel import bdist_wheel

off = ["PROGRAM", "C", "TESTS", "EXAMPLES", "BENCH"]
on = ["PYTHON", "LEARN"]


class BdistWheel(bdist_wheel):
    def finalize_options(self):
        # pyproject.toml cannot declare this extension; without it the wheel would claim to fit every machine.
        self.distribution.ext_modules = [Extension("bankshot._engine", sources=[])]
        super().finalize_options()


class BuildExt(build_ext):
    def build_extension(self, extension):
        import pybind11

        root = pathlib.Path(__file__).resolve().parents[2]
        build = root / "build" / "python"
        options = {f"BANKSHOT_{name}": "OFF" for name in off} | {f"BANKSHOT_{name}": "ON" for name in on}
        options |= {
            "CMAKE_BUILD_TYPE": "Release",
            "Python3_EXECUTABLE": sys.executable,
            "pybind11_DIR": pybind11.get_cmake_dir(),
        }
        if shutil.which("ccache"):
            options["CMAKE_CXX_COMPILER_LAUNCHER"] = "ccache"
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        defined = [f"-D{name}={value}" for name, value in options.items()]
        subprocess.run(["cmake", "-S", root, "-B", build, *generator, *defined], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "bankshot_python", "--parallel"], check=True)
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        for engine in (build / "bindings" / "python" / "bankshot").glob("_engine.*.so"):
            shutil.copy(engine, target)
