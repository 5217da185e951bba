# SPDX-License-Identifier: MIT
"""Puts the shared libraries that a wheel needs into it: bundle_libraries.py WHEEL FOLDER

Each gets a name of its own, so that no other copy in the process is taken for it, and is found
beside the module. Not inside: what every Linux with a C library of this age or newer has (_EVERYWHERE).
The wheel is named by that age, manylinux_X_Y. asterism.libs/licences has the copyright files of those libraries, and
of those that are compiled in, with the whole text of each licence that they name. Needs Debian, for these, and
patchelf, readelf and ldd.
"""
from __future__ import annotations

import base64
import hashlib
import pathlib
import re
import shutil
import stat
import subprocess
import sys
import tempfile
import zipfile

# Libraries that PEP 600 leaves to the system.
_EVERYWHERE = re.compile(r"^(linux-vdso|ld-linux.*|lib(c|m|dl|rt|pthread|util|gcc_s|stdc\+\+))\.so(\.\d+)*$")
# Libraries of headers, which leave code in the module: one header of each, as the compiler finds it
# (tests/build/check_take_along.py compares with the sources' includes).
COMPILED_IN = {"boost": "/usr/include/boost/version.hpp", "nlohmann-json": "/usr/include/nlohmann/json.hpp",
               "pybind11": "/usr/include/pybind11/pybind11.h"}
_COMMON_LICENCES = pathlib.Path("/usr/share/common-licenses")


def run(*words: str) -> str:
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def needed_by(file: pathlib.Path) -> dict[str, pathlib.Path]:
    """Returns, by name, the libraries that a file is linked with, directly or not."""
    found = dict(re.findall(r"^\s*(\S+) => (/\S+)", run("ldd", str(file)), re.MULTILINE))
    return {name: pathlib.Path(path).resolve() for name, path in found.items() if not _EVERYWHERE.match(name)}


def direct_names(file: pathlib.Path) -> list[str]:
    return run("patchelf", "--print-needed", str(file)).split()


def own_name(name: str, path: pathlib.Path) -> str:
    stem, ending = name.split(".so", 1)
    return f"{stem}-{hashlib.sha256(path.read_bytes()).hexdigest()[:8]}.so{ending}"


def licence_of(path: pathlib.Path) -> pathlib.Path:
    """Returns the copyright file of the Debian package to which a file belongs."""
    for spelling in (path, pathlib.Path(str(path).replace("/usr/lib/", "/lib/", 1))):
        owner = subprocess.run(["dpkg", "-S", str(spelling)], capture_output=True, text=True, check=False).stdout
        text = pathlib.Path("/usr/share/doc") / owner.split(":")[0] / "copyright"
        if owner and text.exists():
            return text
    raise SystemExit(f"{path}: no copyright file of its package is found, and it cannot be passed on without")


def named_licences(text: str) -> set[str]:
    """Returns the licences whose text a copyright file leaves to Debian's common folder, which other systems have not."""
    names = set(re.findall(rf"{_COMMON_LICENCES}/([\w.+-]*\w)", text))
    return names | {"GPL-3"} if {"LGPL", "LGPL-3"} & names else names  # LGPL 3 only adds terms to GPL 3


def write_licences(libraries: dict[str, pathlib.Path], folder: pathlib.Path) -> None:
    """Writes NAME.txt for each library, and each licence that one of them names."""
    folder.mkdir(parents=True)
    named: set[str] = set()
    for name, path in libraries.items():
        text = licence_of(path).read_text(encoding="utf-8")
        (folder / f"{name}.txt").write_text(text, encoding="utf-8")
        named |= named_licences(text)
    for name in named:
        shutil.copyfile(_COMMON_LICENCES / name, folder / name)


def bundle(tree: pathlib.Path) -> list[pathlib.Path]:
    """Copies the libraries that the tree's modules need into asterism.libs, and makes the modules search there."""
    modules = sorted(tree.glob("asterism/*.so"))
    libraries = {name: path for module in modules for name, path in needed_by(module).items()}
    inside = tree / "asterism.libs"
    write_licences({**{name.split(".so")[0]: path for name, path in libraries.items()},
                    **{name: pathlib.Path(header) for name, header in COMPILED_IN.items()}}, inside / "licences")
    names = {name: own_name(name, path) for name, path in libraries.items()}
    copies = []
    for name, path in libraries.items():
        copy = inside / names[name]
        shutil.copy(path, copy)
        copy.chmod(0o755)
        run("patchelf", "--set-soname", copy.name, "--set-rpath", "$ORIGIN", str(copy))
        copies.append(copy)
    for module in modules:
        run("patchelf", "--set-rpath", "$ORIGIN/../asterism.libs", str(module))
    for file in [*modules, *copies]:
        for name in direct_names(file):
            if name in names:
                run("patchelf", "--replace-needed", name, names[name], str(file))
    return [*modules, *copies]


def age_of(files: list[pathlib.Path]) -> tuple[int, int]:
    """Returns the newest version of the C library that any of the files requires."""
    versions = [tuple(map(int, found)) for file in files
                for found in re.findall(r"Name: GLIBC_(\d+)\.(\d+)", run("readelf", "-V", str(file)))]
    return max(versions)  # type: ignore[return-value]


def entry_of(path: pathlib.Path, tree: pathlib.Path) -> zipfile.ZipInfo:
    """Returns the head of a file's entry. All have one date, so that two builds of the same sources are equal."""
    entry = zipfile.ZipInfo(path.relative_to(tree).as_posix(), date_time=(1980, 1, 1, 0, 0, 0))
    entry.external_attr = (stat.S_IFREG | (0o755 if ".so" in path.name else 0o644)) << 16
    entry.compress_type = zipfile.ZIP_DEFLATED
    return entry


def write_wheel(tree: pathlib.Path, wheel: pathlib.Path) -> None:
    info = next(tree.glob("*.dist-info"))
    record = info / "RECORD"
    rows = []
    files = sorted(path for path in tree.rglob("*") if path.is_file() and path != record)
    for path in files:
        digest = base64.urlsafe_b64encode(hashlib.sha256(path.read_bytes()).digest()).rstrip(b"=").decode()
        rows.append(f"{path.relative_to(tree).as_posix()},sha256={digest},{path.stat().st_size}\n")
    record.write_text("".join(rows) + f"{record.relative_to(tree).as_posix()},,\n", encoding="utf-8")
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in [*files, record]:
            archive.writestr(entry_of(path, tree), path.read_bytes())


def main(plain: pathlib.Path, folder: pathlib.Path) -> None:
    with tempfile.TemporaryDirectory() as place:
        tree = pathlib.Path(place)
        with zipfile.ZipFile(plain) as archive:
            archive.extractall(tree)
        files = bundle(tree)
        platform = "manylinux_{}_{}_{}".format(*age_of(files), run("uname", "-m").strip())
        note = next(tree.glob("*.dist-info/WHEEL"))
        note.write_text(re.sub(r"(?m)^(Tag: .*-)linux_\S+$", rf"\1{platform}", note.read_text(encoding="utf-8")),
                        encoding="utf-8")
        folder.mkdir(parents=True, exist_ok=True)
        wheel = folder / re.sub(r"linux_[^-]+\.whl$", f"{platform}.whl", plain.name)
        write_wheel(tree, wheel)
        print(f"{wheel}: {wheel.stat().st_size / 1e6:.1f} MB, with "
              + ", ".join(sorted(path.name for path in files if path.parent.name == "asterism.libs")))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
