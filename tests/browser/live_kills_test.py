#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plugs pulled in the middle of ten live sheets: `live_kills_test.py TORSIO DESK_SERVER [--kills N] [--plug NAME]`. Ten
raters without a browser save marks as fast as they can while the server is killed and the network cut N times each; if
TORSIO_TEST_POSTGRES is set, once more on a PostgreSQL of its own, which is killed N times as well. `--plug database` pulls
that one alone. What a rater was told is saved must be there after each kill, nothing twice, and all ten sheets can be
submitted. Exit status 1 on failure."""
import argparse
import contextlib
import http.client
import json
import os
import random
import sys
import threading
import time

from live_day_test import RATERS, TRAINEE, Postgres, Rater, Server, centre
from real_desk_test import PASSWORD, check
from webdriver import Failed

PATIENCE_S = 60


class Client(Rater):
    """Somebody signed in without a browser, who signs in again when the server has forgotten the session."""

    def __init__(self, server, login):
        super().__init__(server, 0)
        self.login = login

    def answer(self, method, path, body=None):
        """Asks until the server answers. Returns status and body."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            with contextlib.suppress(OSError, http.client.HTTPException, json.JSONDecodeError):
                status, answer = self.ask(method, path, body)
                if status == 401:
                    self.sign_in()
                elif status not in (429, 503):
                    return status, answer
            time.sleep(0.05)
        raise Failed(f"{self.login}: no answer to {method} {path}")


class Saving(Client):
    """Saves one mark after another, and checks after each lost answer what is stored."""

    def __init__(self, server, login):
        super().__init__(server, login)
        self.saved = self.lost = 0
        self.problem = ""

    def run(self):
        try:
            self.save_until_done()
        except Exception as error:  # reported by the main thread
            self.problem = f"{self.login}: {error!r}"

    def case(self):
        while True:
            _, live = self.answer("GET", "/api/live")
            if live["lines"]:
                return f"/api/cases/{live['lines'][0]['case']}"
            time.sleep(0.1)

    def save_until_done(self):
        path = self.case()
        sheet = self.answer("GET", path)[1]["sheet"]
        mark = 0
        while not self.done:
            mark = mark % 100 + 10  # whole points
            before = (sheet["revision"], sheet.get("overall_steps"))
            status = None
            with contextlib.suppress(OSError, http.client.HTTPException, json.JSONDecodeError):
                status, told = self.ask("PUT", f"{path}/sheet", {**sheet, "overall_steps": mark})
            if status == 200:
                sheet = {**sheet, "overall_steps": mark, "revision": told["revision"]}
                self.saved += 1
                time.sleep(0.02)
                continue
            self.lost += 1
            path = self.case()  # handles are those of a session
            sheet = self.answer("GET", path)[1]["sheet"]
            now = (sheet["revision"], sheet.get("overall_steps"))
            if now not in (before, (before[0] + 1, mark)):
                raise Failed(f"stored is {now}, saved was {before}, under way {mark}")
        rows = self.answer("GET", path)[1]["rubric"]["rows"]
        whole = {**sheet, "rows": [{"code": row["code"], "score_steps": 60 + 10 * i, "not_assessable": ""}
                                   for i, row in enumerate(rows)]}
        # Signing asks for the password again half an hour after it was typed.
        status, answer = self.answer("POST", f"{path}/submit", {"sheet": whole, "password": PASSWORD})
        if status != 200:
            raise Failed(f"not submitted: {status} {answer}")


def call(office):
    _, answer = office.answer("GET", "/api/cohorts")
    path = f"/api/cohorts/{answer['cohorts'][answer['first']]['cohort']}/calls"
    order = {"code": TRAINEE, "room": "Skills lab", "occasion": "post"}
    status, answer = office.answer("POST", path, order)
    if "objection" in answer:
        status, answer = office.answer("POST", path, {**order, "reason": "a test"})
    check(f"{TRAINEE} is called: {status}", status == 200)


def submitted(office):
    _, answer = office.answer("GET", "/api/cohorts")
    path = f"/api/cohorts/{answer['cohorts'][answer['first']]['cohort']}/scored"
    return sum(line["cells"].count("submitted") for line in office.answer("GET", path)[1]["lines"])


def play(program, locator, kills, database, plug):
    chance = random.Random(4100)
    with contextlib.ExitStack() as stack:
        server = Server(program, *(database.for_the_program() if database else (locator, os.environ)))
        stack.callback(server.close)
        office = Client(server, "office")
        call(office)
        raters = [Saving(server, f"physician{number}") for number in range(RATERS)]
        for one in raters:
            one.start()

        def all_save():
            before = [one.saved for one in raters]
            end = time.monotonic() + PATIENCE_S
            while any(one.saved == then for one, then in zip(raters, before)):
                problem = next((one.problem for one in raters if one.problem), "")
                check(f"nothing is lost or doubled {problem}", not problem)
                check("everybody saves again", time.monotonic() < end)
                time.sleep(0.02)

        plugs = {"server": (server.kill, server.start), "network": (server.cable.cut, server.cable.mend)}
        if database:
            plugs["database"] = (database.crash, database.up)
        plugs = {name: both for name, both in plugs.items() if plug in (None, name)}
        longest_s = 0.0
        for instant in range(kills * len(plugs)):
            name, (pull, put_back) = list(plugs.items())[instant % len(plugs)]
            all_save()
            time.sleep(chance.uniform(0.0, 0.3))
            begun = time.monotonic()
            pull()
            if name == "network":
                time.sleep(chance.uniform(0.0, 0.3))
            put_back()
            up = time.monotonic()
            all_save()
            longest_s = max(longest_s, time.monotonic() - up)
            print(f"{name} {instant + 1}: away {up - begun:.1f} s, everybody saves {time.monotonic() - up:.1f} s later", flush=True)
        for one in raters:
            one.done = True
        for one in raters:
            one.join(PATIENCE_S)
            check(f"{one.login}: {one.saved} saves, {one.lost} answers lost {one.problem}", not one.problem and not one.is_alive())
        check("ten sheets are submitted, once each", submitted(office) == RATERS)
        print(f"longest until everybody saved again: {longest_s:.1f} s")


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("program")
    arguments.add_argument("desk_server")
    arguments.add_argument("--kills", type=int, default=5)
    arguments.add_argument("--plug", choices=("server", "network", "database"))
    given = arguments.parse_args()
    if given.plug != "database":
        with centre(given.desk_server) as locator:
            play(given.program, locator, given.kills, None, given.plug)
            print(f"ok      {given.kills} pulls of each plug on SQLite", flush=True)
    if os.environ.get("TORSIO_TEST_POSTGRES"):
        with contextlib.closing(Postgres()) as database, centre(given.desk_server, database.locator) as locator:
            play(given.program, locator, given.kills, database, given.plug)
            print(f"ok      {given.kills} pulls of each plug on PostgreSQL", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
