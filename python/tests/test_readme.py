# SPDX-License-Identifier: MIT
"""The README's Python runs as it stands, where the reader's part.poly is."""
import pathlib
import re

import pytest

README = pathlib.Path(__file__).resolve().parents[2] / "README.md"
OUTLINE = "4 2 0 0\n1 0 0\n2 2 0\n3 2 1\n4 0 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 3\n4 4 1 4\n0\n"


@pytest.mark.skipif(not README.is_file(), reason="the package is tested without its sources")
def test_the_program_of_the_readme(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "part.poly").write_text(OUTLINE)
    programs = re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.S)
    assert programs
    for program in programs:
        exec(compile(program, "README.md", "exec"), {})
    assert "certified" in capsys.readouterr().out
    assert (tmp_path / "part.mesh").is_file()
