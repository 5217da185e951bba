# SPDX-License-Identifier: MIT
"""Each folder includes only folders before it in LAYERS; and what certifies, writes or draws a mesh
reaches, through any chain of includes, nothing of what makes one."""
import sources

# The auditor must not share code with what it judges.
MAKING = ("mesh/star", "mesh/consistency", "mesh/refine", "mesh/boundary", "mesh/constructions",
          "mesh/visibility", "mesh/mesher", "mesh/corner", "mesh/candidate")
JUDGING = ("mesh/audit", "mesh/certificate", "mesh/io/", "mesh/draw/")


def project_includes(top, path):
    """Paths relative to `top`; a name without asterism/ is looked up beside the including file."""
    for name in sources.includes(top / path):
        if name.startswith("asterism/"):
            yield name.removeprefix("asterism/")
        elif (top / path.parent / name).is_file():
            yield (path.parent / name).as_posix()


def layer_problems(top, path):
    own = sources.LAYERS.index(path.parts[0])
    for name in project_includes(top, path):
        layer = name.split("/")[0]
        if not (top / name).is_file():
            yield f"{path}: includes {name}, which does not exist"
        elif layer not in sources.LAYERS or sources.LAYERS.index(layer) > own:
            yield f"{path}: {path.parts[0]}/ must not include {name}"


def reached_problems(top, path):
    seen, waiting = {}, [(path, str(path))]
    while waiting:
        current, chain = waiting.pop()
        for name in project_includes(top, current):
            if name in seen or not (top / name).is_file():
                continue
            seen[name] = f"{chain} -> {name}"
            if name.startswith(MAKING):
                yield f"{path}: must not know how meshes are made: {seen[name]}"
            waiting.append((type(path)(name), seen[name]))


def main():
    top = sources.root()
    paths = sources.files(top, sources.LAYERS, sources.CODE)
    problems = [p for path in paths for p in layer_problems(top, path)]
    judging = [p for p in paths if p.as_posix().startswith(JUDGING)]
    problems += [p for path in judging for p in reached_problems(top, path)]
    sources.finish(problems, len(paths))


if __name__ == "__main__":
    main()
