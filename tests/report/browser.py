"""Headless Chromium by its debugging pipe: pages opened, looked at and measured."""

from __future__ import annotations

import base64
import json
import os
import select
import shutil
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType
from typing import Any

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))),
                None)
SECONDS = 60.0
Message = dict[str, Any]


class Browser:
    """One process; messages are JSON objects with a zero byte behind each."""

    def __init__(self, profile: Path) -> None:
        ours_in, self._to = os.pipe()
        self._from, theirs_out = os.pipe()
        # The pipe's ends must be 3 and 4 there.
        self._process = subprocess.Popen(
            ["bash", "-c", f'exec "$@" 3<&{ours_in} 4>&{theirs_out}', "bash", str(CHROMIUM),
             "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
             "--disable-dev-shm-usage", "--no-first-run", f"--user-data-dir={profile}",
             "--remote-debugging-pipe"],
            pass_fds=(ours_in, theirs_out), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(ours_in)
        os.close(theirs_out)
        self._buffer = b""
        self._number = 0
        self.events: list[Message] = []

    def __enter__(self) -> Browser:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self._process.terminate()
        self._process.wait(SECONDS)
        os.close(self._to)
        os.close(self._from)

    def call(self, method: str, session: str = "", **parameters: Any) -> Message:
        """Asks and waits for the answer; what else arrives is kept as events."""
        self._number += 1
        message = {"id": self._number, "method": method, "params": parameters}
        os.write(self._to, json.dumps(message | ({"sessionId": session} if session else {})).encode()
                 + b"\0")
        while True:
            answer = self._next()
            if answer.get("id") == self._number:
                assert "error" not in answer, answer
                result: Message = answer["result"]
                return result
            self.events.append(answer)

    def wait_for(self, method: str, session: str) -> None:
        """Until such an event has come."""
        while not any(event.get("method") == method and event.get("sessionId") == session
                      for event in self.events):
            self.events.append(self._next())

    def _next(self) -> Message:
        end = time.monotonic() + SECONDS
        while b"\0" not in self._buffer:
            ready, _, _ = select.select([self._from], [], [], max(0.0, end - time.monotonic()))
            data = os.read(self._from, 1 << 20) if ready else b""
            assert data, "the browser gave no answer"
            self._buffer += data
        text, _, self._buffer = self._buffer.partition(b"\0")
        message: Message = json.loads(text)
        return message


@dataclass(frozen=True)
class Look:
    """How a page is looked at."""

    width: int = 1280
    height: int = 900
    dark: bool = False
    scripts: bool = True


@dataclass
class Tab:
    """A file in a tab of its own, once it has been loaded."""

    browser: Browser
    path: Path
    look: Look = field(default_factory=Look)

    def __post_init__(self) -> None:
        target = self.browser.call("Target.createTarget", url="about:blank")["targetId"]
        attached = self.browser.call("Target.attachToTarget", targetId=target, flatten=True)
        self.session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(f"{domain}.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=self.look.width,
                  height=self.look.height, deviceScaleFactor=1, mobile=self.look.width < 600)
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if self.look.dark else "light"}])
        self.call("Emulation.setScriptExecutionDisabled", value=not self.look.scripts)
        self.browser.events.clear()
        self.call("Page.navigate", url=self.path.resolve().as_uri())
        self.browser.wait_for("Page.loadEventFired", self.session)

    def call(self, method: str, **parameters: Any) -> Message:
        """A method of this tab."""
        return self.browser.call(method, self.session, **parameters)

    def value(self, expression: str) -> Any:
        """What the expression is worth in the page."""
        found = self.call("Runtime.evaluate", expression=expression, returnByValue=True)
        assert "exceptionDetails" not in found, found
        return found["result"].get("value")

    def complaints(self) -> list[Message]:
        """Errors and warnings of the page so far."""
        self.value("0")
        bad = ("Runtime.exceptionThrown", "Log.entryAdded")
        return [event for event in self.browser.events
                if event.get("sessionId") == self.session and (event["method"] in bad or (
                    event["method"] == "Runtime.consoleAPICalled"
                    and event["params"]["type"] in ("error", "warning", "assert")))]

    def screenshot(self, clip: tuple[float, float, float, float] | None = None) -> bytes:
        """PNG of what is in sight, or of a place of the page."""
        place = dict(zip(("x", "y", "width", "height"), clip)) | {"scale": 1} if clip else None
        more = {"clip": place, "captureBeyondViewport": True} if place else {}
        return base64.b64decode(self.call("Page.captureScreenshot", format="png", **more)["data"])
