#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of the review desk in a headless Chromium, against the mock of the server. `review_desk_test.py [--firefox]
[NAME ...]` runs all scenarios or those whose names contain a word; exit status 1 on failure, 77 if there is no
such browser."""
import gzip
import json
import re
import shutil
import sys
import time
import traceback

import mock_server
from webdriver import Browser, Failed, Firefox

WHOLE = [[0, 20_000_000]]


def check(what, holds):
    if not holds:
        raise Failed(what)


def sign_in(browser, url, login="rater"):
    browser.open(url)
    browser.there("[name=login]")
    browser.keys(login, "Tab", mock_server.PASSWORD, "Enter")


def open_case(browser, url, handle="c1"):
    sign_in(browser, url)
    browser.there(".cases")
    browser.open(f"{url}#case/{handle}")
    browser.there(".strip")


def marks(desk, handle="c1"):
    sheet = desk.cases[handle].sheet
    return [row["score_steps"] for row in sheet["rows"]] + [sheet["overall_steps"]]


def saved(browser, desk, expected, handle="c1"):
    browser.until(f"{expected} at the server", lambda: marks(desk, handle) == expected)
    browser.says(".saved", "Saved")


def focused(browser):
    return browser.run("const e = document.activeElement; return e.getAttribute('aria-labelledby') ? "
                       "document.getElementById(e.getAttribute('aria-labelledby')).innerText : e.id || e.className")


def test_sign_in(browser, url, desk):
    browser.open(url)
    browser.there("[name=login]")
    check("nothing is shown before the sign-in", browser.text(".cases") == "")
    browser.keys("rater", "Tab", "wrong", "Enter")
    browser.says("[role=alert]", "Name or password is wrong")
    browser.keys(mock_server.PASSWORD, "Enter")  # the wrong entry is selected
    browser.there(".cases")
    browser.says(".figures", "3 cases fit into ten minutes")
    browser.says("main", "On the real arm: 1 still to be called; the sheet opens by itself")
    browser.reload()
    browser.there(".cases")
    browser.click(".top button")
    browser.there("[name=login]")
    check("the session is ended", not desk.sessions)


def test_a_busy_server_is_asked_again(browser, url, desk):
    browser.open(url)
    browser.there("[name=login]")
    desk.refusing = True
    desk.away = True
    browser.keys("rater", "Tab", mock_server.PASSWORD, "Enter")
    browser.says("[role=alert]", "Trying again by itself")
    desk.away = False
    browser.says("[role=alert]", "The server is busy")
    desk.refusing = False
    browser.there(".cases")


def test_a_called_sheet_opens_by_itself(browser, url, desk):
    sign_in(browser, url)
    browser.there(".cases")
    begun = time.monotonic()
    desk.call("c4")
    browser.says("h1", "Live sheet")
    browser.there(".live-sheet .strip")
    check("within two seconds", time.monotonic() - begun < 2)
    browser.says(".live-sheet", "Case 4B")
    check("there is no player", not browser.run("return document.querySelector('.transport')"))
    browser.keys("7", "Tab", "7", "Tab", "7")
    browser.says(".order", "draft, called now")
    browser.keys("Tab", "7", "Control+Enter", "Control+Enter")
    browser.says("dialog", "I scored this case")
    browser.keys(mock_server.PASSWORD, "Enter")
    browser.until("sealed", lambda: desk.cases["c4"].state == "submitted")
    browser.says(".order", "submitted")


def submit_live(browser, desk, handle):
    desk.asks_password = False
    browser.keys("7", "Tab", "7", "Tab", "7", "Tab", "7")
    saved(browser, desk, [70, 70, 70, 70], handle)
    browser.keys("Control+Enter", "Control+Enter")
    browser.until("sealed", lambda: desk.cases[handle].state == "submitted")


def test_a_late_sheet_does_not_open_by_itself(browser, url, desk):
    desk.cases["c5"] = mock_server.Case("5D", desk.rubric, live=True)
    desk.cases["c6"] = mock_server.Case("6E", desk.rubric, live=True)
    desk.call("c5")
    desk.called.discard("c5")  # its trainee has left the arm
    desk.call("c4")
    sign_in(browser, url)
    browser.says(".live-sheet", "Case 4B")
    submit_live(browser, desk, "c4")
    browser.says(".live-sheet", "Nobody else is called now")
    browser.says(".live-sheet .late", "Case 5D · late, not begun")
    browser.keys("9")
    check("nothing can be scored", not browser.run("return document.querySelector('.live-sheet .strip')"))
    desk.called.clear()
    browser.says(".live-sheet", "Nobody is called now")
    desk.call("c6")
    browser.says(".live-sheet", "Case 6E")
    submit_live(browser, desk, "c6")
    browser.click(".live-sheet .late button")
    browser.says(".live-sheet h1", "Case 5D")
    submit_live(browser, desk, "c5")
    browser.until("none is late", lambda: not browser.run("return document.querySelector('.live-sheet .late')"))
    check("the one that waited is empty no more", marks(desk, "c5")[0] == 70)


def test_the_called_case_is_in_sight(browser, url, desk):
    for number in range(12):
        handle = f"d{number:02}"
        desk.cases[handle] = mock_server.Case(f"{number:02}D", desk.rubric, live=True)
        desk.call(handle)
        desk.called.discard(handle)
    desk.call("d11")
    sign_in(browser, url)
    browser.says(".live-sheet", "Case 11D")
    for width, height in ((320, 640), (390, 640), (1366, 640), (1366, 550)):
        browser.resize(width, height)
        browser.reload()
        browser.says(".live-sheet", "Case 11D")
        gap = browser.run("const line = document.querySelector('.order [aria-current]').getBoundingClientRect();"
                          "const all = document.querySelector('.order').getBoundingClientRect();"
                          "return Math.max(all.left - line.left, line.right - all.right, line.bottom - innerHeight)")
        check(f"the open case is in sight at {width}: {gap}", gap <= 0)
    browser.resize(1280, 800)


def test_nothing_moves_under_a_finger(browser, url, desk):
    """Whatever is said about saving: the sheet keeps its place, in the live page and in a case."""
    desk.call("c4")
    sign_in(browser, url)
    browser.says(".live-sheet", "Case 4B")
    browser.keys("7")
    texts = ["", "Saved", "Saving…", "Not saved yet, trying again", "Draft found and opened", "Not saved yet: sign in again",
             "The server does not answer; marks are kept here"]
    for page in ("#live", "#case/c1"):
        browser.run("location.hash = arguments[0]", page)
        browser.there(".strip")
        for width in (320, 390, 600, 820, 1000, 1024, 1180, 1280, 1366, 1500, 1920, 3840):
            browser.resize(width, 768)
            places = browser.run("return arguments[0].map((text) => { document.querySelector('.saved').textContent = text;"
                                 "return document.querySelector('.strip').getBoundingClientRect().top; })", texts)
            check(f"{page} at {width}: {places}", len(set(places)) == 1)
    browser.resize(1280, 800)


def test_a_server_that_does_not_answer_is_named(browser, url, desk):
    desk.call("c4")
    sign_in(browser, url)
    browser.says(".live-sheet", "Case 4B")
    begun = time.monotonic()
    desk.silent = True
    browser.keys("7")
    browser.says(".saved", "Saving…")
    browser.says(".saved", "The server does not answer; marks are kept here")
    check("after five seconds", 4 < time.monotonic() - begun < 9)
    desk.silent = False
    saved(browser, desk, [70, None, None, None], "c4")


def open_board(browser, url):
    browser.open(url)
    browser.there("[name=login]")
    browser.keys("office", "Tab", mock_server.PASSWORD, "Enter")
    browser.there(".call-form")


def test_the_caller_sees_that_the_desk_is_away(browser, url, desk):
    desk.call_trainee("4B")
    open_board(browser, url)
    browser.says(".called", "● Called")
    for trouble in ("away", "silent"):
        setattr(desk, trouble, True)
        browser.says(".calls", "No connection since ")
        check("with the time", re.search(r"since \d\d:\d\d; what you see may be old", browser.text(".calls")))
        setattr(desk, trouble, False)
        browser.until("it is back", lambda: "No connection" not in browser.text(".calls"))


def test_a_waiting_rater_sees_that_the_desk_is_away(browser, url, desk):
    sign_in(browser, url)
    browser.there(".cases")
    browser.run("location.hash = '#live'")
    browser.says(".live-sheet", "Nobody is called now")
    desk.away = True
    browser.says(".live-left", "No connection since ")
    desk.away = False
    begun = time.monotonic()
    browser.until("it is back", lambda: "No connection" not in browser.text(".live-left"))
    check("at once, not when the next call comes", time.monotonic() - begun < 4.8)
    desk.call("c4")
    browser.says(".live-sheet", "Case 4B")


def test_a_reminder_without_a_clipboard(browser, url, desk):
    desk.call_trainee("4B", open_=False)
    open_board(browser, url)
    browser.run("navigator.clipboard.writeText = () => Promise.reject(new DOMException('refused', 'NotAllowedError'))")
    browser.click(".called button")
    browser.until("the text is selected", lambda: browser.run("return String(getSelection())") == "Please submit your sheet of case 4B"
                  or browser.run("const e = document.activeElement; return e.value?.slice(e.selectionStart, e.selectionEnd)")
                  == "Please submit your sheet of case 4B")
    browser.says(".calls", "Copy this into a message to these raters")
    desk.calls.clear()
    browser.until("it is gone with the call", lambda: "Copy this" not in browser.text(".calls"))
    desk.call_trainee("4B", open_=False)
    browser.run("navigator.clipboard.writeText = (text) => { window.copied = text; return Promise.resolve(); }")
    browser.click(".called button")
    browser.says(".notice", "Copied: paste it into a message to these raters.")
    check("the text is copied", browser.run("return window.copied") == "Please submit your sheet of case 4B")


def test_sheets_of_an_open_call_are_not_missing(browser, url, desk):
    desk.call_trainee("4B")
    desk.missing = 10
    open_board(browser, url)
    browser.says(".called", "0 of 10 sheets in")
    check("none is missing yet", "missing" not in browser.text(".called") and "P0" not in browser.text(".called"))
    begun = time.monotonic()
    desk.sheet_arrives()
    browser.says(".called", "1 of 10 sheets in; still to come: P1, P2")
    browser.says("main", "sheets due and missing: 9")
    check("the board does not lag", time.monotonic() - begun < 5)
    desk.calls[-1]["open"] = False
    browser.says(".called", "1 of 10 sheets in; missing: P1, P2")


def test_a_call_with_a_sheet_is_not_withdrawn(browser, url, desk):
    desk.call_trainee("4B")
    open_board(browser, url)
    browser.there(".cancel-call:enabled")
    desk.sheet_arrives()
    browser.there(".cancel-call:disabled")
    browser.says(".called", "A sheet is in: if it was the wrong person, end the call and report a deviation.")


def test_the_board_goes_on_after_an_outage(browser, url, desk):
    open_board(browser, url)
    desk.away = True
    time.sleep(11)  # it is read every ten seconds
    desk.missing = 7
    desk.away = False
    browser.says("main", "sheets due and missing: 7")


def test_the_open_page_is_in_sight_among_the_tabs(browser, url, desk):
    browser.resize(390, 844)
    open_board(browser, url)
    browser.run("location.hash = '#invitations'")
    browser.says("h1", "Invitations")
    gap = browser.run("const at = document.querySelector('.ways [aria-current]').getBoundingClientRect();"
                      "const all = document.querySelector('.ways').getBoundingClientRect();"
                      "return Math.max(all.left - at.left, at.right - all.right)")
    check(f"the tab is in sight: {gap}", gap <= 0)
    browser.resize(1280, 800)


def test_a_call_waits_for_a_begun_sheet(browser, url, desk):
    for handle in ("c5", "c6"):
        desk.cases[handle] = mock_server.Case("5D" if handle == "c5" else "6E", desk.rubric, live=True)
    desk.call("c4")
    sign_in(browser, url)
    browser.says("h1", "Live sheet")
    browser.says(".live-sheet", "Case 4B")
    browser.keys("8")
    browser.says(".saved", "Saved")
    desk.call("c5")
    browser.says(".other-call", "Case 5D is called now. What you have begun here is kept")
    check("the begun sheet stays", "Case 4B" in browser.text(".live-sheet"))
    browser.click(".order li:nth-child(2) button")
    browser.says(".live-sheet", "Case 5D")
    desk.call("c6")
    browser.says(".live-sheet", "Case 6E")
    check("what was typed is kept", marks(desk, "c4")[0] == 80)


def test_a_live_sheet_survives_the_network(browser, url, desk):
    desk.call("c4")
    sign_in(browser, url)
    browser.says(".live-sheet", "Case 4B")
    desk.away = True
    browser.keys("6", "Tab", "7")
    browser.says(".saved", "Not saved yet, trying again")
    desk.away = False
    saved(browser, desk, [60, 70, None, None], "c4")


def test_a_call_during_a_case_is_announced(browser, url, desk):
    open_case(browser, url)
    browser.keys("5")
    browser.says(".saved", "Saved")
    desk.call("c4")
    browser.says(".notice", "Case 4B is called to the real arm: Skills lab")
    browser.click(".notice button")
    browser.says(".live-sheet", "Case 4B")


def test_a_waiting_live_page_is_not_locked(browser, url, desk):
    desk.idle_s = 2
    desk.call("c4")
    sign_in(browser, url)
    browser.says(".live-sheet", "Case 4B")
    time.sleep(4)
    check("it is open still", not browser.run("return document.querySelector('.gate').checkVisibility()"))


def test_too_many_tries(browser, url, desk):
    desk.wrong = 4
    browser.open(url)
    browser.there("[name=login]")
    browser.keys("rater", "Tab", "wrong", "Enter")
    browser.says("[role=alert]", "Please wait 0:03")
    browser.says("[role=alert]", "You may try again now")


def test_password_must_change(browser, url, desk):
    sign_in(browser, url, "new.rater")
    browser.there("[name=new]")
    browser.keys("too short", "Tab", "too short", "Enter")
    browser.says("[role=alert]", "At least fifteen characters")
    browser.run("document.querySelector('[name=new]').select()")
    browser.keys("a sentence of my own", "Tab", "Control+a", "a sentence of mine", "Enter")
    browser.says("[role=alert]", "The two are not the same yet")
    browser.keys("Control+a", "a sentence of my own", "Enter")
    browser.there(".cases")
    check("it is the new one", desk.passwords["new.rater"] == "a sentence of my own")


def test_keyboard_alone(browser, url, desk):
    desk.cases["c1"].watched = WHOLE
    sign_in(browser, url)
    browser.there(".cases")
    browser.keys("Enter")  # on "Continue"
    browser.there(".strip")
    browser.keys("7", "ArrowRight", "Tab", "1", "0")
    saved(browser, desk, [75, 100, None, None])
    browser.keys("Control+Enter")
    browser.says(".check", "Still open: Operational accuracy, Overall.")
    check("the first open row has the focus", focused(browser) == "Operational accuracy")
    browser.keys("x", "The view is hidden", "Enter", "Tab", "8", "Backspace", "9", "Control+z", "Control+z", "Control+y",
                 "Control+y")
    saved(browser, desk, [75, 100, None, 90])
    check("the reason is there", desk.cases["c1"].sheet["rows"][2]["not_assessable"] == "The view is hidden")
    browser.keys("Alt+m", "Turn more slowly")
    browser.until("the comment", lambda: desk.cases["c1"].sheet["comment"] == "Turn more slowly")
    browser.keys("Tab")
    check("Tab goes round", focused(browser) == "Training time")
    browser.keys("ArrowUp")
    check("so does the arrow", focused(browser) == "Overall")
    browser.keys("Control+Enter")
    browser.says(".check", "Submitting seals the sheet.")
    browser.keys("Control+Enter")
    browser.says("dialog", "I scored this case")
    browser.keys("wrong", "Enter")
    browser.says("dialog [role=alert]", "The password is wrong")
    check("nothing is sealed yet", desk.cases["c1"].state == "draft")
    browser.keys(mock_server.PASSWORD, "Enter")
    browser.until("sealed", lambda: desk.cases["c1"].state == "submitted")
    browser.says("h1", "Case 2K")


def test_signature_given_up(browser, url, desk):
    desk.cases["c1"].watched = WHOLE
    open_case(browser, url)
    browser.keys("5", "Tab", "5", "Tab", "5", "Tab", "5")
    saved(browser, desk, [50, 50, 50, 50])
    browser.keys("Control+Enter", "Control+Enter")
    browser.there("dialog")
    browser.keys("Escape")
    browser.there(".submit:enabled")
    browser.keys("6")
    saved(browser, desk, [50, 50, 50, 60])
    check("nothing is sealed", desk.cases["c1"].state == "draft")


def test_ten_cases_by_keyboard(browser, url, desk):
    desk.asks_password = False
    for i in range(10):
        desk.cases[f"t{i}"] = mock_server.Case(f"T{i}", desk.rubric)
    for handle in ("c1", "c2", "c3", "c4"):
        del desk.cases[handle]
    for one in desk.cases.values():
        one.watched = WHOLE
    sign_in(browser, url)
    browser.there(".cases")
    browser.keys("Enter")
    for i in range(10):
        browser.says("h1", f"Case T{i}")
        browser.there(".strip:focus")
        browser.keys("6", "ArrowDown", "7", "ArrowDown", "8", "ArrowDown", "7", "Control+Enter", "Control+Enter")
        browser.until("sealed", lambda: desk.cases[f"t{i}"].state == "submitted")
    browser.says(".page-head", "All scored")
    check("each has its marks", all(marks(desk, f"t{i}") == [60, 70, 80, 70] for i in range(10)))


def test_network_away(browser, url, desk):
    open_case(browser, url)
    browser.keys("5")
    saved(browser, desk, [50, None, None, None])
    desk.away = True
    browser.keys("ArrowDown", "6", "ArrowDown", "7")
    browser.says(".saved", "Not saved yet, trying again")
    browser.keys("ArrowDown", "8", "Tab", "typed in a tunnel")
    check("nothing came through", marks(desk) == [50, None, None, None])
    desk.away = False
    saved(browser, desk, [50, 60, 70, 80])
    check("the comment came too", desk.cases["c1"].sheet["comment"] == "typed in a tunnel")


def test_answer_lost(browser, url, desk):
    """The server stored the save, but its answer was lost: no conflict is shown."""
    open_case(browser, url)
    browser.keys("5")
    saved(browser, desk, [50, None, None, None])
    desk.loses_answers = True
    browser.keys("ArrowDown", "6")
    browser.until("stored", lambda: marks(desk) == [50, 60, None, None])
    browser.says(".saved", "Not saved yet, trying again")
    browser.keys("ArrowDown", "7")
    desk.loses_answers = False
    saved(browser, desk, [50, 60, 70, None])
    check("no dialog", browser.text("dialog") == "")


def test_busy_server(browser, url, desk):
    open_case(browser, url)
    desk.refusing = True
    browser.keys("5")
    browser.says(".saved", "Not saved yet, trying again")
    desk.refusing = False
    saved(browser, desk, [50, None, None, None])


def change_elsewhere(desk, score_steps):
    there = json.loads(json.dumps(desk.cases["c1"].sheet))
    there["rows"][0]["score_steps"] = score_steps
    there["revision"] += 1
    desk.cases["c1"].sheet = there


def test_conflict(browser, url, desk):
    open_case(browser, url)
    browser.keys("5")
    saved(browser, desk, [50, None, None, None])
    change_elsewhere(desk, 90)
    browser.keys("ArrowDown", "6")
    browser.says("dialog", "This sheet was changed elsewhere")
    browser.says(".saved", "Not saved")
    check("the newer one stands until somebody chose", marks(desk) == [90, None, None, None])
    browser.keys("Escape")
    check("it must be answered", browser.text("dialog") != "")
    browser.click(".keep-mine")
    saved(browser, desk, [50, 60, None, None])
    change_elsewhere(desk, 80)
    browser.keys("ArrowDown", "7")
    browser.there("dialog")
    browser.click(".take-newer")
    browser.says(".row:first-child .value", "8")
    browser.says(".saved", "Saved")
    browser.keys("4")
    saved(browser, desk, [80, 60, 40, None])


def test_reload(browser, url, desk):
    open_case(browser, url)
    browser.keys("5", "ArrowDown", "x", "hidden", "Enter")
    browser.until("saved", lambda: desk.cases["c1"].sheet["rows"][1]["not_assessable"] == "hidden")
    browser.says(".saved", "Saved")
    browser.reload()
    browser.says(".saved", "Draft found and opened")
    check("the mark is there", browser.text(".row:first-child .value") == "5")
    desk.refusing = True
    browser.keys("8")
    browser.says(".saved", "Not saved yet, trying again")
    browser.run("window.addEventListener('beforeunload', (e) => e.stopImmediatePropagation(), {capture: true});"
                "location.reload()")
    browser.says(".row:first-child .value", "8")
    browser.says(".saved", "Not saved yet, trying again")
    desk.refusing = False
    browser.until("saved after the reload", lambda: marks(desk)[0] == 80)
    browser.says(".saved", "Saved")


def test_session_ends(browser, url, desk):
    open_case(browser, url)
    browser.keys("5")
    saved(browser, desk, [50, None, None, None])
    desk.sessions.clear()
    desk.cases = {f"new-{handle}".replace("-", ""): one for handle, one in desk.cases.items()}  # other handles
    browser.keys("ArrowDown", "6")
    browser.there(".gate")
    check("the page is not to be seen", not browser.run("return document.querySelector('.case-page').checkVisibility({visibilityProperty: true})"))
    browser.keys(mock_server.PASSWORD, "Enter")
    saved(browser, desk, [50, 60, None, None], "newc1")
    check("the address is that of the case", browser.run("return location.hash") == "#case/newc1")
    browser.keys("ArrowDown", "7")
    saved(browser, desk, [50, 60, 70, None], "newc1")


def test_idle_lock(browser, url, desk):
    desk.idle_s = 4
    open_case(browser, url)
    browser.keys("5", "Tab", "Tab", "Tab", "Tab", "half a sentence")
    browser.says(".notice", "Press any key to stay")
    browser.there(".gate")
    browser.until("the server ended the session", lambda: not desk.sessions)
    check("what was typed is stored", desk.cases["c1"].sheet["comment"] == "half a sentence")
    browser.says(".gate", "rater is signed in here")
    browser.keys(mock_server.PASSWORD, "Enter")
    browser.until("the page is back", lambda: browser.run("return document.querySelector('.gate').hidden"))
    browser.keys(" and the rest")
    browser.until("typed on", lambda: desk.cases["c1"].sheet["comment"] == "half a sentence and the rest")


def test_idle_lock_without_network(browser, url, desk):
    desk.idle_s = 4
    open_case(browser, url)
    desk.away = True
    browser.keys("5", "ArrowDown", "6")
    browser.there(".gate")
    check("it is not at the server yet", marks(desk) == [None, None, None, None])
    desk.away = False
    browser.keys(mock_server.PASSWORD, "Enter")
    saved(browser, desk, [50, 60, None, None])


def test_left_while_the_network_is_away(browser, url, desk):
    """The draft is still saved from the queue, and another page of the same case does not overtake it."""
    open_case(browser, url)
    desk.refusing = True
    browser.keys("5")
    browser.says(".saved", "Not saved yet")
    browser.run("location.hash = ''")
    browser.there(".cases")
    desk.refusing = False
    browser.until("saved from the queue", lambda: marks(desk)[0] == 50)
    desk.refusing = True
    browser.run("location.hash = '#case/c1'")
    browser.there(".strip")
    browser.keys("6")
    browser.says(".saved", "Not saved yet")
    browser.run("location.hash = ''")
    browser.there(".cases")
    browser.run("location.hash = '#case/c1'")
    browser.says(".row .value", "6")
    desk.refusing = False
    saved(browser, desk, [60, None, None, None])


def test_touch(browser, url, desk):
    open_case(browser, url)
    browser.says(".sentence", "traces are complete")
    browser.tap(".row:nth-child(2) .cell:nth-child(4)")
    saved(browser, desk, [None, 40, None, None])
    browser.tap(".row:nth-child(2) [aria-label$='half a point more']")
    saved(browser, desk, [None, 45, None, None])
    browser.tap(".traces", 0.5)
    browser.until("the playhead is in the middle", lambda: "0:09" in browser.text(".time") or "0:10" in browser.text(".time"))


def test_without_webgl(browser, url, desk):
    open_case(browser, url)
    browser.says(".sentence", "This browser draws nothing in three dimensions")
    browser.until("eight moments are drawn", lambda: browser.run("""
      const all = [...document.querySelectorAll('.film canvas')];
      return all.length === 8 && all.every((one) => {
        const bytes = one.getContext('2d').getImageData(0, 0, one.width, one.height).data;
        return bytes.filter((value, i) => i % 4 === 3 && value > 0).length > 0.02 * one.width * one.height;
      });"""))
    browser.click(".film li:nth-child(5) button")
    browser.says(".time", "0:11.4 of 0:20.0")
    check("the moment is marked", browser.run("return document.querySelector('.film [aria-current]').innerText") == "0:11.4")
    browser.keys("5", "Space")
    browser.says(".transport", "Pause")
    saved(browser, desk, [50, None, None, None])


def drawn(browser):
    """The stage as 64 x 40 pixels: the share that differs from the background, and the pixels."""
    return browser.run("""
      const flat = document.createElement('canvas');
      [flat.width, flat.height] = [64, 40];
      const paint = flat.getContext('2d');
      const stage = document.querySelector('.stage-canvas');
      stage.dispatchEvent(new KeyboardEvent('keydown', {key: arguments[0], bubbles: true}));
      return new Promise((done) => requestAnimationFrame(() => {  // after the stage's own, before the picture is gone
        paint.drawImage(stage, 0, 0, 64, 40);
        const bytes = [...paint.getImageData(0, 0, 64, 40).data];
        done({share: bytes.filter((one, i) => i % 4 === 3 && one > 128).length / 64 / 40, bytes: bytes.join()});
      }));""", "+")


def test_stage(browser, url, desk):
    with type(browser)(webgl=True) as lit:
        open_case(lit, url)
        lit.there(".stage-canvas")
        lit.until("something is drawn", lambda: drawn(lit)["share"] > 0.02)
        check("and not everything", drawn(lit)["share"] < 0.9)
        before = drawn(lit)["bytes"]
        lit.keys("End", "j", "j")  # the organ is twisted there
        lit.says(".time", "0:10")
        check("the organ follows the time", drawn(lit)["bytes"] != before)
        check(f"the console is silent: {lit.faults()}", not lit.faults())


def test_player(browser, url, desk):
    open_case(browser, url)
    browser.says(".sentence", "traces are complete")
    browser.keys("Space")
    browser.until("the server heard of it", lambda: desk.cases["c1"].share() > 0.1)
    browser.says(".transport", "Pause")
    browser.keys("k")
    browser.says(".transport", "Play")
    at = browser.text(".time")
    browser.keys("End")
    browser.says(".time", "0:20.0 of 0:20.0")
    browser.keys("j")
    browser.says(".time", "0:15.0 of 0:20.0")
    browser.keys("Home", "b")
    browser.until("a bookmark", lambda: desk.cases["c1"].remarks)
    browser.keys("r", "Look at the grip here", "Enter")
    browser.says(".remarks", "Look at the grip here")
    browser.keys("R", "Control+a", "Look at the jaw", "Enter")
    browser.says(".remarks", "Look at the jaw")
    check("seeking is not watching", desk.cases["c1"].share() < 0.6 and at != "")


def test_recording_refused(browser, url, desk):
    desk.files["recording"] = gzip.compress(b"TRS1 that breaks off")
    open_case(browser, url)
    browser.says(".sentence", "The recording could not be opened.")
    browser.keys("5")
    saved(browser, desk, [50, None, None, None])
    del desk.files["recording"]
    browser.click(".sentence button")
    browser.until("the traces are there", lambda: "of 0:20" in browser.text(".time"))


def test_mouse_leaves_the_keyboard_in_the_sheet(browser, url, desk):
    open_case(browser, url)
    browser.until("the traces are there", lambda: "of 0:20" in browser.text(".time"))
    browser.keys("5")
    browser.click(".traces")
    browser.says(".time", "0:")
    browser.click(".play")
    browser.keys("ArrowRight")
    saved(browser, desk, [55, None, None, None])


def test_amend(browser, url, desk):
    one = desk.cases["c1"]
    one.watched, one.state = WHOLE, "submitted"
    for row in one.sheet["rows"]:
        row["score_steps"] = 50
    one.sheet["overall_steps"] = 50
    open_case(browser, url)
    browser.says(".check", "submitted and sealed")
    browser.keys("9")
    check("a sealed sheet is read only", browser.text(".row .value") == "5")
    browser.click(".amend")
    browser.keys("9")
    browser.says(".row .value", "9")
    check("the sealed one stands", marks(desk) == [50, 50, 50, 50])
    browser.keys("Control+Enter")
    browser.says(".submit-bar", "Say why the mark is changed.")
    browser.keys("mistyped", "Control+Enter")
    browser.there("dialog")
    browser.keys(mock_server.PASSWORD, "Enter")
    browser.until("amended", lambda: marks(desk) == [90, 50, 50, 50])
    check("with its reason", one.versions[-1]["reason"] == "mistyped")


def test_traces_alone(browser, url, desk):
    open_case(browser, url, "c3")
    browser.says(".sentence", "The organ of this recording is not on this machine; the traces are complete.")
    browser.keys("5")
    browser.until("scored", lambda: marks(desk, "c3")[0] == 50)


def test_chinese(browser, url, desk):
    browser.open(url)
    browser.run("localStorage.setItem('torsio.language', 'zh_CN')")
    open_case(browser, url)
    check("the page says its language", browser.run("return document.documentElement.lang") == "zh-CN")
    browser.there(".sentence")
    browser.click(".keys summary")
    browser.keys("x", "see", "Enter", "Control+Enter")
    shown = browser.text("body")
    for attribute in ("title", "placeholder", "aria-label"):
        shown += "\n" + "\n".join(browser.run(
            "return [...document.querySelectorAll(`[${arguments[0]}]`)].map((e) => e.getAttribute(arguments[0]))", attribute))
    known = r"Torsio|English|Made-up Centre|rater|ab12cd34|Ctrl|Enter|Shift|Backspace|Home|End|Tab|Esc|WebGL|see"
    left = [word for word in re.findall(r"[A-Za-z][A-Za-z' ]{2,}", re.sub(known, "", shown))]
    check(f"no English is left: {left}", not left)


def test_live_states_in_chinese(browser, url, desk):
    desk.cases["c5"] = mock_server.Case("5D", desk.rubric, live=True)
    desk.cases["c4"].state = "submitted"
    desk.call("c4")
    desk.call("c5")
    browser.open(url)
    browser.run("localStorage.setItem('torsio.language', 'zh_CN')")
    sign_in(browser, url)
    browser.there(".live-sheet .strip")
    browser.keys("7")
    browser.says(".order", "5D · 草稿 · 呼叫中")
    browser.says(".order", "4B · 已提交")
    browser.run("localStorage.clear()")


def test_small_and_large(browser, url, desk):
    for width, height in ((320, 640), (768, 1024), (3840, 2160)):
        browser.resize(width, height)
        open_case(browser, url) if width == 320 else browser.open(f"{url}#case/c1")
        browser.there(".strip")
        browser.there(".transport")
        for page in ("#case/c1", "#"):
            browser.run("location.hash = arguments[0]", page)
            browser.there(".strip" if page != "#" else ".cases")
            over = browser.run("return document.documentElement.scrollWidth - document.documentElement.clientWidth")
            check(f"nothing scrolls sideways at {width}: {over}", over <= 0)
    browser.resize(1280, 800)


def out_of_sight(browser, *wanted):
    """Returns those that are not wholly in the window."""
    return browser.run("return arguments[0].filter((css) => { const at = document.querySelector(css).getBoundingClientRect();"
                       "return at.top < 0 || at.bottom > innerHeight; })", list(wanted))


def test_everything_fits_a_low_window(browser, url, desk):
    """As in a browser on a laptop of 1366 by 768: 625 pixels are left."""
    open_case(browser, url)
    desk.call("c4")
    browser.there(".traces")
    for width, height in ((1366, 625), (1024, 600)):
        browser.resize(width, height)
        browser.until("all is in sight", lambda: not out_of_sight(browser, ".play", ".traces", ".last-rows .row", ".submit"))
    browser.run("location.hash = '#live'")
    browser.says(".live-sheet", "Case 4B")
    browser.until("all is in sight", lambda: not out_of_sight(browser, ".last-rows .row", ".submit"))
    browser.resize(3840, 2160)
    browser.run("location.hash = '#case/c1'")
    browser.there(".transport")
    gap = browser.run("const rows = document.querySelector('.rows').lastElementChild.getBoundingClientRect();"
                      "return document.querySelector('.last-rows').getBoundingClientRect().top - rows.bottom")
    check(f"no void before the overall mark: {gap}", gap < 60)
    browser.resize(320, 640)
    browser.run("location.hash = '#'")
    browser.there(".cases")
    tall = browser.run("return document.querySelector('.top').getBoundingClientRect().height")
    check(f"the header leaves room for the page: {tall}", tall < 110)
    browser.resize(1280, 800)


def main():
    kind = Firefox if "--firefox" in sys.argv else Browser
    names = [name for name in sys.argv[1:] if name != "--firefox"]
    scenarios = [(name, function) for name, function in globals().items()
                 if name.startswith("test_") and (not names or any(word in name for word in names))]
    failed = 0
    if shutil.which(kind.PROGRAM) is None:
        print(f"no {kind.PROGRAM} here")
        sys.exit(77)
    with kind(webgl=False) as browser:  # a software renderer takes most of the time
        for name, function in scenarios:
            server, desk = mock_server.start()
            begun = time.monotonic()
            try:
                function(browser, f"http://127.0.0.1:{server.server_port}/", desk)
                faults = browser.faults()
                check(f"the console is silent: {faults}", not faults)
                print(f"ok      {name} {time.monotonic() - begun:.1f} s", flush=True)
            except Exception:  # one scenario must not hide the others
                failed += 1
                print(f"FAILED  {name}\n{traceback.format_exc()}", flush=True)
            server.shutdown()
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
