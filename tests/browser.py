"""A page in Chromium, as a reader has it before him."""

from __future__ import annotations

import shutil
from typing import Any

import pytest
from selenium import webdriver
from selenium.webdriver.support.ui import WebDriverWait

CHROMIUM = shutil.which("chromium")
needs_chromium = pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed")


class Page:
    """Errors are those of its console."""

    def __init__(self, *arguments: str) -> None:
        options = webdriver.ChromeOptions()
        options.binary_location = str(CHROMIUM)
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                         "--hide-scrollbars", *arguments):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver: Any = webdriver.Chrome(options=options)

    def look(self, address: str, width: int = 1300, dark: bool = False) -> None:
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": 850, "deviceScaleFactor": 1, "mobile": width < 600})
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})
        self.driver.get("about:blank")
        self.driver.get(address)

    def value(self, expression: str) -> Any:
        """What the expression is worth."""
        return self.driver.execute_script(f"return {expression}")

    def until(self, condition: str) -> Any:
        """Waits until the condition holds: the browser follows links and draws when it can."""
        return WebDriverWait(self.driver, 120, poll_frequency=0.05).until(lambda _: self.value(condition))

    def errors(self) -> list[Any]:
        """Since the latest call."""
        return list(self.driver.get_log("browser"))

    def contrast(self, words: str, ground: str) -> float:
        """Of two of the page's colours, variables of its style sheet: from 1 to 21."""
        self.driver.execute_script(f"document.body.style.color = 'var(--{words})';"
                                   f"document.body.style.backgroundColor = 'var(--{ground})'")
        levels = sorted(_luminance(self.value(f"getComputedStyle(document.body).{key}"))
                        for key in ("color", "backgroundColor"))
        return (levels[1] + 0.05) / (levels[0] + 0.05)


def _luminance(colour: str) -> float:
    parts = [int(part) / 255 for part in colour[colour.index("(") + 1:-1].split(",")[:3]]
    red, green, blue = (p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue
