# SPDX-License-Identifier: MIT
"""allocation_forms.py PROGRAM: every form of operator new and delete of the C++ standard that can be replaced is
defined in the program. A block of a form from elsewhere may be given to one of ours, as std::stable_sort does."""
import subprocess
import sys

SIZE, NO_THROW, ALIGNED = "unsigned long", "std::nothrow_t const&", "std::align_val_t"
NEW = [(SIZE,), (SIZE, NO_THROW), (SIZE, ALIGNED), (SIZE, ALIGNED, NO_THROW)]
DELETE = [("void*",), ("void*", SIZE), ("void*", NO_THROW), ("void*", ALIGNED), ("void*", SIZE, ALIGNED),
          ("void*", ALIGNED, NO_THROW)]


def main():
    forms = {f"operator {name}{array}({', '.join(arguments)})"
             for name, all_arguments in (("new", NEW), ("delete", DELETE)) for arguments in all_arguments
             for array in ("", "[]")}
    table = subprocess.run(["nm", "-C", "--defined-only", sys.argv[1]], check=True, text=True, capture_output=True)
    defined = {line.split(" ", 2)[2] for line in table.stdout.splitlines() if " T " in line}
    missing = sorted(forms - defined)
    for form in missing:
        print(f"not the program's own: {form}")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
