# SPDX-License-Identifier: MIT
"""Builds the Python package: the module by CMake, from the same files as the library."""
import pathlib
import re

from skbuild import setup

FOLDER = pathlib.Path(__file__).parent
HEADER = (FOLDER / "core/version.h").read_text(encoding="utf-8")

setup(
    name="asterism",
    version=re.search(r'VERSION_TEXT "([^"]+)"', HEADER).group(1),
    description="Exact anisotropic predicates and certified triangle meshes",
    long_description=(FOLDER / "README.md").read_text(encoding="utf-8"),
    long_description_content_type="text/markdown",
    author="The Asterism authors",
    license="MIT",
    keywords=["mesh", "triangulation", "anisotropic", "Delaunay", "predicates", "adaptation"],
    classifiers=[
        "Development Status :: 4 - Beta",
        "Intended Audience :: Science/Research",
        "License :: OSI Approved :: MIT License",
        "Operating System :: POSIX :: Linux",
        "Programming Language :: C++",
        "Programming Language :: Python :: 3",
        "Topic :: Scientific/Engineering :: Mathematics",
        "Typing :: Typed",
    ],
    python_requires=">=3.9",
    install_requires=["numpy"],
    package_dir={"": "python"},
    packages=["asterism"],
    package_data={"asterism": ["py.typed", "*.pyi"]},
    cmake_install_dir="python/asterism",
    cmake_args=["-DASTERISM_BUILD_PYTHON=ON", "-DASTERISM_BUILD_APPS=OFF",
                "-DASTERISM_BUILD_TESTS=OFF", "-DASTERISM_INSTALL=OFF", "-DBUILD_SHARED_LIBS=OFF"],
)
