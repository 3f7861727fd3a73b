#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two hundred signed-in browsers that wait for a call: `live_load.py TORSIO DESK_SERVER [--browsers N] [--calls N]`.
Measures on this machine how long ten called raters need until their sheets are there, how long the server works at its
answers, and its memory. Exit status 1 if a target is missed: sheets within 3 s, 99 % of the answers within 200 ms,
300 MB. Run it on an idle machine."""
import argparse
import contextlib
import http.client
import json
import os
import re
import subprocess
import sys
import threading
import time

from live_day_test import RATERS, Server, centre
from live_kills_test import Client

OPEN_S, ANSWER_MS, MEMORY_MB = 3.0, 200, 300
TRAINEES = ("TR-4100", "TR-4101", "TR-4102")


class LoggedServer(Server):
    """Keeps what the server says about each answer."""

    def __init__(self, program, locator):
        self.lines = []
        super().__init__(program, locator, os.environ)

    def start(self):
        self.command.remove("--quiet")
        self.process = subprocess.Popen(self.command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        threading.Thread(target=lambda: self.lines.extend(self.process.stderr), daemon=True).start()
        self.wait_until_ready()

    def times_ms(self):
        """Of routes that answer at once; one that waits for a call is no measure of work."""
        found = [re.fullmatch(r"(\S+ \S+) \d+ (\d+) ms", line.strip()) for line in list(self.lines)]
        return sorted(int(one[2]) for one in found if one and one[1] != "GET /api/live/*" and "sign-in" not in one[1])

    def memory_mb(self):
        with open(f"/proc/{self.process.pid}/status", encoding="utf-8") as status:
            return int(re.search(r"VmHWM:\s+(\d+) kB", status.read())[1]) / 1000


class Browser(Client):
    """Keeps a request open, like a page; fetches the sheet as soon as a new one is called. Each comes from an address
    of its own, as tablets do."""

    def __init__(self, server, number):
        super().__init__(server, f"physician{number % RATERS}")
        self.address = f"127.0.1.{number % 250 + 1}"
        self.known = set()
        self.opened = {}  # time by label
        self.waits = threading.Event()

    def ask(self, method, path, body=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.server.own_port, timeout=60, source_address=(self.address, 0))
        with contextlib.closing(connection):
            connection.request(method, path, None if body is None else json.dumps(body),
                               {"Content-Type": "application/json", "Origin": f"http://127.0.0.1:{self.server.own_port}", **self.headers})
            answer = connection.getresponse()
            text = answer.read()
            if answer.getheader("Set-Cookie"):
                self.headers["Cookie"] = answer.getheader("Set-Cookie").split(";")[0]
            return answer.status, json.loads(text) if text else None

    def run(self):
        _, live = self.answer("GET", "/api/live")
        while not self.done:
            self.waits.set()
            status, news = self.answer("GET", f"/api/live/{live['stamp']}")
            if status != 200:
                continue
            live = news
            for line in live["lines"]:
                if line["open"] and line["label"] not in self.known:
                    self.known.add(line["label"])
                    self.answer("POST", "/api/live/follow", {"shown": "", "busy": 0, "followed": ""})
                    self.answer("GET", f"/api/cases/{line['case']}")
                    self.opened[line["label"]] = time.monotonic()


def measure(server, browsers, calls):
    office = Client(server, "office")
    _, answer = office.answer("GET", "/api/cohorts")
    path = f"/api/cohorts/{answer['cohorts'][answer['first']]['cohort']}/calls"
    pages = [Browser(server, number) for number in range(browsers)]
    for page in pages:
        page.start()
    for page in pages:
        page.waits.wait(120)
    time.sleep(1.0)
    worst_s = 0.0
    for number, trainee in enumerate(TRAINEES[:calls]):
        order = {"code": trainee, "room": f"Room {number}", "occasion": "post", "reason": "a measurement"}
        begun = time.monotonic()
        office.answer("POST", path, order)
        while any(len(page.opened) <= number for page in pages[:RATERS]):
            time.sleep(0.005)
            if time.monotonic() > begun + 30:
                break
        took_s = time.monotonic() - begun
        worst_s = max(worst_s, took_s)
        while any(len(page.opened) <= number for page in pages) and time.monotonic() < begun + 60:
            time.sleep(0.01)
        print(f"{trainee}: ten sheets are open {took_s:.2f} s after the call, all {browsers} pages {time.monotonic() - begun:.2f} s", flush=True)
        time.sleep(1.0)
    for page in pages:
        page.done = True
    times = server.times_ms()
    share = times[int(0.99 * (len(times) - 1))]
    memory = server.memory_mb()
    print(f"{browsers} browsers, {len(times)} answers: median {times[len(times) // 2]} ms, 99 % {share} ms, longest {times[-1]} ms; "
          f"memory {memory:.0f} MB")
    return worst_s <= OPEN_S and share <= ANSWER_MS and memory <= MEMORY_MB


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("program")
    arguments.add_argument("desk_server")
    arguments.add_argument("--browsers", type=int, default=200)
    arguments.add_argument("--calls", type=int, default=len(TRAINEES))
    given = arguments.parse_args()
    with centre(given.desk_server) as locator:
        server = LoggedServer(given.program, locator)
        good = measure(server, given.browsers, given.calls)
        server.kill()
    print("ok      within the targets" if good else "failed  a target is missed")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
