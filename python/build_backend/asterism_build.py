# SPDX-License-Identifier: MIT
"""Builds the package for pip: by scikit-build-core, which pip fetches, or, without network and
build isolation, by Debian's setuptools and scikit-build (setup.py)."""
from __future__ import annotations

import importlib.util
import re
import shutil
import subprocess
from typing import Any, List

_CMAKE = (3, 25)


def _has(module: str) -> bool:
    return importlib.util.find_spec(module) is not None


def _backend() -> Any:
    if _has("scikit_build_core"):
        import scikit_build_core.build as backend
    elif _has("skbuild"):
        import setuptools.build_meta as backend
    else:
        raise RuntimeError("asterism is built by scikit-build-core, or by scikit-build with setuptools, and "
                           "neither is installed; pip without --no-build-isolation fetches the first")
    return backend


def _has_cmake() -> bool:
    program = shutil.which("cmake")
    if program is None:
        return False
    said = subprocess.run([program, "--version"], capture_output=True, text=True, check=False).stdout
    version = re.search(r"(\d+)\.(\d+)", said)
    return version is not None and (int(version.group(1)), int(version.group(2))) >= _CMAKE


def get_requires_for_build_wheel(config_settings: Any = None) -> List[str]:
    needed = ["scikit-build-core>=0.10", "pybind11>=2.10"]
    if not _has_cmake():
        needed.append("cmake>=3.25")
    if shutil.which("ninja") is None:
        needed.append("ninja")
    return needed


def get_requires_for_build_editable(config_settings: Any = None) -> List[str]:
    return get_requires_for_build_wheel(config_settings)


def get_requires_for_build_sdist(config_settings: Any = None) -> List[str]:
    return ["scikit-build-core>=0.10"]


def prepare_metadata_for_build_wheel(metadata_directory: str, config_settings: Any = None) -> Any:
    return _backend().prepare_metadata_for_build_wheel(metadata_directory, config_settings)


def build_wheel(wheel_directory: str, config_settings: Any = None, metadata_directory: Any = None) -> Any:
    return _backend().build_wheel(wheel_directory, config_settings, metadata_directory)


def build_editable(wheel_directory: str, config_settings: Any = None, metadata_directory: Any = None) -> Any:
    return _backend().build_editable(wheel_directory, config_settings, metadata_directory)


def build_sdist(sdist_directory: str, config_settings: Any = None) -> Any:
    return _backend().build_sdist(sdist_directory, config_settings)
