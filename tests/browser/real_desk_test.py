#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages on the real server, in a headless Chromium or in Firefox: `real_desk_test.py DESK_SERVER [--firefox] [--to
PICTURES] [NAME ...]` runs all scenarios or those whose names contain a word. Exit status 1 on failure, 77
if there is no such browser."""
import argparse
import base64
import contextlib
import hashlib
import hmac
import os
import pathlib
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import time

from review_desk_test import drawn
from webdriver import Browser, Failed, Firefox

PASSWORD = "correct horse battery"


def check(what, holds):
    if not holds:
        raise Failed(what)


def sign_in(browser, url, login):
    browser.open(url)
    browser.there("[name=login]")
    browser.keys(login, "Tab", PASSWORD, "Enter")
    browser.there(".cases")


def at_its_end(browser):
    """True if the player has reached the end of the recording."""
    moment, _, length = browser.text(".time").partition(" of ")
    return length != "" and moment == length


class Desk:
    """A centre of fictitious people on a local port; `url` and an invitation."""

    def __init__(self, program, public_url=""):
        self.program = program
        self.server = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                       env={**os.environ, "TORSIO_PUBLIC_URL": public_url})
        self.url = f"http://127.0.0.1:{self.server.stdout.readline().strip()}/"
        self.secret = self.server.stdout.readline().strip()

    def at_the_desk(self, steps):
        """The same physician opens the draft at the desk, scores the second row and saves: (found, saved)."""
        self.server.stdin.write(f"{steps}\n")
        self.server.stdin.flush()
        return self.server.stdout.readline().strip(), self.server.stdout.readline().strip()

    def ask(self, word):
        """Sends "release" or "answers" to the desk and returns its line."""
        self.server.stdin.write(f"{word}\n")
        self.server.stdin.flush()
        return self.server.stdout.readline().strip()

    def close(self):
        self.server.stdin.close()
        self.server.wait()


def submit_and_seal(browser):
    browser.keys("Control+Enter")
    browser.says("body", "Back to the sheet")  # the server is asked first what is still missing
    browser.keys("Control+Enter")
    browser.says("body", "sealed")


def skin_arrived(browser):
    """Bytes loaded until the organ's body and the tissue's picture had arrived; 0 before that."""
    return browser.run("const all = performance.getEntriesByType('resource');"
                       "return all.filter((one) => one.name.includes('/api/organs/') && one.responseEnd > 0).length > 1"
                       " ? all.reduce((sum, one) => sum + one.transferSize, 0) : 0")


def test_score_a_case(kind, desk, pictures):
    with kind() as browser:
        sign_in(browser, desk.url, "physician0")
        browser.says(".figures", "ten minutes")
        browser.picture(pictures / "queue.png")
        begun = time.monotonic()
        browser.click(".case:not(.live)")
        browser.there(".strip")
        browser.there(".stage-canvas")
        browser.until("something is drawn", lambda: drawn(browser)["share"] > 0.02)
        arrived = browser.until("the painted skin is there", lambda: skin_arrived(browser))
        print(f"transferred until then: {arrived / 1e6:.2f} MB")
        check("a first case takes 1.5 MB at most", arrived <= 1.5e6)
        browser.keys("7", "ArrowDown", "8", "ArrowDown", "7")
        browser.says(".saved", "Saved")
        browser.keys("Space")
        browser.until("the recording was watched to its end", lambda: at_its_end(browser))
        browser.picture(pictures / "case.png")
        submit_and_seal(browser)
        print(f"a case: {time.monotonic() - begun:.1f} s")
        check(f"the console is quiet: {browser.faults()}", not browser.faults())


def test_draft_to_the_desk_and_back(kind, desk, pictures):
    """From one browser to the desk, and on to another browser."""
    with kind(webgl=False) as browser:
        sign_in(browser, desk.url, "physician0")
        browser.click(".case:not(.live)")
        browser.there(".strip")
        browser.keys("5")
        browser.says(".saved", "Saved")
    found, saved = desk.at_the_desk(65)
    check(f"the desk finds it: {found}", found == "50 - -")
    check(f"the desk goes on: {saved}", saved == "50 65 -")
    with kind(webgl=False) as browser:
        sign_in(browser, desk.url, "physician0")
        browser.says("main", "Continue the draft")
        browser.click(".case:not(.live)")
        browser.says(".row:nth-child(2) .value", "6.5")
        check("the first mark is there too", browser.text(".row:first-child .value") == "5")


def test_from_the_link_to_a_sealed_case(kind, desk, pictures):
    """With only the link, and without a mouse."""
    begun = time.monotonic()
    with kind() as browser:
        browser.open(f"{desk.url}join#{desk.secret}")
        browser.there("[name=new]")
        browser.picture(pictures / "join.png")
        browser.keys("too short", "Tab", "too short", "Enter")
        browser.says(".said", "fifteen")
        browser.run("document.querySelectorAll('[type=password]').forEach((one) => { one.value = ''; })")
        browser.keys("seven kites above the bay", "Tab", "seven kites above the bay", "Enter")
        browser.says(".notice", "Your sign-in name is physician1")
        check("the link is left in no address", desk.secret not in browser.run("return location.href"))
        browser.there(".cases")
        browser.keys("Enter")
        browser.there(".stage-canvas")
        browser.keys("7", "ArrowDown", "8", "ArrowDown", "7")
        browser.says(".saved", "Saved")
        browser.keys("Space")
        browser.until("the recording was watched to its end", lambda: at_its_end(browser))
        submit_and_seal(browser)
        took_s = time.monotonic() - begun
        print(f"from the link to a sealed case: {took_s:.1f} s")
        check("within three minutes", took_s < 180)
        check(f"the console is quiet: {browser.faults()}", not browser.faults())
        browser.open(f"{desk.url}join#{desk.secret}")
        browser.reload()
        browser.there("[name=new]")
        browser.keys("another one that is long", "Tab", "another one that is long", "Enter")
        browser.says(".said", "not good")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


@contextlib.contextmanager
def behind_caddy(program, folder):
    """A desk behind the proxy of docs/server.md, with the proxy's self-signed certificate."""
    port = free_port()
    public = f"https://localhost:{port}"
    with contextlib.closing(Desk(program, public)) as desk:
        text = (pathlib.Path(__file__).parents[2] / "docs" / "server.md").read_text()
        shipped = text.split("```caddy\n")[1].split("```")[0]
        check("the page says where the desk listens", "127.0.0.1:8443" in shipped and "desk.example.org {" in shipped)
        shipped = shipped.replace("desk.example.org {", f"{public} {{\n\ttls internal")
        shipped = shipped.replace("127.0.0.1:8443", desk.url.split("/")[2])
        shipped = shipped.replace("{\n", "{\n\tadmin off\n\tskip_install_trust\n\tauto_https disable_redirects\n", 1)
        (folder / "Caddyfile").write_text(shipped)
        proxy = subprocess.Popen(["caddy", "run", "--config", str(folder / "Caddyfile")], stderr=subprocess.DEVNULL,
                                 env={"PATH": "/usr/bin:/bin", "HOME": str(folder), "XDG_DATA_HOME": str(folder)})
        try:
            yield desk, f"{public}/"
        finally:
            proxy.terminate()
            proxy.wait()


def reached(browser, url):
    with contextlib.suppress(Failed):
        browser.open(url)
        return True
    return False


def test_through_the_proxy(kind, desk, pictures):
    """Signs in, scores and submits by https through Caddy, configured as in docs/server.md."""
    if shutil.which("caddy") is None or kind is not Browser:
        print("not here")
        return
    with tempfile.TemporaryDirectory() as folder, behind_caddy(desk.program, pathlib.Path(folder)) as (_, url):
        with kind(webgl=False) as browser:
            browser.until("the proxy answers", lambda: reached(browser, url))
            sign_in(browser, url, "physician0")
            cookies = browser.call("GET", "/cookie")
            check(f"the cookie is kept for https alone: {cookies}",
                  [(one["name"][:7], one["secure"], one["httpOnly"], one["sameSite"]) for one in cookies]
                  == [("__Host-", True, True, "Strict")])
            browser.click(".case:not(.live)")
            browser.there(".strip")
            browser.keys("7", "ArrowDown", "8", "ArrowDown", "7")
            browser.says(".saved", "Saved")
            browser.until("the recording is there", lambda: " of 0:0" in browser.text(".time"))
            browser.keys("Space")
            browser.until("the recording was watched to its end", lambda: at_its_end(browser))
            submit_and_seal(browser)
            check(f"the console is quiet: {browser.faults()}", not browser.faults())


PAGES = {"physician0": {"queue": "Your queue", "calibration": "Calibration", "severity": "My severity",
                        "discrepancies": "Discrepancy review",
                        "evaluation": "Evaluation", "sessions": "Your sessions"},
         "apprentice": {"own": "Your record", "remarks": "Remarks", "transcript": "Transcript"},
         "office": {"board": "Today's sessions", "scored": "Who has scored what",
                    "invitations": "Invitations", "signed-in": "Signed in now",
                    "second-factor": "Second factor"}}


def test_a_remark_is_answered(kind, desk, pictures):
    """A physician writes a remark, the trainee replies in a browser, the physician sees the reply at the desk."""
    with kind(webgl=False) as browser:
        sign_in(browser, desk.url, "physician0")
        cases = browser.run("return document.querySelectorAll('.case:not(.live)').length")
        for number in range(cases):  # one of them is the trainee's
            browser.run("location.hash = ''")
            browser.there(".cases")
            browser.run("document.querySelectorAll('.case:not(.live)')[arguments[0]].click()", number)
            browser.until("the recording is there", lambda: " of 0:0" in browser.text(".time"))
            browser.keys("End", "r")
            browser.there(".remarks-place input")
            browser.keys("Hold it steadier here", "Enter")
            browser.says(".remarks-place", "Hold it steadier here")
    check("the marks are released", desk.ask("release") == "released")
    with kind(webgl=False) as browser:
        browser.open(desk.url)
        browser.there("[name=login]")
        browser.keys("apprentice", "Tab", PASSWORD, "Enter")
        browser.there("nav.ways")
        browser.run("location.hash = '#remarks'")
        browser.says(".remark-thread", "Hold it steadier here")
        browser.picture(pictures / "remark.png")
        browser.click(".remark-thread textarea")
        browser.keys("I let go too early, thank you", "Tab", "Enter")
        browser.says(".answers", "I let go too early, thank you")
        check("nobody is named", "physician0" not in browser.text("main"))
        check(f"the console is quiet: {browser.faults()}", not browser.faults())
    answers = desk.ask("answers")
    check(f"the desk has it: {answers}", answers == "Hold it steadier here > I let go too early, thank you;")


def test_an_administrator_invites(kind, desk, pictures):
    """A link is created by keyboard, shown once, and revoked."""
    with kind(webgl=False) as browser:
        browser.open(desk.url)
        browser.there("[name=login]")
        browser.keys("office", "Tab", PASSWORD, "Enter")
        browser.there("nav.ways")
        browser.run("location.hash = '#invitations'")
        browser.there("[aria-label=physician0]")
        browser.run("document.querySelector('[aria-label=physician0]').focus()")
        browser.keys("Space")
        browser.click(".actions .primary:enabled")
        browser.there(".handed-link")
        link = browser.text(".handed-link")
        check(f"it leads to this desk: {link}", link.startswith(f"{desk.url}join#"))
        check("the words for a mail hold it", link in browser.run("return document.querySelector('textarea').value"))
        browser.picture(pictures / "invited.png")
        browser.reload()
        browser.there("[aria-label=physician0]")
        check("it is shown once", link not in browser.run("return document.documentElement.innerHTML"))
        browser.run("document.querySelector('[aria-label=physician0]').click()")
        browser.run("document.querySelector('.stack .field:not([hidden]) input').focus()")
        browser.keys("sent to the wrong address")
        browser.click(".actions button:not(.primary):enabled")
        browser.says(".notice", "The links no longer work")
        check(f"the console is quiet: {browser.faults()}", not browser.faults())


def code_of(secret, steps_ahead=0):
    """The six digits of RFC 6238, as an authenticator app computes them."""
    step = struct.pack(">Q", int(time.time()) // 30 + steps_ahead)
    mac = hmac.new(base64.b32decode(secret), step, hashlib.sha1).digest()
    at = mac[-1] & 15
    return f"{(struct.unpack('>I', mac[at:at + 4])[0] & 0x7fffffff) % 10**6:06d}"


def test_a_second_factor(kind, desk, pictures):
    """Set up with an app, asked for at the next sign-in, and switched off with a recovery code."""
    with kind(webgl=False) as browser:
        browser.open(desk.url)
        browser.there("[name=login]")
        browser.keys("office", "Tab", PASSWORD, "Enter")
        browser.there("nav.ways")
        browser.run("location.hash = '#sessions'")
        browser.click("a[href='#second-factor']")
        browser.there(".qr")
        secret = browser.text(".secret").replace(" ", "")
        browser.picture(pictures / "second-factor.png")
        browser.keys(PASSWORD, "Tab", "000000", "Enter")
        browser.says(".said", "not the code")
        browser.keys(code_of(secret), "Enter")  # the wrong one is selected
        browser.there(".recovery")
        recovery = browser.text(".recovery li:first-child")
        browser.picture(pictures / "recovery-codes.png")
        browser.keys("Tab", "Enter")
        browser.says(".notice", "The second factor is on")
        browser.click("header button")
        browser.there("[name=login]")
        browser.keys("office", "Tab", PASSWORD, "Enter")
        browser.there("[name=code]")
        browser.picture(pictures / "code.png")
        browser.keys("000000", "Enter")
        browser.says(".said", "not right")
        browser.keys(code_of(secret, 1), "Enter")
        browser.there("nav.ways")
        browser.run("location.hash = '#second-factor'")
        browser.says("form", "not used yet: 10")
        browser.click("[name=password]")
        browser.keys(PASSWORD, "Tab", recovery, "Enter")
        browser.says(".notice", "The second factor is off")
        check(f"the console is quiet: {browser.faults()}", not browser.faults())


def test_every_page_opens(kind, desk, pictures):
    """In every role and both languages, without errors or horizontal scrolling."""
    for login, own in PAGES.items():
        with kind(webgl=False) as browser:
            look_round(browser, desk.url, login, own, pictures)


def look_round(browser, url, login, own, pictures):
    browser.open(url)
    browser.there("[name=login]")
    browser.keys(login, "Tab", PASSWORD, "Enter")
    browser.there("nav.ways")
    sizes = ((1280, 800), (320, 640), (3840, 2160)) if type(browser) is Browser else ((1280, 800), (500, 640))
    for size in sizes:
        browser.resize(*size)
        for page, title in own.items():
            browser.run("location.hash = arguments[0]", f"#{page}")
            browser.says("h1", title)
            over = browser.run("return document.documentElement.scrollWidth - document.documentElement.clientWidth")
            check(f"{page} scrolls sideways at {size}: {over}", over <= 0)
            wide = browser.run("return Math.max(0, ...[...document.querySelectorAll('.queue table, .queue button')]"
                               ".map((one) => one.getBoundingClientRect().width / parseFloat(getComputedStyle(one).fontSize)))")
            check(f"{page} at {size}: a row {wide} letters wide cannot be followed", wide <= 75)
            said = browser.text("body").split()
            check(f"{page} shows what is no word: {said}", not {"null", "undefined", "NaN", "[object"} & set(said))
            browser.picture(pictures / f"{page}-{size[0]}.png")
    if login == "apprentice":
        browser.resize(1280, 800)
        browser.run("location.hash = '#own'")
        browser.click("main a[href^='#run/']")
        browser.says("main", "Twists")
        browser.until("the traces are there", lambda: " of 0:0" in browser.text(".time"))
        browser.picture(pictures / "run.png")
        browser.run("location.hash = '#transcript'")
        browser.there("main .primary")
        browser.click("main .primary")
        browser.says("main", "no certificate")
        browser.picture(pictures / "transcript-made.png")
    check(f"the console is quiet: {browser.faults()}", not browser.faults())
    browser.run("localStorage.setItem('torsio.language', 'zh_CN')")
    browser.open(url)
    browser.there("nav.ways")
    browser.picture(pictures / f"{login}-zh.png")


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("server")
    arguments.add_argument("--firefox", action="store_true")
    arguments.add_argument("--to", type=pathlib.Path, default=pathlib.Path("."), help="folder of the pictures")
    arguments.add_argument("names", nargs="*")
    given = arguments.parse_intermixed_args()
    kind = Firefox if given.firefox else Browser
    if shutil.which(kind.PROGRAM) is None:
        print(f"no {kind.PROGRAM} here")
        return 77
    given.to.mkdir(parents=True, exist_ok=True)
    with contextlib.closing(Desk(given.server)) as desk:
        for name, scenario in list(globals().items()):
            if name.startswith("test_") and (not given.names or any(word in name for word in given.names)):
                begun = time.monotonic()
                scenario(kind, desk, given.to)
                print(f"ok      {name} {time.monotonic() - begun:.1f} s", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
