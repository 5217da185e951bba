# SPDX-License-Identifier: MIT
"""Builds the Python package: the module by CMake, from the same files as the library."""
import pathlib
import re

from skbuild import setup

HEADER = (pathlib.Path(__file__).parent / "core/version.h").read_text(encoding="utf-8")

setup(
    name="asterism",
    version=re.search(r'VERSION_TEXT "([^"]+)"', HEADER).group(1),
    description="Exact anisotropic predicates and certified triangle meshes",
    license="MIT",
    python_requires=">=3.9",
    install_requires=["numpy"],
    package_dir={"": "python"},
    packages=["asterism"],
    package_data={"asterism": ["py.typed", "*.pyi"]},
    cmake_install_dir="python/asterism",
    cmake_args=["-DASTERISM_BUILD_PYTHON=ON", "-DASTERISM_BUILD_APPS=OFF",
                "-DASTERISM_BUILD_TESTS=OFF", "-DASTERISM_INSTALL=OFF", "-DBUILD_SHARED_LIBS=OFF"],
)
