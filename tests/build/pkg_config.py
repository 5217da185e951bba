# SPDX-License-Identifier: MIT
"""Installs the build tree, moves it, and compiles a C program with the flags of pkg-config, once
against the shared and once against the static library; and folders that were named from the root on
are in the files for pkg-config as they were named, as is clang's own standard library.  pkg_config.py BUILD SOURCE WORK CC"""
import os
import pathlib
import shutil
import subprocess
import sys


def run(*command, **options):
    return subprocess.run([str(c) for c in command], check=True, text=True,
                          stdout=subprocess.PIPE, **options).stdout


def install(build, work):
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    run("cmake", "--install", build, "--prefix", work / "first")
    (work / "first").rename(work / "moved")
    return work / "moved"


def flags(prefix, package, *options):
    folder = next(prefix.rglob("pkgconfig"))
    environment = dict(os.environ, PKG_CONFIG_PATH=str(folder))
    return run("pkg-config", *options, package, env=environment).split()


def configured(source, folder, *options):
    """Returns the lines of the predicates' file for pkg-config, as a configuration with these options writes it."""
    run("cmake", "-G", "Ninja", "-S", source, "-B", folder, "-DASTERISM_BUILD_MESHER=OFF", "-DASTERISM_BUILD_TESTS=OFF", *options)
    return (folder / "asterism-predicates.pc").read_text(encoding="utf-8").splitlines()


def check_folders_from_the_root(source, work):
    lines = configured(source, work / "rooted", "-DCMAKE_INSTALL_LIBDIR=/elsewhere/lib", "-DCMAKE_INSTALL_INCLUDEDIR=/headers")
    assert "libdir=/elsewhere/lib" in lines and "includedir=/headers" in lines, lines


def check_standard_library(source, work):
    if shutil.which("clang++") is None or not list(pathlib.Path("/usr/lib").glob("llvm-*/include/c++/v1")):
        print("not asked: clang with its own standard library is not there")
        return
    lines = configured(source, work / "clang", "-DCMAKE_CXX_COMPILER=clang++", "-DCMAKE_CXX_FLAGS=-stdlib=libc++")
    assert any("-lc++" in line for line in lines) and not any("-lstdc++" in line for line in lines), lines


def main():
    build, source, work = (pathlib.Path(a) for a in sys.argv[1:4])
    compiler = [sys.argv[4], "-std=c89", "-pedantic", "-Wall", "-Wextra", "-Werror"]
    prefix = install(build, work)
    package = "asterism-predicates"
    cflags = flags(prefix, package, "--cflags")
    program = source / "tests/abuse/c_api_test.c"

    libraries = flags(prefix, package, "--libs")
    folder = next(f[2:] for f in libraries if f.startswith("-L"))
    run(*compiler, *cflags, program, "-o", work / "shared", *libraries, f"-Wl,-rpath,{folder}")
    run(work / "shared")
    needed = run("readelf", "-d", work / "shared")
    assert "libasterism_predicates.so.0" in needed and "libstdc++" not in needed, needed

    libraries = ["-l:libasterism_predicates.a" if f == "-lasterism_predicates" else f
                 for f in flags(prefix, package, "--libs", "--static")]
    run(*compiler, *cflags, program, "-o", work / "static", *libraries)
    run(work / "static")
    assert "libasterism" not in run("readelf", "-d", work / "static")

    check_folders_from_the_root(source, work)
    check_standard_library(source, work)
    return 0


if __name__ == "__main__":
    sys.exit(main())
