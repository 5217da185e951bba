# SPDX-License-Identifier: MIT
"""Lists the files that a compiler opens for a source, and those of them that belong to the
standard library: the files it opens for all standard headers together. Another library's header
lies in the same folders and not among them."""
import pathlib
import subprocess

CXX = """algorithm any array atomic barrier bit bitset cassert cctype cerrno cfenv cfloat charconv
chrono cinttypes ciso646 climits clocale cmath codecvt compare complex concepts condition_variable
coroutine csetjmp csignal cstdarg cstddef cstdint cstdio cstdlib cstring ctime cuchar cwchar cwctype
deque exception filesystem format forward_list fstream functional future initializer_list iomanip
ios iosfwd iostream istream iterator latch limits list locale map memory memory_resource mutex new
numbers numeric optional ostream queue random ranges ratio regex scoped_allocator semaphore set
shared_mutex source_location span sstream stack stdexcept stop_token streambuf string string_view
strstream syncstream system_error thread tuple type_traits typeindex typeinfo unordered_map
unordered_set utility valarray variant vector version""".split()
C = """assert.h complex.h ctype.h errno.h fenv.h float.h inttypes.h iso646.h limits.h locale.h math.h
setjmp.h signal.h stdalign.h stdarg.h stdbool.h stddef.h stdint.h stdio.h stdlib.h string.h tgmath.h
time.h wchar.h wctype.h""".split()
INTRINSICS = ["emmintrin.h", "xmmintrin.h"]


class Compiler:
    def __init__(self, command, is_c=False):
        self.command, self.is_c = command, is_c

    def dependencies(self, unit, options, compiles=True):
        """Returns the files opened to compile `unit`, or the compiler's error messages. Without `compiles` the unit is
        preprocessed alone, which opens the same files in a fraction of the time."""
        standard = "-std=c11" if self.is_c else "-std=c++20"
        listing = unit.with_suffix(".d")
        reading = ["-fsyntax-only", "-MD"] if compiles else ["-M"]
        command = [self.command, standard, *options, *reading, "-MF", str(listing), str(unit)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            return done.stderr
        words = listing.read_text(encoding="utf-8").replace("\\\n", " ").split(":", 1)[1].split()
        return {pathlib.Path(word).resolve() for word in words}

    def standard_library(self, folder):
        """Returns the files of the standard library. Writes the unit that includes all its headers to `folder`."""
        unit = folder / ("standard.c" if self.is_c else "standard.cpp")
        guarded = [f"#if __has_include(<{name}>)\n#include <{name}>\n#endif\n"
                   for name in (C if self.is_c else CXX + INTRINSICS)]
        unit.write_text("".join(guarded), encoding="utf-8")
        found = self.dependencies(unit, ["-w"], compiles=False)
        if isinstance(found, str):
            raise SystemExit(f"the standard headers cannot be read:\n{found}")
        return found
