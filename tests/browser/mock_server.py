# SPDX-License-Identifier: GPL-3.0-or-later
"""Serves the pages of assets/web and answers as `torsio serve` does, with fictitious cases. For development and for the
tests of the pages: `python3 tests/browser/mock_server.py 8800`, sign in as "rater" with "correct horse battery"."""
import copy
import gzip
import json
import re
import secrets
import sys
import threading
import time
import xml.etree.ElementTree
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import mock_recording

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "assets" / "web"
SHADERS = ROOT / "assets" / "shaders"
TRANSLATIONS = ROOT / "assets" / "translations" / "torsio_zh_CN.ts"
RUBRIC = ROOT / "assets" / "rubrics" / "twist-training.json"
POLICY = ("default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; "
          "font-src 'self'; form-action 'self'; base-uri 'none'; frame-ancestors 'none'; "
          "require-trusted-types-for 'script'")
KINDS = {".html": "text/html; charset=utf-8", ".js": "text/javascript; charset=utf-8", ".css": "text/css; charset=utf-8",
         ".svg": "image/svg+xml", ".frag": "text/plain; charset=utf-8"}
PASSWORD = "correct horse battery"
INVITATION = "abcde-fghjk-mnpqr-stuvw"  # for the rater


class Refused(Exception):
    def __init__(self, status, what, **more):
        super().__init__(what)
        self.status, self.what, self.more = status, what, more


