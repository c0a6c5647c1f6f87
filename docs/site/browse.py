"""browse.py <folder>: opens the pages of a built site as files, in a Chromium without a window, at the widths of phones and desktops.

A page must not be wider than the window, must load nothing from the network, must find all that it loads, and must not
write errors to the console. The search of the site and of the API reference must find something.
"""

from contextlib import contextmanager
import json
from pathlib import Path
import shutil
import subprocess
import sys
import tempfile
import time
from urllib.request import urlopen

import websocket

PROGRAMS = ["chromium", "chromium-browser", "google-chrome", "chrome"]
WIDTHS = [390, 1280]
SECONDS = 30


class Browser:
    """A tab of Chromium, steered by its own protocol."""

    def __init__(self, socket):
        self.socket = socket
        self.number = 0
        self.wrong = []
        for domain in ("Page", "Network", "Runtime", "Log"):
            self.call(f"{domain}.enable")

    def call(self, method, **parameters):
        """Returns the answer to a call, and notes what goes wrong until then."""
        self.number += 1
        self.socket.send(json.dumps({"id": self.number, "method": method, "params": parameters}))
        while True:
            message = json.loads(self.socket.recv())
            if message.get("id") == self.number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']}")
                return message["result"]
            self.note(message.get("method"), message.get("params"))

    def note(self, event, facts):
        if event == "Network.requestWillBeSent" and not facts["request"]["url"].startswith(("file:", "data:", "blob:")):
            self.wrong.append(f"asks the network for {facts['request']['url']}")
        elif event == "Network.loadingFailed" and not facts.get("canceled"):
            self.wrong.append(f"does not load: {facts['errorText']}")
        elif event == "Runtime.exceptionThrown":
            self.wrong.append(f"fails: {facts['exceptionDetails'].get('exception', {}).get('description')}")
        elif event == "Log.entryAdded" and facts["entry"]["level"] == "error":
            self.wrong.append(f"writes: {facts['entry']['text']} {facts['entry'].get('url', '')}")
        elif event == "Runtime.consoleAPICalled" and facts["type"] == "error":
            self.wrong.append(f"writes: {[value.get('value') for value in facts['args']]}")

    def value(self, expression):
        return self.call("Runtime.evaluate", expression=expression, returnByValue=True)["result"].get("value")

    def wait(self, condition):
        """Returns whether a condition comes true."""
        end = time.monotonic() + SECONDS
        while not self.value(f"Boolean({condition})"):
            if time.monotonic() > end:
                return False
            time.sleep(0.02)
        return True

    def open(self, address):
        """Opens a page, and returns what is wrong with it."""
        self.call("Page.navigate", url="about:blank")
        self.wrong = []
        self.call("Page.navigate", url=address)
        if not self.wait(f"document.readyState == 'complete' && location.href.startsWith({json.dumps(address)})"):
            self.wrong.append("is not loaded")
        for width in WIDTHS:
            self.resize(width)
            wide = self.value("document.documentElement.scrollWidth")
            if wide > width:
                self.wrong.append(f"is {wide} pixels wide in a window of {width}")
        return self.wrong

    def resize(self, width):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False)


@contextmanager
def browser(program):
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        options = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--hide-scrollbars"]
        command = [program, *options, "--remote-debugging-port=0", f"--user-data-dir={folder}", "about:blank"]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        try:
            for line in process.stderr:
                if line.startswith("DevTools listening on "):
                    break
            else:
                raise RuntimeError(f"{program} does not start")
            server = line.split("/")[2]
            with urlopen(f"http://{server}/json/list") as answer:
                page = next(entry for entry in json.load(answer) if entry["type"] == "page")
            yield Browser(websocket.create_connection(page["webSocketDebuggerUrl"], suppress_origin=True, timeout=60))
        finally:
            process.terminate()
            process.wait(10)


def main(root):
    """Returns what is wrong."""
    program = next(filter(None, map(shutil.which, PROGRAMS)), None)
    if program is None:
        print(f"skipped: no page is opened, as there is no Chromium: none of {', '.join(PROGRAMS)}")
        return []
    modules = sorted((root / "api").iterdir())
    # Pages of Dokka are alike: one of each kind is enough
    pages = [page for page in sorted(root.rglob("*.html")) if root / "api" not in page.parents]
    for module in modules:
        pages += [module / "index.html", *sorted(module.glob("*/*/index.html"))[:1], *sorted(module.glob("*/*/*/index.html"))[:1]]
    wrong = []
    with browser(program) as tab:
        for page in pages:
            wrong += [f"{page.relative_to(root)} {what}" for what in tab.open(page.as_uri())]
        wrong += tab.open((root / "search.html").as_uri() + "?q=painter")
        if not tab.wait("document.querySelector('#search-results a[href*=\"algorithms/painter.html\"]')"):
            wrong.append("the search does not find painter")
        for module in modules:
            wrong += tab.open((module / "index.html").as_uri())
            if not tab.wait("document.querySelector('#sideMenu a')"):
                wrong.append(f"{module.name}: the API reference has no navigation")
    print(f"{len(pages)} pages opened at {' and '.join(map(str, WIDTHS))} pixels, {len(wrong)} faults")
    return wrong


if __name__ == "__main__":
    found = main(Path(sys.argv[1]).resolve())
    sys.exit("\n".join(found[:20]) if found else 0)
