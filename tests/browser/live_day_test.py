#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A day at the real arm: `live_day_test.py TORSIO DESK_SERVER [--to PICTURES] [--browsers N]`. Ten raters, N of them (2) in
Chromium and Firefox by turns, and an administrator who calls one trainee to all three occasions on a phone. While sheets are filled in,
the server is killed and the network cut, and if TORSIO_TEST_POSTGRES is set, the day is played once more on a PostgreSQL
of its own, which goes away and comes back.
Exit status 1 on failure, 77 if there is no such browser."""
import argparse
import contextlib
import http.client
import json
import os
import pathlib
import re
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time

from real_desk_test import PASSWORD, check, free_port
from webdriver import Browser, Failed, Firefox

START = pathlib.Path(__file__).parents[1] / "support" / "start-postgres.sh"
RATERS = 10
TRAINEE = "TR-4100"


class Cable:
    """The network between the browsers and a server at `port`: cut, it loses every connection, with what is under way."""

    def __init__(self, port):
        self.behind = port
        self.whole = True
        self.lock = threading.Lock()
        self.ends = set()
        self.listener = socket.create_server(("127.0.0.1", 0), backlog=64)
        self.port = self.listener.getsockname()[1]
        threading.Thread(target=self.accept, daemon=True).start()

    def accept(self):
        with contextlib.suppress(OSError):  # closed
            while True:
                near, _ = self.listener.accept()
                try:
                    far = socket.create_connection(("127.0.0.1", self.behind), timeout=5)
                except OSError:  # the server is away
                    self.drop(near)
                    continue
                far.settimeout(None)
                with self.lock:
                    self.ends.update((near, far))
                    whole = self.whole
                if not whole:
                    self.drop(near, far)
                    continue
                for one, other in ((near, far), (far, near)):
                    threading.Thread(target=self.carry, args=(one, other), daemon=True).start()

    def carry(self, one, other):
        with contextlib.suppress(OSError):
            while data := one.recv(65536):
                other.sendall(data)
        self.drop(one, other)

    def drop(self, *ends):
        for end in ends:
            with self.lock:
                self.ends.discard(end)
            with contextlib.suppress(OSError):  # at once, and so that a thread that reads it notices
                end.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
                end.shutdown(socket.SHUT_RDWR)
            end.close()

    def cut(self):
        with self.lock:
            self.whole = False
            ends = list(self.ends)
        self.drop(*ends)

    def mend(self):
        self.whole = True

    def close(self):
        self.listener.close()
        self.cut()


class Server:
    """`torsio serve`, which can be killed and started again at the same address; the browsers reach it over a cable."""

    def __init__(self, program, locator, environment):
        self.environment = environment
        self.own_port = free_port()
        self.command = [program, "serve", "--database", locator, "--listen", f"127.0.0.1:{self.own_port}", "--quiet"]
        self.cable = Cable(self.own_port)
        self.port = self.cable.port
        self.url = f"http://127.0.0.1:{self.port}/"
        self.start()

    def start(self):
        self.process = subprocess.Popen(self.command, env=self.environment, stdout=subprocess.DEVNULL)
        self.wait_until_ready()

    def wait_until_ready(self):
        end = time.monotonic() + 60
        while True:
            with contextlib.suppress(OSError):
                ask = http.client.HTTPConnection("127.0.0.1", self.own_port, timeout=5)
                ask.request("GET", "/readyz")
                if ask.getresponse().status == 200:
                    return
            if time.monotonic() > end:
                raise Failed("the server does not start")
            time.sleep(0.1)

    def kill(self):
        self.process.kill()
        self.process.wait()

    def close(self):
        self.process.terminate()
        check("a stop drains and ends well", self.process.wait(30) == 0)
        self.cable.close()


class Rater(threading.Thread):
    """A rater without a browser: waits for calls, scores each sheet and submits it."""

    def __init__(self, server, number):
        super().__init__(daemon=True)
        self.server, self.login = server, f"physician{number}"
        self.headers = {}
        self.sealed = set()
        self.done = False

    def ask(self, method, path, body=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=40)
        connection.request(method, path, None if body is None else json.dumps(body),
                           {"Content-Type": "application/json", "Origin": self.server.url.rstrip("/"), **self.headers})
        answer = connection.getresponse()
        text = answer.read()
        cookie = answer.getheader("Set-Cookie")
        if cookie:
            self.headers["Cookie"] = cookie.split(";")[0]
        return answer.status, json.loads(text) if text else None

    def sign_in(self):
        status, answer = self.ask("POST", "/api/sign-in", {"login": self.login, "password": PASSWORD})
        if status == 200:
            self.headers["X-Torsio-Token"] = answer["token"]

    def run(self):
        stamp = ""
        while not self.done:
            try:
                status, live = self.ask("GET", f"/api/live/{stamp}" if stamp else "/api/live")
                if status == 401:
                    self.sign_in()
                    stamp = ""
                elif status == 200:
                    stamp = live["stamp"] if all(self.score(line) for line in live["lines"]) else ""
                elif status != 204:
                    time.sleep(0.3)
            except (OSError, http.client.HTTPException, json.JSONDecodeError):
                time.sleep(0.3)  # the server is away

    def score(self, line):
        """True if the sheet is sealed."""
        if line["state"] == "submitted":
            self.sealed.add(line["label"])
            return True
        path = f"/api/cases/{line['case']}"
        status, opened = self.ask("GET", path)
        if status != 200:  # the database is away
            return False
        sheet = opened["sheet"]
        sheet["rows"] = [{**row, "score_steps": 60 + 10 * i, "not_assessable": ""}
                         for i, row in enumerate({"code": row["code"]} for row in opened["rubric"]["rows"])]
        sheet["overall_steps"] = 65
        status, saved = self.ask("PUT", f"{path}/sheet", sheet)
        if status != 200:
            return False
        status, _ = self.ask("POST", f"{path}/submit", {"sheet": {**sheet, "revision": saved["revision"]}})
        if status == 200:
            self.sealed.add(line["label"])
        return status == 200


def sign_in(browser, url, login, there):
    browser.open(url)
    browser.there("[name=login]")
    browser.keys(login, "Tab", PASSWORD, "Enter")
    browser.there(there)


def call(office, trainee, occasion):
    office.run("const form = document.querySelector('.call-form');"
               "const [code, room] = form.querySelectorAll('input'); code.value = arguments[0]; room.value = 'Skills lab';"
               "form.querySelector('select').value = arguments[1]; form.querySelector('[type=submit]').click()", trainee, occasion)
    office.says(".called", trainee)


def end_call(office):
    office.click(".end-call")
    office.until("no call is open", lambda: not office.run("return document.querySelector('.end-call')"))


def opens(browser, begun, before):
    browser.until("the called sheet opens", lambda: browser.text(".live-sheet h1") not in ("", before)
                  and browser.run("return Boolean(document.querySelector('.live-sheet .strip:not([aria-readonly=true])'))"))
    return time.monotonic() - begun


def submit(browser):
    browser.until("it is saved", lambda: browser.text(".saved").startswith(("Saved", "Draft found")))
    browser.keys("Control+Enter")
    browser.says(".submit-bar", "Submitting seals the sheet.")
    browser.keys("Control+Enter")
    browser.says(".live-sheet", "Nobody else is called now")


def unlock(browser):
    browser.there(".gate [name=password]")
    browser.keys(PASSWORD, "Enter")
    browser.until("it is open again", lambda: not browser.run("return document.querySelector('.gate').checkVisibility()"))


def score(browser):
    browser.keys("7", "ArrowDown", "8", "ArrowDown", "7")


def play(program, locator, pictures, browsers, database):
    """`database`: None, or an object with down() and up()."""
    with contextlib.ExitStack() as stack:
        server = Server(program, *(database.for_the_program() if database else (locator, os.environ)))
        stack.callback(server.close)
        others = [Rater(server, number) for number in range(browsers, RATERS)]
        for one in others:
            one.start()
        office = stack.enter_context(Browser(size=(390, 844), webgl=False))
        kinds = [Browser, Firefox if shutil.which(Firefox.PROGRAM) else Browser]
        desks = [stack.enter_context(kinds[number % 2](webgl=False)) for number in range(browsers)]
        for number, desk in enumerate(desks):
            sign_in(desk, server.url, f"physician{number}", "[aria-labelledby=cases-title]")
        sign_in(office, server.url, "office", ".call-form")
        before = [""] * len(desks)

        def calls(occasion):
            begun = time.monotonic()
            call(office, TRAINEE, occasion)
            called = time.monotonic()
            for number, desk in enumerate(desks):
                print(f"{occasion}: the sheet of rater {number} is open {opens(desk, called, before[number]):.1f} s after the call,"
                      f" {time.monotonic() - begun:.1f} s after the caller began")
                before[number] = desk.text(".live-sheet h1")

        calls("pre")
        office.picture(pictures / "caller.png")
        for number, desk in enumerate(desks):
            score(desk)
            desk.picture(pictures / f"live-{number}.png")
            submit(desk)
        office.until("all sheets are in", lambda: "10 of 10" in office.text(".called"))
        end_call(office)

        calls("mid")
        for desk in desks:
            score(desk)
            desk.says(".saved", "Saved")
        desks[0].keys("6")
        server.kill()
        desks[1].keys("5")
        desks[1].says(".saved", "Not saved yet")
        office.says(".calls", "No connection since ")
        office.picture(pictures / "caller-away.png")
        server.start()
        for desk in desks:
            unlock(desk)
            desk.until("it is saved", lambda: desk.text(".saved").startswith(("Saved", "Draft found")))
        unlock(office)
        check("the key before the kill is there", desks[0].text(".last-rows .value") == "6")
        check("so is the key while the server was away", desks[1].text(".last-rows .value") == "5")
        for desk in desks:
            submit(desk)
        office.until("all sheets are in", lambda: "10 of 10" in office.text(".called"))
        end_call(office)

        calls("post")
        plugs = [(server.cable.cut, server.cable.mend)] + ([(database.down, database.up)] if database else [])
        for key, (pull, put_back) in enumerate(plugs, 7):
            pull()
            desks[0].keys(str(key))
            desks[0].says(".saved", "Not saved yet")
            put_back()
            desks[0].says(".saved", "Saved")
            check("nobody was signed out", not desks[0].run("return document.querySelector('.gate').checkVisibility()"))
        for desk in desks:
            score(desk)
            submit(desk)
        office.until("all sheets are in", lambda: "10 of 10" in office.text(".called"))
        end_call(office)
        office.run("location.hash = '#scored'")
        office.says("main", "Still open")
        marks = office.run("return [...document.querySelectorAll('main [role=img]')].map((one) => one.ariaLabel)")
        check(f"thirty live sheets are sealed: {marks}", marks.count("submitted") == 3 * RATERS)
        for one in others:
            one.done = True
            check(f"{one.login} scored each case once: {one.sealed}", len(one.sealed) == 3)


class Postgres:
    """A PostgreSQL of this test alone."""

    def __init__(self):
        self.locator = subprocess.run([START, "start"], stdout=subprocess.PIPE, text=True, check=True).stdout.strip()
        self.environment = {**os.environ, "TORSIO_TEST_POSTGRES": self.locator}
        self.folder = tempfile.TemporaryDirectory()

    def for_the_program(self):
        """Its address without the password, which the program takes from a file only, and the environment."""
        account, password, place = re.fullmatch(r"(postgresql://\w+):(\w+)(@.*)", self.locator).groups()
        file = pathlib.Path(self.folder.name) / "pgpass"
        file.write_text(f"*:*:*:*:{password}\n")
        file.chmod(0o600)
        return account + place, {**os.environ, "PGPASSFILE": str(file)}

    def order(self, word):
        subprocess.run([START, word], env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)

    def down(self):
        self.order("down")

    def crash(self):
        self.order("crash")

    def up(self):
        self.order("up")

    def close(self):
        self.order("stop")
        self.folder.cleanup()


@contextlib.contextmanager
def centre(program, *locator):
    prepared = subprocess.Popen([program, "--day", *locator], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    try:
        yield prepared.stdout.readline().strip()
    finally:
        prepared.stdin.close()
        prepared.wait()


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("program")
    arguments.add_argument("desk_server")
    arguments.add_argument("--to", type=pathlib.Path, default=pathlib.Path("."), help="folder of the pictures")
    arguments.add_argument("--browsers", type=int, choices=range(2, RATERS + 1), default=2, help="raters in a browser")
    given = arguments.parse_args()
    if shutil.which(Browser.PROGRAM) is None:
        print(f"no {Browser.PROGRAM} here")
        return 77
    given.to.mkdir(parents=True, exist_ok=True)
    with centre(given.desk_server) as locator:
        play(given.program, locator, given.to, given.browsers, None)
        print("ok      a day on SQLite", flush=True)
    if os.environ.get("TORSIO_TEST_POSTGRES"):
        with contextlib.closing(Postgres()) as database, centre(given.desk_server, database.locator) as locator:
            play(given.program, locator, given.to, given.browsers, database)
            print("ok      a day on PostgreSQL", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
