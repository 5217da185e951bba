# SPDX-License-Identifier: MIT
"""Real certificates have all fields of docs/manual/certificate.schema.json and no others, and the manual page is the
one that the schema gives."""
import json
import pathlib
import subprocess
import sys
import unittest

import command

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCHEMA = json.loads((ROOT / "docs/manual/certificate.schema.json").read_text(encoding="utf-8"))
TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "integer": int, "number": (int, float),
         "null": type(None)}


def faults(value, schema, path="certificate"):
    """Yields what differs from the schema. Handles the part of JSON Schema that this schema uses."""
    names = schema["type"] if isinstance(schema["type"], list) else [schema["type"]]
    if not any(isinstance(value, TYPES[n]) and (n == "boolean" or not isinstance(value, bool)) for n in names):
        yield f"{path}: {value!r} is none of {names}"
        return
    if "enum" in schema and value not in schema["enum"] or "const" in schema and value != schema["const"]:
        yield f"{path}: {value!r}"
    if isinstance(value, dict):
        yield from (f"{path}.{name} is missing" for name in schema.get("required", []) if name not in value)
        known, others = schema.get("properties", {}), schema.get("additionalProperties", True)
        for name, inner in value.items():
            if name in known or isinstance(others, dict):
                yield from faults(inner, known.get(name, others), f"{path}.{name}")
            elif not others:
                yield f"{path}.{name} is not in the schema"
    elif isinstance(value, list):
        for i, item in enumerate(value):
            yield from faults(item, schema["items"], f"{path}[{i}]")
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        if not schema.get("minimum", value) <= value <= schema.get("maximum", value):
            yield f"{path}: {value} is out of range"


# Fields of some certificates only: of meshes in pieces, of metrics placed in another box than the domain's, and of
# runs that asked for a guarantee or for no edge across.
NOT_IN_ALL = {"piece", "piece-question", "metric-box", "guarantee", "split-across"}


class Certificates(command.CommandTest):
    def check(self, name, complete_options=True):
        written = json.loads((self.folder / name).read_text())
        self.assertEqual(list(faults(written, SCHEMA)), [])
        listed = SCHEMA["properties"]["asked"]["properties"]["options"]["properties"]
        if complete_options:
            self.assertEqual(set(written["asked"]["options"]), set(listed) - NOT_IN_ALL)
            self.assertLessEqual(set(written["measured"]), set(SCHEMA["properties"]["measured"]["properties"]))
        try:
            import jsonschema
            jsonschema.Draft202012Validator(SCHEMA).validate(written)
        except ImportError:
            pass

    def test_certificates_of_all_kinds_are_as_the_schema_says(self):
        runs = {"certified": ["square", "--metric", "swirl:3", "--size", "0.5"],
                "sharp": ["wedge.poly"],
                "incomplete": ["square", "--size", "0.01", "--max-sites", "300"],
                "last_resort": ["square", "--metric", "swirl:60", "--random-points", "5", "--max-seconds", "20"],
                "delivered": ["square", "--metric", "polar-1", "--size", "3"],
                "curved": ["disc.poly", "--size", "0.5"],
                "cubic": ["lens.poly", "--size", "0.5"],
                "repaired": ["cross.poly", "--repair-domain", "--regions"],
                "voronoi": ["square", "--certify", "voronoi", "--size", "0.7"]}
        self.write("wedge.poly", (pathlib.Path(__file__).with_name("wedge.poly")).read_text())
        self.write("cross.poly", "4 2 0 0\n1 0 0\n2 4 0\n3 0 3\n4 4 3.5\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n")
        self.write("disc.poly", "1 2\n1 1 0\n0\n0\n0\ncurves 1\n1 circle 1 0 0\n")
        self.write("lens.poly", "2 2\n1 0 0\n2 1 0\n2\n1 1 2\n2 2 1\n0\n0\ncurves 2\n"
                   "1 bezier 1 0.3 -0.5 0.7 -0.5\n2 bezier 2 0.7 0.5 0.3 0.5\n")
        for name, arguments in runs.items():
            with self.subTest(name):
                done = self.run_command("mesh", *arguments, "-o", f"{name}.mesh")
                self.assertIn(done.returncode, (0, 1), done.stderr)
                self.check(f"{name}.certificate.json")
        self.run_command("certify", "certified.mesh", "-o", "again.mesh")
        self.check("again.certificate.json", complete_options=False)

    def test_the_page_is_the_schemas(self):
        done = subprocess.run([sys.executable, ROOT / "scripts/make-certificate-page", "--check"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
