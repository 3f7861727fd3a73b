#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every page in both themes under axe-core (WCAG 2.2 AA and its best practices): `accessibility_test.py DESK_SERVER
[FOLDER]`. axe-core comes from npm, or from npm's cache, into FOLDER. Exit status 1 on failure, 77 if there
is no chromedriver or axe-core cannot be fetched."""
import contextlib
import pathlib
import shutil
import sys
import tempfile

from real_desk_test import Desk, PAGES, PASSWORD, check
from webdriver import Browser

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parents[1] / "support"))
from npm_packages import node_modules  # noqa: E402

LOCK = HERE.parent / "axe"


def axe_source(folder):
    """Returns an empty text if npm has none and cannot fetch it."""
    modules = node_modules(LOCK, folder)
    return (modules / "axe-core" / "axe.min.js").read_text() if modules else ""


class Judge:
    """Runs axe on a browser's page: all rules in the light theme, colour rules in the dark one."""

    def __init__(self, source):
        self.source, self.pages, self.found = source, 0, []

    def look(self, browser, name):
        for dark in (False, True):
            browser.theme(dark)
            browser.run("return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
            rules = {"runOnly": {"type": "rule", "values": ["color-contrast"]}} if dark else {}
            if not browser.run("return Boolean(window.axe)"):
                browser.run(self.source)
            violations = browser.run("""
                const still = Promise.allSettled(document.getAnimations().map((one) => one.finished)); // no colour on its way
                return still.then(() => axe.run(document, {...arguments[0], resultTypes: ['violations']})).then((all) =>
                  all.violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 160)).join(' | ')}`));""",
                rules)
            self.found += [f"{name}{' (dark)' if dark else ''}: {one}" for one in violations]
        browser.theme(False)
        self.pages += 1


def judge_desk(judge, desk):
    with Browser(webgl=False) as browser:
        browser.open(f"{desk.url}join#{desk.secret}")
        browser.there("[name=new]")
        judge.look(browser, "join")
    for login, own in PAGES.items():
        with Browser(webgl=False) as browser:
            browser.open(desk.url)
            browser.there("[name=login]")
            if login == "office":
                judge.look(browser, "sign-in")
            browser.keys(login, "Tab", PASSWORD, "Enter")
            browser.there("nav.ways")
            for page, title in own.items():
                browser.run("location.hash = arguments[0]", f"#{page}")
                browser.says("h1", title)
                judge.look(browser, page)
            if login == "physician0":
                judge_case(judge, browser)
            if login == "apprentice":
                browser.run("location.hash = '#own'")
                browser.click("main a[href^='#run/']")
                browser.says("main", "Twists")
                judge.look(browser, "run")


def judge_case(judge, browser):
    browser.run("location.hash = '#queue'")
    browser.click(".case:not(.live)")
    browser.there(".strip")
    browser.keys("5", "ArrowDown", "x", "hidden", "Enter")
    browser.says(".saved", "Saved")
    browser.keys("Control+Enter")
    browser.says(".check", "Still open")
    judge.look(browser, "case")
    browser.resize(320, 640)
    judge.look(browser, "case, narrow")


def main():
    if shutil.which(Browser.PROGRAM) is None:
        print(f"no {Browser.PROGRAM} here")
        return 77
    with tempfile.TemporaryDirectory(prefix="torsio-axe-") as away:
        source = axe_source(pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else away))
    if not source:
        print("no axe-core here: npm has none and cannot fetch it")
        return 77
    judge = Judge(source)
    with contextlib.closing(Desk(sys.argv[1])) as desk:
        judge_desk(judge, desk)
    print("\n".join(judge.found) or f"{judge.pages} pages in two themes: nothing found")
    check("every page was looked at", judge.pages >= sum(len(own) for own in PAGES.values()) + 5)
    return 1 if judge.found else 0


if __name__ == "__main__":
    sys.exit(main())
