# SPDX-License-Identifier: MIT
"""Headless Chromium, driven by Selenium: for tests and screenshots."""
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

RIGHT, ENTER, ESCAPE = Keys.ARROW_RIGHT, Keys.ENTER, Keys.ESCAPE


# Stands in for a graphics card, which WebGL needs. It composes a page slowly: ten frames a second.
SOFTWARE_CARD = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")


def start(profile, width=1300, height=900, webgl=True):
    options = Options()
    for argument in ("--headless=new", "--no-sandbox", *(SOFTWARE_CARD if webgl else ("--disable-gpu",)), "--hide-scrollbars",
                     f"--window-size={width},{height}", f"--user-data-dir={profile}", "--disable-dev-shm-usage"):
        options.add_argument(argument)
    options.binary_location = "/usr/bin/chromium"
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    driver.set_script_timeout(60)
    return driver


def open_page(driver, path, fragment="", seconds=120):
    """Returns the seconds until everything was drawn and measured."""
    driver.get("about:blank")
    began = time.monotonic()
    driver.get(path.resolve().as_uri() + fragment)
    while not (state := driver.execute_script("return document.documentElement.dataset.state")):
        if time.monotonic() - began > seconds:
            raise TimeoutError(f"{path}: not ready after {seconds} seconds")
        time.sleep(0.05)
    if state != "ready":
        raise AssertionError(driver.find_element("id", "verdict").text)
    return time.monotonic() - began


def repaint(driver):
    driver.execute_script("asterism.stage.paint()")


def choose(driver, name, index):
    Select(driver.find_element("id", name)).select_by_index(index)


def click_middle(driver):
    """Clicks beside the middle of the canvas: in the middle, domains have vertices."""
    ActionChains(driver).move_to_element_with_offset(driver.find_element("id", "canvas"), 31, 17).click().perform()


def hover_middle(driver):
    ActionChains(driver).move_to_element_with_offset(driver.find_element("id", "canvas"), 31, 17).perform()


def resize(driver, width=0, height=0):
    """Shows the page as on a screen of this size. A width of 0 restores the screen."""
    if width == 0:
        driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
    else:
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                               {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})


def touch(driver, steps):
    """Puts fingers at the places of each step in turn, in pixels of the window, then lifts them."""
    driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 5})
    for i, places in enumerate(steps):
        points = [{"x": x, "y": y, "id": finger} for finger, (x, y) in enumerate(places)]
        driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": "touchMove" if i else "touchStart", "touchPoints": points})
    driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    driver.execute_async_script("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")
    driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": False})


def broken_words(driver):
    """Returns the words and numbers of tables that run over more than one line. Fingerprints are excepted."""
    return driver.execute_script("""
        const wrong = [], range = document.createRange();
        for (const cell of document.querySelectorAll("td:not(.hash), th")) {
          if (cell.offsetParent === null) continue;
          for (const word of cell.textContent.matchAll(/\\S+/g)) {
            range.setStart(cell.firstChild, word.index);
            range.setEnd(cell.firstChild, word.index + word[0].length);
            if (range.getClientRects().length > 1) wrong.push(word[0]);
          }
        }
        return wrong;""")


def colours_of_canvas(driver):
    """Returns how many pixels of a grid have each colour, as the graphics card drew them."""
    return driver.execute_script("""
        const gl = document.getElementById("canvas").getContext("webgl2"), counts = {};
        const w = gl.drawingBufferWidth, h = gl.drawingBufferHeight, pixels = new Uint8Array(4 * w * h);
        gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        for (let i = 0; i < w * h; i += 7) {
          const colour = pixels.slice(4 * i, 4 * i + 3).join();
          counts[colour] = (counts[colour] ?? 0) + 1;
        }
        return counts;""")


def luminance(driver, colour):
    """Returns the relative luminance (WCAG 2) of a computed colour."""
    numbers = driver.execute_script(f"return {colour}.match(/\\d+/g).slice(0, 3).map(Number)")
    linear = [x / 255 / 12.92 if x / 255 <= 0.04045 else ((x / 255 + 0.055) / 1.055) ** 2.4 for x in numbers]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
