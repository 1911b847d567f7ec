# SPDX-License-Identifier: Apache-2.0
"""Drives a headless Chromium over its DevTools pipe with the standard library alone."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


def find():
    """The program, or the end of this test: skipped."""
    for name in filter(None, (os.environ.get("LAC_CHROMIUM"), *NAMES)):
        if path := shutil.which(name):
            return path
    print("skipped: no Chromium here (" + ", ".join(NAMES) + ", or LAC_CHROMIUM=<program>)")
    sys.exit(SKIPPED)


class Page:
    """One page from a file, without network. All requests and complaints are kept."""

    def __init__(self, path, width=1280, height=900):
        program = find()
        self.folder = tempfile.TemporaryDirectory(prefix="lac_chromium_", ignore_cleanup_errors=True)
        to_browser, self.out = os.pipe()
        self.inp, from_browser = os.pipe()
        # The browser speaks over its descriptors 3 and 4, whatever they are called here.
        wiring = 'exec 3<&%d 4>&%d; exec "$@"' % (to_browser, from_browser)
        command = [program, "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run",
                   "--remote-debugging-pipe", "--disable-background-networking", "--disable-sync",
                   "--disable-component-update", "--disable-dev-shm-usage", "--hide-scrollbars",
                   "--host-resolver-rules=MAP * ~NOTFOUND", "--user-data-dir=" + self.folder.name,
                   "--window-size=%d,%d" % (width, height), "about:blank"]
        self.process = subprocess.Popen(["bash", "-c", wiring, "bash", *command],
                                        pass_fds=(to_browser, from_browser),
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.number, self.left, self.session = 0, b"", None
        self.requests, self.complaints, self.loaded = [], [], False
        targets = self.call("Target.getTargets")["targetInfos"]
        target = next(t["targetId"] for t in targets if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(domain + ".enable")
        self.call("Network.emulateNetworkConditions", offline=True, latency=0,
                  downloadThroughput=0, uploadThroughput=0)
        answer = self.call("Page.navigate", url=pathlib.Path(path).resolve().as_uri())
        assert not answer.get("errorText"), (path, answer)
        self.until(lambda: self.loaded, "the page has loaded")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.session = None
            self.call("Browser.close")
            self.process.wait(20)
        except (OSError, EOFError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        self.folder.cleanup()

    def _next(self):
        while b"\0" not in self.left:
            some = os.read(self.inp, 1 << 16)
            if not some:
                raise EOFError("Chromium ended")
            self.left += some
        text, self.left = self.left.split(b"\0", 1)
        return json.loads(text)

    def _note(self, message):
        method, what = message.get("method"), message.get("params", {})
        if method == "Network.requestWillBeSent":
            self.requests.append(what["request"]["url"])
        elif method == "Page.loadEventFired":
            self.loaded = True
        elif method == "Runtime.exceptionThrown":
            self.complaints.append(str(what["exceptionDetails"]))
        elif method == "Runtime.consoleAPICalled" and what["type"] in ("error", "warning", "assert"):
            self.complaints.append(str(what["args"]))
        elif method == "Log.entryAdded" and what["entry"]["level"] in ("error", "warning"):
            self.complaints.append(str(what["entry"]))

    def call(self, method, **params):
        self.number += 1
        message = {"id": self.number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._next()
            if answer.get("id") != self.number:
                self._note(answer)
                continue
            if "error" in answer:
                raise RuntimeError("%s: %s" % (method, answer["error"]))
            return answer["result"]

    def value(self, script):
        """What an expression (or a promise) comes to."""
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(script + ": " + str(answer["exceptionDetails"]))
        return answer["result"].get("value")

    def until(self, condition, what, seconds=60):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                raise AssertionError("waited in vain until " + what)
            self.value("new Promise(done => setTimeout(done, 20))")

    def settle(self):
        """After two frames everything asked for is drawn."""
        self.value("new Promise(d => requestAnimationFrame(() => requestAnimationFrame(() => d())))")

    def place_of(self, element):
        """x, y, width, height of what an expression names, scrolled into view."""
        self.value("(%s).scrollIntoView({block: 'center'})" % element)
        self.settle()
        return self.value("(() => { const b = (%s).getBoundingClientRect();"
                          "return [b.x, b.y, b.width, b.height]; })()" % element)

    def mouse(self, kind, x, y, clicks=0):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, clickCount=clicks,
                  button="none" if kind == "mouseMoved" and not clicks else "left",
                  buttons=1 if clicks and kind != "mouseReleased" else 0)

    def click(self, element):
        x, y, width, height = self.place_of(element)
        x, y = x + min(width / 2, 12), y + height / 2
        self.mouse("mouseMoved", x, y)
        self.mouse("mousePressed", x, y, 1)
        self.mouse("mouseReleased", x, y, 1)
        self.settle()

    def drag(self, element, start, end):
        """Over these shares of width and height."""
        x, y, width, height = self.place_of(element)
        at = [(x + fx * width, y + fy * height) for fx, fy in (start, end)]
        self.mouse("mouseMoved", *at[0])
        self.mouse("mousePressed", *at[0], 1)
        self.mouse("mouseMoved", *at[1], 1)
        self.mouse("mouseReleased", *at[1], 1)
        self.settle()

    def key(self, name, modifiers=0):
        text = {"text": name} if len(name) == 1 else {}
        self.call("Input.dispatchKeyEvent", type="keyDown", key=name, modifiers=modifiers, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=name, modifiers=modifiers)
        self.settle()

    def colours_in(self, canvas):
        """How many pixels of a canvas are not empty, and how many colours they have."""
        return self.value("""(() => { const c = %s;
            const data = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
            const seen = new Set(); let filled = 0;
            for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 0) {
              ++filled; seen.add(data[i] * 65536 + data[i + 1] * 256 + data[i + 2]); }
            return [filled, seen.size]; })()""" % canvas)
