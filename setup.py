# SPDX-License-Identifier: MIT
"""Builds the package on Debian's own packages, without network; python/build_backend chooses between
this and scikit-build-core. What the package is called and needs is in pyproject.toml."""
import pathlib
import re

from skbuild import setup

FOLDER = pathlib.Path(__file__).parent
HEADER = (FOLDER / "core/version.h").read_text(encoding="utf-8")

setup(
    name="asterism",
    version=re.search(r'VERSION_TEXT "([^"]+)"', HEADER).group(1),
    package_dir={"": "python"},
    packages=["asterism"],
    package_data={"asterism": ["py.typed", "*.pyi"]},
    cmake_install_dir="python/asterism",
    cmake_args=["-DASTERISM_BUILD_PYTHON=ON", "-DASTERISM_UNITY=ON", "-DASTERISM_BUILD_APPS=OFF",
                "-DASTERISM_BUILD_TESTS=OFF", "-DASTERISM_INSTALL=OFF", "-DBUILD_SHARED_LIBS=OFF"],
)
