#!/usr/bin/env python3
"""Opens every page of the documentation in a headless browser, 420 px wide.

    sh docs/build.sh && python3 tests/docs/check_site.py [FOLDER]

FOLDER is build/docs/html by default. Exits with 77 (skipped) where there is no Chromium. Links to other servers are not followed.
"""

import functools
import http.server
import json
import shutil
import subprocess
import sys
import tempfile
import threading
from pathlib import Path
from urllib.parse import unquote, urldefrag, urlparse

HERE = Path(__file__).resolve().parent
FOLDER = Path(sys.argv[1] if len(sys.argv) > 1 else HERE.parents[1] / "build/docs/html").resolve()


class Site(http.server.SimpleHTTPRequestHandler):
    """The folder, the page that opens all others, and what it reports."""

    report = None
    arrived = threading.Event()

    def do_GET(self):
        if self.path != "/test.html":
            return super().do_GET()
        pages = sorted(str(file.relative_to(FOLDER)) for file in FOLDER.glob("*.html"))
        body = (HERE / "site.html").read_text().replace("of PAGES", f"of {json.dumps(pages)}").encode()
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write(body)

    def do_POST(self):
        Site.report = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.send_response(204)
        self.end_headers()
        Site.arrived.set()

    def log_message(self, *_):
        pass


def opened_in_a_browser(browser):
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Site, directory=FOLDER))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        process = subprocess.Popen(
            [browser, "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run",
             f"--user-data-dir={profile}", f"http://127.0.0.1:{server.server_port}/test.html"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        Site.arrived.wait(timeout=500)
        process.terminate()
        process.wait(timeout=60)
    if Site.report is None:
        sys.exit("the browser has not reported within 500 s")
    return Site.report


def faults_of(report):
    ids = {page["url"]: set(page["ids"]) for page in report["pages"]}
    if report.get("fault"):
        yield report["fault"]
    if len(ids) < 100:
        yield f"only {len(ids)} pages"
    if "Jkr" not in report["search"]:
        yield "the search does not find Jkr"
    for page in report["pages"]:
        url = page["url"]
        if not page["title"]:
            yield f"{url}: has no title"
        if page["wide"] > 0:
            yield f"{url}: {page['wide']} px wider than a screen of 420 px"
        for image in page["images"]:
            if not image["alt"].strip():
                yield f"{url}: {image['src']} has no alt text"
            if not image["shown"]:
                yield f"{url}: {image['src']} cannot be shown"
        for link in sorted(set(page["links"])):
            address, fragment = urldefrag(link)
            parts = urlparse(address)
            if parts.scheme == "javascript" or parts.hostname != "127.0.0.1":
                continue
            target = unquote(parts.path).lstrip("/")
            if not (FOLDER / target).is_file():
                yield f"{url}: links to {target}, which is not there"
            elif fragment and target in ids and unquote(fragment) not in ids[target]:
                yield f"{url}: links to {target}#{fragment}, which is not there"


def main():
    browser = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if browser is None:
        print("skipped: no Chromium")
        sys.exit(77)
    report = opened_in_a_browser(browser)
    faults = list(faults_of(report))
    images = sum(len(page["images"]) for page in report["pages"])
    links = sum(len(page["links"]) for page in report["pages"])
    print(*faults, f"{len(report['pages'])} pages, {images} figures, {links} links, {len(faults)} faults", sep="\n")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
