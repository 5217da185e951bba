# SPDX-License-Identifier: MIT
"""Opens a page of the tests in headless Chromium. A server hands out its folder, since modules and WebAssembly cannot
be read from files."""
import functools
import http.server
import json
import sys
import threading
import time


class Server(http.server.SimpleHTTPRequestHandler):
    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map,
                      ".mjs": "text/javascript", ".wasm": "application/wasm"}

    def log_message(self, *_):
        pass


def told_by(page, project, work, seconds):
    """Returns the text that the page in the folder `work` writes to its body's data. Without Chromium, says so and
    returns None."""
    try:
        sys.path.insert(0, str(project / "tests/apps"))
        import browser  # pylint: disable=import-outside-toplevel
        driver = browser.start(work / "profile")
    except Exception as failure:  # pylint: disable=broad-except
        print("skipped: Chromium,", type(failure).__name__, str(failure).splitlines()[:1])
        return None
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Server, directory=work))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        driver.get(f"http://127.0.0.1:{server.server_port}/{page}")
        end = time.monotonic() + seconds
        while not (told := driver.execute_script("return document.body.dataset.told")):
            if time.monotonic() > end:
                sys.exit(f"Chromium: no answer; {driver.get_log('browser')}")
            time.sleep(0.1)
    finally:
        driver.quit()
        server.shutdown()
    return json.loads(told)
