# SPDX-License-Identifier: MIT
"""The corpus is the text whose hash is kept, and the library answers all of it rightly.
corpus.py ASTERISM SOURCE WORK"""
import hashlib
import lzma
import pathlib
import subprocess
import sys


def main():
    program, source, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    folder = source / "examples/challenge"
    text = lzma.decompress((folder / "corpus.txt.xz").read_bytes())
    if hashlib.sha256(text).hexdigest() != (folder / "corpus.sha256").read_text().split()[0]:
        sys.exit("corpus.txt.xz does not hold the text of corpus.sha256")
    work.mkdir(parents=True, exist_ok=True)
    (work / "corpus.txt").write_bytes(text)
    done = subprocess.run([program, "challenge", "--classes", work / "corpus.txt", "--timeout", "120",
                           program, "eval"], capture_output=True, text=True, check=False)
    print(done.stdout, done.stderr)
    sys.exit(done.returncode)


if __name__ == "__main__":
    main()