def shipped_rubric(say=lambda text: text):
    """The shipped rubric in the server's format; `say` translates."""
    rubric = json.loads(RUBRIC.read_text())

    def scale(line):
        per = line["steps_per_point"]
        return {"lowest_steps": line["from"] * per, "highest_steps": line["to"] * per, "steps_per_point": per,
                "arrow_steps": per // 2}

    rows = [{"code": line["code"], "label": say(line["label"]),
             "anchors": [{"steps": one["score"] * line["steps_per_point"], "text": say(one["meaning"])}
                         for one in line["anchors"]],
             "scale": scale(line)} for line in rubric["rows"]]
    return {"name": rubric["title"], "rows": rows, "overall": scale(rubric["overall"])}


def translations():
    """English -> Chinese, from the project's translation file; as on the server, those of the class Text."""
    found = {}
    [texts] = [one for one in xml.etree.ElementTree.parse(TRANSLATIONS).iter("context") if one.findtext("name") == "Text"]
    for message in texts.iter("message"):
        translation = message.find("translation")
        if translation.text and translation.get("type") != "obsolete":
            found[message.findtext("source").replace("&", "")] = re.sub(r"\(&.\)|&", "", translation.text)
    return found


class Case:
    def __init__(self, label, rubric, live=False, due_us=None, picture=True):
        self.label, self.live, self.due_us, self.picture = label, live, due_us, picture
        self.state = "open"
        self.rubric = rubric
        self.sheet = {"revision": 0, "rows": [{"code": row["code"], "score_steps": None, "not_assessable": ""}
                                              for row in rubric["rows"]], "overall_steps": None, "comment": ""}
        self.watched, self.worked_us, self.reported_s = [], 0, time.monotonic()
        self.remarks, self.versions = [], []
        self.length_us = round(1e6 * mock_recording.LENGTH_S)

    def share(self):
        return sum(to - start for start, to in self.watched) / self.length_us

    def check(self):
        sheet = self.sheet
        unanswered = [row["code"] for row in sheet["rows"] if row["score_steps"] is None and not row["not_assessable"]]
        if sheet["overall_steps"] is None and not sheet.get("overall_not_assessable"):
            unanswered.append("")
        little = not self.live and self.share() < 0.8
        return {"may_submit": not unanswered and not little, "unanswered": unanswered, "watched_too_little": little,
                "watched_share": self.share(), "speed_not_allowed": False, "soon_after_call_s": None}

    def play(self, played):
        now = time.monotonic()
        left_us = 1e6 * (now - self.reported_s) + 500_000  # a report may be late
        self.reported_s = now
        for one in played:
            start, to = one["from_us"], min(one["to_us"], one["from_us"] + left_us)
            left_us -= to - start
            self.watched.append([start, round(to)])
        joined = []
        for start, to in sorted(self.watched):
            if joined and start <= joined[-1][1]:
                joined[-1][1] = max(joined[-1][1], to)
            elif to > start:
                joined.append([start, to])
        self.watched = joined


class Desk:
    """State of the server, which tests modify while the pages run."""
    def __init__(self):
        self.rubric = shipped_rubric()
        day_us = 86_400_000_000
        now_us = round(1e6 * time.time())
        self.cases = {
            "c1": Case("7F", self.rubric, due_us=now_us + 2 * day_us),
            "c2": Case("2K", self.rubric, due_us=now_us - day_us),
            "c3": Case("9C", self.rubric, picture=False),
            "c4": Case("4B", self.rubric, live=True),
        }
        self.passwords = {"rater": PASSWORD, "new.rater": PASSWORD, "office": PASSWORD}
        self.must_change = {"new.rater"}
        self.sessions = {}
        self.idle_s = 300
        self.refusing = False  # answers 503 to each change
        self.silent = False    # takes requests and does not answer
        self.away = False      # closes each connection without an answer
        self.loses_answers = False  # executes requests, then closes the connection
        self.asks_password = True
        self.wrong = 0
        self.saves = 0
        self.lock = threading.RLock()
        self.files = {}
        self.called = set()    # handles of live cases whose trainee is at the arm
        self.ever_called = set()
        self.calls = []        # as the administrator sees them
        self.missing = 0       # sheets on the board of the day

    def call(self, handle):
        """An administrator calls a live case."""
        self.called.add(handle)
        self.ever_called.add(handle)

    def live(self):
        lines = [{"case": handle, "label": self.cases[handle].label, "state": self.cases[handle].state, "open": handle in self.called,
                  "room": "Skills lab", "older": False} for handle in sorted(self.ever_called)]
        return {"lines": lines, "calls_go_on": bool(self.ever_called), "stamp": str(abs(hash(json.dumps(lines))))}

    def follow(self, body, _who):
        open_ones = [handle for handle in sorted(self.called) if self.cases[handle].state != "submitted" and handle != body["shown"]]
        if not open_ones:
            return {"called": None}
        shown = self.cases.get(body["shown"])
        begun = body["busy"] or (shown and shown.state == "draft")
        return {"called": {"case": open_ones[-1], "label": self.cases[open_ones[-1]].label, "room": "Skills lab"},
                "opens": not begun and open_ones[-1] != body["followed"], "other_room": False}

    def file(self, name):
        if name not in self.files:
            made = {"recording": mock_recording.recording, "organ": lambda: mock_recording.organ()[0], "body": lambda: mock_recording.organ()[1],
                    "recording-bare": lambda: mock_recording.recording(picture=False)}[name]()
            self.files[name] = gzip.compress(made, 5)
        return self.files[name]

    def queue(self):
        now_us = 1e6 * time.time()
        lines = [{"case": handle, "label": one.label, "live": one.live, "state": one.state, "estimate_min": 2.5,
                  "due_utc_us": one.due_us, "overdue": bool(one.due_us and one.due_us < now_us and one.state != "submitted")}
                 for handle, one in self.cases.items() if not one.live]
        still = [line for line in lines if line["state"] != "submitted"]
        return {"lines": lines, "waiting": sum(line["state"] == "open" for line in still),
                "drafts": sum(line["state"] == "draft" for line in still),
                "submitted": sum(line["state"] == "submitted" for line in lines),
                "overdue": sum(line["overdue"] for line in lines), "minutes": 2.5 * len(still),
                "in_ten_minutes": min(4, len(still)), "live_called": len(self.called),
                "live_waiting": sum(one.live for one in self.cases.values()) - len(self.ever_called), "next": still[0]["case"] if still else None}

    def whole(self, one):
        return {"label": one.label, "live": one.live, "state": one.state, "length_us": one.length_us,
                "kept_at": "server", "digest": "ab12cd34",
                "task": {"untwisting": False, "target_deg": 180.0, "tolerance_deg": 5.0, "hold_s": 2.0,
                         "least_twists": 1, "force": {"limit": 3.5, "unit": "N", "decimals": 2},
                         "torque": {"limit": None, "unit": "N m", "decimals": 3}},
                "rules": {"minimum_watched": 0.8, "speeds": [0.5, 1]}, "rubric": one.rubric,
                "sheet": one.sheet,
                "watched": one.watched, "share": one.share(), "worked_us": one.worked_us, "remarks": one.remarks,
                "versions": one.versions, "panel_open": False, "check": one.check()}

    def take(self, one, sheet):
        if sheet["revision"] != one.sheet["revision"]:
            raise Refused(409, "This sheet was changed elsewhere", sheet=one.sheet)
        one.sheet = copy.deepcopy(sheet)
        one.sheet["revision"] += 1

    def signed(self, who, password):
        if password == self.passwords[who]:
            return
        if password:
            raise Refused(403, "The password is wrong", need_password=True, meaning="I scored this case")
        if self.asks_password:
            raise Refused(403, "The signature asks for the password", need_password=True, meaning="I scored this case")

    # Each route: (method, pattern, needs a session, function).
    def sign_in(self, body, _who):
        if self.passwords.get(body["login"]) != body["password"]:
            self.wrong += 1
            if self.wrong >= 5:
                raise Refused(429, "Too many wrong tries", wait_s=3)
            raise Refused(401, "Name or password is wrong", remedy="Try again")
        self.wrong = 0
        if body["login"] in self.must_change:
            return {"outcome": "must_change"}
        token = secrets.token_urlsafe(24)
        cookie = secrets.token_urlsafe(24)
        self.sessions[cookie] = (body["login"], token)
        return {"token": token, "user": self.user(body["login"]), "outcome": "ok", "cookie": cookie}

    @staticmethod
    def user(login):
        if login == "office":
            return {"login": login, "roles": ["administrator"], "pages": ["board", "people"]}
        return {"login": login, "roles": ["rater"], "pages": ["queue"]}

    def join(self, body, who):
        if body["token"] != INVITATION:
            raise Refused(401, "This invitation is not good, or not any more", remedy="Ask for a new one")
        self.passwords["rater"] = body["newPassword"]
        return self.sign_in({"login": "rater", "password": body["newPassword"]}, who)

    def own_sessions(self, _body, who):
        return {"sessions": [{"id": cookie, "browser": "Firefox, Linux", "begun_s": 130, "idle_s": 0, "this": len(self.sessions) == 1}
                             for cookie, (login, _token) in self.sessions.items() if login == who]}

    def password(self, body, who):
        if len(body["newPassword"]) < 15:
            raise Refused(400, "A password has at least fifteen characters")
        self.passwords[body["login"]] = body["newPassword"]
        self.must_change.discard(body["login"])
        return self.sign_in({"login": body["login"], "password": body["newPassword"]}, who)

    def save(self, body, _who, handle):
        one = self.cases[handle]
        self.take(one, body)
        one.state = "draft"
        self.saves += 1
        return {"revision": one.sheet["revision"], "check": one.check()}

    def viewing(self, body, _who, handle):
        one = self.cases[handle]
        one.play(body["played"])
        return {"watched": one.watched, "share": one.share(), "worked_us": one.worked_us, "check": one.check()}

    def submit(self, body, who, handle):
        one = self.cases[handle]
        self.take(one, body["sheet"])
        if not one.check()["may_submit"]:
            one.sheet["revision"] -= 1
            raise Refused(400, "The sheet is not complete")
        try:
            self.signed(who, body.get("password"))
        except Refused:
            one.sheet["revision"] -= 1
            raise
        one.state = "submitted"
        one.versions = [{"version": 1, "submitted_utc_us": round(1e6 * time.time()), "reason": "",
                         "overall_steps": one.sheet["overall_steps"]}]
        return {"next": self.queue()["next"]}

    def amend(self, body, who, handle):
        one = self.cases[handle]
        if not body["reason"]:
            raise Refused(400, "An amendment needs a reason", remedy="Say why the mark is changed")
        self.signed(who, body.get("password"))
        one.sheet = copy.deepcopy(body["sheet"])
        one.versions.append({"version": len(one.versions) + 1, "submitted_utc_us": round(1e6 * time.time()),
                             "reason": body["reason"], "overall_steps": one.sheet["overall_steps"]})
        return {}

    def add_remark(self, body, _who, handle):
        one = self.cases[handle]
        one.remarks.append({"id": secrets.token_hex(4), "time_us": body["time_us"], "text": body["text"]})
        one.remarks.sort(key=lambda each: each["time_us"])
        return {"remarks": one.remarks}

    def edit_remark(self, body, _who, handle, remark):
        for each in self.cases[handle].remarks:
            if each["id"] == remark:
                each["text"] = body["text"]
        return {"remarks": self.cases[handle].remarks}

    def me(self, _body, who):
        token = next(token for login, token in self.sessions.values() if login == who)
        return {"token": token, "user": self.user(who), "idle_s": self.idle_s}

    def call_trainee(self, label, open_=True):
        """A call as the administrator's board shows it: ten sheets, none is in."""
        self.calls.append({"call": label, "open": open_, "label": label, "trainee": "TR-4100", "occasion": "before", "room": "Skills lab",
                           "asked": 10, "submitted": 0, "raters": [f"P{number}" for number in range(10)]})

    def sheet_arrives(self):
        """Of the newest call."""
        self.calls[-1]["submitted"] += 1
        self.calls[-1]["raters"].pop(0)
        self.missing -= 1

    @staticmethod
    def call_line(one):
        open_, codes = one["open"], ", ".join(one["raters"])
        waiting = "" if open_ and one["submitted"] == 0 else f"still to come: {codes}" if open_ else f"missing: {codes}"
        shown = {name: value for name, value in one.items() if name != "raters"}
        return {**shown, "missing": len(one["raters"]), "missing_text": waiting, "may_cancel": open_ and one["submitted"] == 0}

    def board(self, _body, _who):
        row = {"trainee": "TR-4100", "group": "", "phase": "", "done": False, "withdrawn": False, "left_us": 0, "station": "",
               "occasion": "before", "sheets": str(self.missing), "sheets_missing": self.missing, "deviations": 0, "planned_utc_us": None, "overdue": False}
        return {"name": "Spring", "occasions": [{"code": "pre", "label": "before"}], "alerts": [], "rows": [row], "stations": []}

    ROUTES = [
        ("GET", r"/api/cohorts", True, lambda _self, _body, _who: {"cohorts": [{"cohort": "k1", "name": "Spring"}], "first": 0}),
        ("GET", r"/api/cohorts/k1/board", True, board),
        ("GET", r"/api/cohorts/k1/calls", True, lambda self, _body, _who: {"calls": [self.call_line(one) for one in self.calls]}),
        ("POST", r"/api/cohorts/k1/calls/4B/remind", True, lambda _self, _body, _who: {"text": "Please submit your sheet of case 4B"}),
        ("GET", r"/api/invitations", True, lambda _self, _body, _who: {"people": [], "waiting": [], "mail": False}),
        ("POST", r"/api/sign-in", False, sign_in),
        ("POST", r"/api/password", False, password),
        ("POST", r"/api/join", False, join),
        ("GET", r"/api/sessions", True, own_sessions),
        ("GET", r"/api/me", True, me),
        ("GET", r"/api/queue", True, lambda self, _body, _who: self.queue()),
        ("GET", r"/api/live", True, lambda self, _body, _who: self.live()),
        ("POST", r"/api/live/follow", True, follow),
        ("GET", r"/api/cases/(\w+)", True, lambda self, _body, _who, handle: self.whole(self.cases[handle])),
        ("PUT", r"/api/cases/(\w+)/sheet", True, save),
        ("POST", r"/api/cases/(\w+)/viewing", True, viewing),
        ("POST", r"/api/cases/(\w+)/submit", True, submit),
        ("POST", r"/api/cases/(\w+)/amend", True, amend),
        ("POST", r"/api/cases/(\w+)/remarks", True, add_remark),
        ("PUT", r"/api/cases/(\w+)/remarks/(\w+)", True, edit_remark),
    ]


class Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    desk = None
    chinese = translations()

    def log_message(self, *_):
        pass

    def send(self, status, body, kind, headers=()):
        self.send_response(status)
        for name, value in (("Content-Type", kind), ("Content-Length", str(len(body))), ("Cache-Control", "no-store"),
                            ("Content-Security-Policy", POLICY), ("X-Content-Type-Options", "nosniff"),
                            ("Referrer-Policy", "no-referrer"), *headers):
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(body)

    def answer(self, value, status=200, headers=()):
        if self.desk.loses_answers:
            self.close_connection = True
            self.connection.close()
            return
        self.send(status, json.dumps(value).encode(), "application/json", headers)

    def cookie(self):
        return re.sub(r".*torsio=([^;]*).*", r"\1", self.headers.get("Cookie", ""))

    def handle_any(self):
        body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
        while self.desk.silent and self.path.startswith("/api/"):
            time.sleep(0.05)
        if self.desk.away and self.path.startswith("/api/"):
            self.close_connection = True
            self.connection.close()
            return
        waits = re.fullmatch(r"/api/live/(\d+)", self.path)
        if waits and self.cookie() in self.desk.sessions:
            return self.wait(waits[1])
        try:
            with self.desk.lock:
                self.route(json.loads(body) if body else {})
        except Refused as refused:
            error = {"code": "refused", "what": refused.what, "where": "", "remedy": refused.more.pop("remedy", "")}
            if "wait_s" in refused.more:
                error["wait_s"] = refused.more.pop("wait_s")
            self.answer({"error": error, **refused.more}, refused.status)

    def wait(self, stamp):
        end = time.monotonic() + 5
        while time.monotonic() < end and not self.desk.away:
            live = self.desk.live()
            if live["stamp"] != stamp:
                return self.answer(live)
            time.sleep(0.05)
        self.send(204, b"", "application/json")

    def route(self, body):
        if not self.path.startswith("/api/"):
            return self.page()
        if self.path == "/api/texts":
            chinese = self.headers.get("X-Torsio-Language") == "zh_CN"
            return self.answer({"language": "zh_CN" if chinese else "en", "texts": self.chinese if chinese else {},
                                "centre": "Made-up Centre", "languages": ["en", "zh_CN"]})
        who, token = self.desk.sessions.get(self.cookie(), (None, None))
        if self.path == "/api/sign-out":
            self.desk.sessions.pop(self.cookie(), None)
            return self.answer({})
        if self.command != "GET" and self.desk.refusing:
            raise Refused(503, "The server is busy")
        sent = re.fullmatch(r"/api/cases/(\w+)/(recording|organ)", self.path)
        if sent and who:
            name = sent[2]
            if name == "recording" and not self.desk.cases[sent[1]].picture:
                name = "recording-bare"
            return self.send(200, self.desk.file(name), "application/octet-stream", [("Content-Encoding", "gzip")])
        if self.path == "/api/organs/body" and who:
            return self.send(200, self.desk.file("body"), "application/octet-stream", [("Content-Encoding", "gzip")])
        for method, pattern, closed, function in Desk.ROUTES:
            found = re.fullmatch(pattern, self.path)
            if not found or method != self.command:
                continue
            if closed and not who:
                raise Refused(401, "Nobody is signed in")
            if closed and method != "GET" and self.headers.get("X-Torsio-Token") != token:
                raise Refused(403, "The token is not that of the session")
            if found.groups() and found[1] not in self.desk.cases:
                raise Refused(404, "There is no such case", remedy="Open it from the queue")
            made = function(self.desk, body, who, *found.groups())
            if "rubric" in made and self.headers.get("X-Torsio-Language") == "zh_CN":
                made["rubric"] = shipped_rubric(lambda text: self.chinese.get(text, text))
            fresh = made.pop("cookie", None)
            cookie = [("Set-Cookie", f"torsio={fresh}; HttpOnly; SameSite=Strict; Path=/")] if fresh else ()
            return self.answer(made, headers=cookie)
        raise Refused(404, "There is nothing here")

    def page(self):
        if self.path.startswith("/measured/"):
            return self.send(200, self.desk.measured[self.path.rsplit("/", 1)[1]], "application/octet-stream")
        path = (PAGES / ("index.html" if self.path in ("/", "/join") else self.path.lstrip("/"))).resolve()
        if self.path == "/quick_tissue.frag":
            path = SHADERS / "quick_tissue.frag"
        elif PAGES not in path.parents or not path.is_file():
            raise Refused(404, "There is nothing here")
        return self.send(200, path.read_bytes(), KINDS.get(path.suffix, "text/plain"))

    do_GET = do_POST = do_PUT = handle_any


class Server(ThreadingHTTPServer):
    def handle_error(self, request, client_address):
        if not isinstance(sys.exc_info()[1], ConnectionError):  # a browser may disconnect at any time
            super().handle_error(request, client_address)


def start(port=0, measured=None):
    """Returns (server, desk), running in its own thread. `measured`: name -> bytes of /measured/NAME."""
    desk = Desk()
    desk.measured = measured or {}
    server = Server(("127.0.0.1", port), type("Bound", (Handler,), {"desk": desk}))
    server.daemon_threads = True
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server, desk


if __name__ == "__main__":
    running, _ = start(int(sys.argv[1]) if len(sys.argv) > 1 else 8800)
    print(f"http://127.0.0.1:{running.server_port}/")
    threading.Event().wait()
