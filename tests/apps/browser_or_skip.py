# SPDX-License-Identifier: MIT
"""Imports the browser for a test, or ends the test as one that is skipped where there is none:

    from browser_or_skip import browser"""
import shutil
import sys

NEEDED = "chromium, chromium-driver and python3-selenium (scripts/setup.sh, large_packages)"
try:
    import browser  # noqa: F401
except ImportError as missing:
    print(f"skipped: {missing}; the test needs {NEEDED}")
    sys.exit(77)
if not (shutil.which("chromium") and shutil.which("chromedriver")):
    print(f"skipped: the test needs {NEEDED}")
    sys.exit(77)
