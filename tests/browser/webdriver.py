# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives a headless Chromium through chromedriver, or Firefox through its Marionette, by their protocols directly:
needs only Debian's Python."""
import base64
import json
import os
import socket
import subprocess
import tempfile
import time
import urllib.error
import urllib.request

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"
KEYS = {"Tab": "\ue004", "Enter": "\ue007", "Control": "\ue009", "Alt": "\ue00a", "Shift": "\ue008", "Escape": "\ue00c", "Backspace": "\ue003",
        "ArrowLeft": "\ue012", "ArrowUp": "\ue013", "ArrowRight": "\ue014", "ArrowDown": "\ue015", "Home": "\ue011",
        "End": "\ue010", "Space": " "}
PATIENCE_S = 60


class Failed(AssertionError):
    pass


class Browser:
    """One window. Use as `with Browser() as browser`."""
    PROGRAM = "chromedriver"

    def __init__(self, size=(1280, 800), language="en-GB", dark=False, webgl=True, program=None, display=False):
        """`program`: another browser than Debian's. `display`: uses the present screen and graphics hardware."""
        self.program, self.display = program, display
        self.size, self.language, self.dark, self.webgl = size, language, dark, webgl

    def __enter__(self):
        self.base = self.started() or self.started() or self.started()  # another program may take the port it found
        if self.base is None:
            raise Failed("chromedriver does not start")
        arguments = [*([] if self.display else ["--headless=new"]), "--no-sandbox", "--disable-dev-shm-usage", f"--lang={self.language}",
                     f"--window-size={self.size[0]},{self.size[1]}", "--hide-scrollbars"]
        if self.webgl and not self.display:
            arguments += ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
        if not self.webgl:
            arguments.append("--disable-3d-apis")
        if self.dark:
            arguments.append("--blink-settings=preferredColorScheme=0")
        options = {"args": arguments, "prefs": {"intl.accept_languages": self.language}}
        if self.program:
            options["binary"] = self.program
        answer = self.call("POST", "/session", {"capabilities": {"alwaysMatch": {
            "browserName": "chrome", "acceptInsecureCerts": True, "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}}})
        self.base += f"/session/{answer['sessionId']}"
        self.resize(*self.size)
        return self

    def started(self):
        """Starts the driver and returns its address; None: it ended."""
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                       text=True)
        for line in self.driver.stdout:
            if "started successfully on port" in line:
                return f"http://127.0.0.1:{line.split('port')[1].strip(' .') .strip()}".rstrip(".")
        self.driver.wait()
        return None

    def __exit__(self, *_):
        try:
            self.call("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()

    def call(self, method, path, body=None):
        data = json.dumps(body if body is not None else {}).encode() if method == "POST" else None
        request = urllib.request.Request(self.base + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise Failed(json.load(error)["value"]["message"].split("\n")[0]) from None

    def open(self, url):
        self.call("POST", "/url", {"url": url})

    def reload(self):
        self.call("POST", "/refresh")

    def run(self, script, *arguments):
        return self.call("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def resize(self, width, height):
        """Sets the size of the page, however small; a window has a minimum width, a device has none."""
        self.devtools("Emulation.setDeviceMetricsOverride",
                      {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})

    def theme(self, dark):
        self.devtools("Emulation.setEmulatedMedia",
                      {"features": [{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})

    def devtools(self, command, parameters):
        return self.call("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def until(self, what, look):
        """Waits until `look()` returns a true value, and returns that."""
        end = time.monotonic() + PATIENCE_S
        while True:
            found = look()
            if found:
                return found
            if time.monotonic() > end:
                raise Failed(f"in vain: {what}\n{self.text('body')[:1500]}\n{self.faults()}")
            time.sleep(0.03)

    def text(self, css):
        return self.run("return document.querySelector(arguments[0])?.innerText ?? ''", css) or ""  # null during navigation

    def says(self, css, text):
        return self.until(f"{css} says {text!r}", lambda: text in self.text(css))

    def there(self, css):
        return self.until(f"{css} is there", lambda: self.run(
            "const e = document.querySelector(arguments[0]); return Boolean(e) && e.checkVisibility()", css))

    def click(self, css):
        self.there(css)
        element = self.call("POST", "/element", {"using": "css selector", "value": css})[ELEMENT]
        self.call("POST", f"/element/{element}/click")

    def tap(self, css, across=0.5):
        """Taps at this fraction of the width."""
        x, y = self.run("const e = document.querySelector(arguments[0]); e.scrollIntoView({block: 'nearest'});"
                        "const r = e.getBoundingClientRect(); return [r.left + r.width * arguments[1], r.top + r.height / 2]",
                        css, across)
        finger = [{"type": "pointerMove", "duration": 0, "x": round(x), "y": round(y)},
                  {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]
        self.call("POST", "/actions", {"actions": [{"type": "pointer", "id": "finger",
                                                    "parameters": {"pointerType": "touch"}, "actions": finger}]})

    def keys(self, *names):
        """Types names of KEYS, "Control+z", or texts letter by letter."""
        actions = []
        for name in names:
            parts = name.split("+") if len(name) > 1 and "+" in name else [name]
            letters = [KEYS.get(part, part) for part in parts] if len(parts) > 1 or name in KEYS else list(name)
            if len(parts) > 1:
                actions += [{"type": "keyDown", "value": one} for one in letters]
                actions += [{"type": "keyUp", "value": one} for one in reversed(letters)]
            else:
                for one in letters:
                    actions += [{"type": "keyDown", "value": one}, {"type": "keyUp", "value": one}]
        self.call("POST", "/actions", {"actions": [{"type": "key", "id": "keyboard", "actions": actions}]})

    def picture(self, path):
        with open(path, "wb") as file:
            file.write(base64.b64decode(self.call("GET", "/screenshot")))

    def faults(self):
        """Returns console messages since the last call: script errors, content policy violations."""
        return [line["message"] for line in self.call("POST", "/se/log", {"type": "browser"})
                if line["level"] == "SEVERE" and "Failed to load resource" not in line["message"]]


class Firefox(Browser):
    """Runs under Xvfb, as headless Firefox has no WebGL, and without geckodriver, which Debian lacks; the commands are the same."""
    PROGRAM = "firefox-esr"
    COMMANDS = {"/url": "Navigate", "/execute/sync": "ExecuteScript", "/element": "FindElement", "/actions": "PerformActions",
                "/screenshot": "TakeScreenshot", "/refresh": "Refresh"}

    def __enter__(self):
        read, write = os.pipe()
        self.screen = None if self.display else subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "3840x2160x24"], pass_fds=[write], stderr=subprocess.DEVNULL)
        display = os.environ["DISPLAY"] if self.display else f":{os.read(read, 16).decode().strip()}"
        self.profile = tempfile.TemporaryDirectory(prefix="torsio-firefox-")
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        preferences = {"marionette.port": port, "intl.accept_languages": self.language, "dom.disable_beforeunload": True,
                       "webgl.disabled": not self.webgl, "ui.systemUsesDarkTheme": int(self.dark),
                       "layout.css.prefers-color-scheme.content-override": 0 if self.dark else 1, "browser.shell.checkDefaultBrowser": False,
                       "datareporting.policy.dataSubmissionEnabled": False, "app.update.enabled": False}
        with open(f"{self.profile.name}/user.js", "w") as file:
            file.writelines(f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in preferences.items())
        self.driver = subprocess.Popen(
            [self.program or "firefox-esr", "--marionette", "--remote-allow-system-access", "--no-remote", "--profile", self.profile.name, "about:blank"],
            env={**os.environ, "DISPLAY": display, "HOME": self.profile.name, "MOZ_CRASHREPORTER_DISABLE": "1"},
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.number = 0
        self.socket = self.connected(port)
        self.bytes = self.socket.makefile("rb")
        self.receive()  # the greeting
        self.order("NewSession", {"capabilities": {"alwaysMatch": {"unhandledPromptBehavior": "accept"}}})
        self.resize(*self.size)
        return self

    @staticmethod
    def connected(port):
        end = time.monotonic() + 60
        while True:
            try:
                return socket.create_connection(("127.0.0.1", port), timeout=60)
            except ConnectionRefusedError:
                if time.monotonic() > end:
                    raise
                time.sleep(0.1)

    def __exit__(self, *_):
        self.driver.terminate()
        self.driver.wait()
        if self.screen:
            self.screen.terminate()
            self.screen.wait()
        self.profile.cleanup()

    def receive(self):
        length = b""
        while not length.endswith(b":"):
            length += self.bytes.read(1)
        return json.loads(self.bytes.read(int(length[:-1])))

    def order(self, command, parameters, of="WebDriver"):
        self.number += 1
        text = json.dumps([0, self.number, f"{of}:{command}", parameters]).encode()
        self.socket.sendall(str(len(text)).encode() + b":" + text)
        _, _, error, result = self.receive()
        if error:
            raise Failed(error["message"])
        return result.get("value") if isinstance(result, dict) else result

    def call(self, method, path, body=None):
        if path.endswith("/click"):
            return self.order("ElementClick", {"id": path.split("/")[2]})
        return self.order(self.COMMANDS[path], {"full": False} if path == "/screenshot" else body or {})

    def resize(self, width, height):
        """Below its window's minimum width the page is enlarged: it has as many pixels of its own."""
        zoom = 1 if width >= 500 else 2
        self.order("SetContext", {"value": "chrome"}, of="Marionette")
        self.order("ExecuteScript", {"script": "window.gBrowser.selectedBrowser.fullZoom = arguments[0]", "args": [zoom]})
        self.order("SetContext", {"value": "content"}, of="Marionette")
        window = [width * zoom, height * zoom]
        for _ in range(3):  # the second time without the window's own bars
            self.order("SetWindowRect", {"x": 0, "y": 0, "width": window[0], "height": window[1]})
            page = self.run("return [innerWidth, innerHeight]")
            window = [round(window[i] + zoom * (want - page[i])) for i, want in enumerate((width, height))]

    def faults(self):
        return []  # Marionette has no access to the console
