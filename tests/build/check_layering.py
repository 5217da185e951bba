# SPDX-License-Identifier: MIT
"""Each folder includes only itself and folders before it in sources.LAYERS; and the auditor only its
whitelist, through any chain of includes: it must not share code with what it judges."""
import sources

COMMON = ("core", "predicates", "kernels", "mesh/support", "mesh/data")
# Folders whose headers each auditor may include: the auditor of plane meshes, and that of surfaces.
AUDITORS = {"mesh/audit": COMMON + ("mesh/audit",),
            "mesh/surface_audit": COMMON + ("mesh/audit", "mesh/surface_audit")}


def project_includes(top, path):
    """Maps the name in an include to a path relative to `top`. A name without asterism/ is looked up beside the
    including file."""
    for name in sources.includes(top / path):
        if name.startswith("asterism/"):
            yield name.removeprefix("asterism/")
        elif (top / path.parent / name).is_file():
            yield (path.parent / name).as_posix()


def folder_of(name):
    return name.rsplit("/", 1)[0]


def layer_problems(top, path):
    own = folder_of(path.as_posix())
    if own not in sources.LAYERS:
        yield f"{path}: the folder {own} is not in the list of layers"
        return
    for name in project_includes(top, path):
        layer = folder_of(name)
        if not (top / name).is_file():
            yield f"{path}: includes {name}, which does not exist"
        elif layer not in sources.LAYERS or sources.LAYERS.index(layer) > sources.LAYERS.index(own):
            yield f"{path}: {own}/ must not include {name}"


def reached_problems(top, path, may_use):
    seen, waiting = {}, [(path, str(path))]
    while waiting:
        current, chain = waiting.pop()
        for name in project_includes(top, current):
            if name in seen or not (top / name).is_file():
                continue
            seen[name] = f"{chain} -> {name}"
            if folder_of(name) not in may_use:
                yield f"{path}: the auditor may not use {seen[name]}"
            waiting.append((type(path)(name), seen[name]))


def main():
    top = sources.root()
    paths = sources.files(top, sources.FOLDERS, sources.CODE)
    problems = [p for path in paths for p in layer_problems(top, path)]
    for folder, may_use in AUDITORS.items():
        auditor = [p for p in paths if folder_of(p.as_posix()) == folder]
        problems += [p for path in auditor for p in reached_problems(top, path, may_use)]
        if not auditor:
            problems.append(f"no file in {folder}")
    sources.finish(problems, len(paths))


if __name__ == "__main__":
    main()
