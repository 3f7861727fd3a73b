#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages in a headless Chromium on the real server: `real_desk_test.py DESK_SERVER [PICTURES]`. Exit status 1 when
something fails, 77 where there is no chromedriver."""
import pathlib
import shutil
import subprocess
import sys
import time

from webdriver import Browser, Failed

PASSWORD = "correct horse battery"


def check(what, holds):
    if not holds:
        raise Failed(what)


def sign_in(browser, url, login):
    browser.open(url)
    browser.there("[name=login]")
    browser.keys(login, "Tab", PASSWORD, "Enter")
    browser.there(".cases")


def drawn_share(browser):
    """The share of the stage that is not its background."""
    return browser.run("""
        const c = document.querySelector('.stage-canvas');
        const flat = document.createElement('canvas');
        flat.width = 64; flat.height = 40;
        const pen = flat.getContext('2d');
        pen.drawImage(c, 0, 0, 64, 40);
        const p = pen.getImageData(0, 0, 64, 40).data;
        let other = 0;
        for (let i = 0; i < p.length; i += 4)
          if (Math.abs(p[i] - p[0]) + Math.abs(p[i + 1] - p[1]) + Math.abs(p[i + 2] - p[2]) > 24) other++;
        return other / (p.length / 4);""")


def score_a_case(browser, url, pictures):
    sign_in(browser, url, "physician0")
    browser.says(".figures", "ten minutes")
    browser.picture(pictures / "queue.png")
    begun = time.monotonic()
    browser.click(".case:not(.live)")
    browser.there(".strip")
    browser.there(".stage-canvas")
    browser.keys("7", "ArrowDown", "8", "ArrowDown", "7")
    browser.says(".saved", "Saved")
    browser.keys("Space")
    browser.until("the recording was watched to its end", lambda: "0:06 of 0:06" in browser.text(".time"))
    browser.picture(pictures / "case.png")
    browser.keys("Control+Enter")
    browser.there(".strip.asking, .submit-bar, [role=dialog]")
    browser.keys("Control+Enter")
    browser.says("body", "sealed")
    print(f"a case: {time.monotonic() - begun:.1f} s")


def find_the_draft(url):
    with Browser() as other:
        sign_in(other, url, "physician0")
        other.click(".case:not(.live)")
        other.there(".strip")
        other.keys("5")
        other.says(".saved", "Saved")
    with Browser() as third:
        sign_in(third, url, "physician0")
        third.says("main", "Continue the draft")


def come_by_invitation(url, secret, pictures):
    """From the link to a sealed case; the person has nothing but the link."""
    begun = time.monotonic()
    with Browser() as browser:
        browser.open(f"{url}join#{secret}")
        browser.there("[name=new]")
        browser.picture(pictures / "join.png")
        browser.keys("too short", "Tab", "too short", "Enter")
        browser.says(".said", "fifteen")
        browser.run("document.querySelectorAll('[type=password]').forEach((one) => { one.value = ''; })")
        browser.keys("seven kites above the bay", "Tab", "seven kites above the bay", "Enter")
        browser.says(".notice", "Your sign-in name is physician1")
        check("the link is left in no address", secret not in browser.run("return location.href"))
        browser.click(".case:not(.live)")
        browser.there(".stage-canvas")
        browser.keys("7", "ArrowDown", "8", "ArrowDown", "7")
        browser.says(".saved", "Saved")
        browser.keys("Space")
        browser.until("the recording was watched to its end", lambda: "0:06 of 0:06" in browser.text(".time"))
        browser.keys("Control+Enter", "Control+Enter")
        browser.says("body", "sealed")
        print(f"from the link to a sealed case: {time.monotonic() - begun:.1f} s")
        check(f"the console is quiet: {browser.faults()}", not browser.faults())
    with Browser() as browser:
        browser.open(f"{url}join#{secret}")
        browser.there("[name=new]")
        browser.keys("another one that is long", "Tab", "another one that is long", "Enter")
        browser.says(".said", "not good")


def look_round(url, pictures):
    """Every page of every role opens, in both languages, without a fault and without sideways scrolling."""
    pages = {"physician0": {"queue": "Your queue", "calibration": "Calibration", "severity": "My severity",
                            "discrepancies": "Discrepancy review",
                            "evaluation": "Evaluation", "sessions": "Your sessions"},
             "apprentice": {"own": "Your record", "remarks": "Remarks", "transcript": "Transcript"},
             "office": {"board": "Today's sessions", "scored": "Who has scored what", "signed-in": "Signed in now"}}
    for login, own in pages.items():
        with Browser(webgl=False) as browser:
            browser.open(url)
            browser.there("[name=login]")
            browser.keys(login, "Tab", PASSWORD, "Enter")
            browser.there("nav.ways")
            for size in ((1280, 800), (320, 640)):
                browser.resize(*size)
                for page, title in own.items():
                    browser.run("location.hash = arguments[0]", f"#{page}")
                    browser.says("h1", title)
                    over = browser.run("return document.documentElement.scrollWidth - document.documentElement.clientWidth")
                    check(f"{page} scrolls sideways at {size}: {over}", over <= 0)
                    browser.picture(pictures / f"{page}-{size[0]}.png")
            if login == "apprentice":
                browser.resize(1280, 800)
                browser.run("location.hash = '#own'")
                browser.click("main a[href^='#run/']")
                browser.says("main", "Twists")
                browser.until("the traces are there", lambda: "of 0:06" in browser.text(".time"))
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
    if shutil.which("chromedriver") is None:
        print("no chromedriver here")
        return 77
    pictures = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ".")
    server = subprocess.Popen([sys.argv[1]], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    url = f"http://127.0.0.1:{server.stdout.readline().strip()}/"
    secret = server.stdout.readline().strip()
    try:
        with Browser() as browser:
            score_a_case(browser, url, pictures)
            check(f"the console is quiet: {browser.faults()}", not browser.faults())
        find_the_draft(url)
        come_by_invitation(url, secret, pictures)
        look_round(url, pictures)
    finally:
        server.stdin.close()
        server.wait()
    return 0


if __name__ == "__main__":
    sys.exit(main())
