"""Pages for browsers: made by the program, opened like cards, computed by the engine under node."""

import http.server
import json
import os
import queue
import re
import shutil
import subprocess
import threading
import unittest

from program import BAD_INPUT, ROOT, ProgramTest

CREATURES = ROOT / "assets/creatures"
ENGINE = os.environ.get("ENGINE", "")
SMALL = """[population]
size = 20
[trial]
duration = 4
"""


BROWSERS = {
    "chromium": ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--user-data-dir={}"],
    "firefox": ["firefox", "--headless", "--no-remote", "--profile", "{}"],
}


class Page(ProgramTest):
    def said_in(self, browser, html, script):
        """What the script says to `say` in a browser that shows the page."""
        said = queue.Queue()

        class Server(http.server.BaseHTTPRequestHandler):
            def do_GET(self):
                self.send_response(200)
                self.send_header("Content-Type", "text/html; charset=utf-8")
                self.end_headers()
                self.wfile.write(shown if self.path == "/x.html" else b"")

            def do_POST(self):
                said.put(self.rfile.read(int(self.headers["Content-Length"])).decode())
                self.send_response(204)
                self.end_headers()

            def log_message(self, *_):
                pass

        # The page itself forbids every connection.
        html, count = re.subn(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", html)
        self.assertEqual(count, 1)
        say = "const say = words => fetch('/said', { method: 'POST', body: words });"
        shown = html.replace("</body>", f"<script>{say}\n{script}</script></body>").encode()
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Server)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        profile = self.folder / browser
        profile.mkdir()
        command = [part.format(profile) for part in BROWSERS[browser]]
        shows = subprocess.Popen([*command, f"http://127.0.0.1:{server.server_port}/x.html"],
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                 env={**os.environ, "HOME": str(profile)})
        try:
            return said.get(timeout=240)
        finally:
            shows.terminate()
            shows.wait()
            server.shutdown()
            server.server_close()

    def page(self, *arguments):
        self.run_well("page", *arguments, "-o", "x.html")
        return (self.folder / "x.html").read_text()

    def test_a_page_of_a_creature_is_verified_like_its_file(self):
        self.page(CREATURES / "walker.creature.json")
        self.assertIn("replay verified", self.run_well("verify", "x.html").stdout)
        simulated = [json.loads(self.run_well("simulate", file, "--json").stdout)
                     for file in ["x.html", CREATURES / "walker.creature.json"]]
        self.assertEqual(simulated[0]["trajectory"], simulated[1]["trajectory"])

    def test_a_page_of_a_run_has_its_champions_the_last_one_first(self):
        self.write("small.toml", SMALL)
        self.run_well("evolve", "small.toml", "-n", 15, "-o", "run.cambrian")
        html = self.page("run.cambrian")
        page = json.loads(re.search(r'id="page">(.*?)</script>', html, re.S)[1])
        labels = [creature["label"] for creature in page["creatures"]]
        self.assertEqual(labels[0], "generation 14")
        self.assertEqual(labels[-1], "generation 0")
        self.assertEqual(len(labels), 12)
        for creature in page["creatures"]:
            self.assertEqual(html.count(f'id="{creature["id"]}"'), 1)
        self.assertIn("replay verified", self.run_well("verify", "x.html").stdout)
        rows = page["course"]["rows"]
        self.assertEqual([row[0] for row in rows], list(range(15)))
        told = self.run_well("export", "run.cambrian", "--stats").stdout.splitlines()
        best = told[0].split(",").index("best")
        self.assertEqual([row[1] for row in rows],
                         [float(line.split(",")[best]) for line in told[1:]])
        self.run_well("render", "run.cambrian", "-o", "y.html")
        self.assertEqual((self.folder / "y.html").read_text(), html)
        refused = self.run_program("render", "run.cambrian", "-o", "z.html", "--fps", 20)
        self.assertEqual(refused.returncode, BAD_INPUT)
        self.assertFalse((self.folder / "z.html").exists())

    @unittest.skipUnless(shutil.which("chromium"), "needs a browser")
    def test_a_browser_draws_the_curve_and_shows_the_champion_that_is_pressed(self):
        self.write("small.toml", SMALL)
        self.run_well("evolve", "small.toml", "-n", 3, "-o", "run.cambrian")
        press = """const wait = setInterval(() => {
  if ($('course').hidden) return;
  clearInterval(wait);
  choose(2);
  say($('course-text').textContent + document.querySelector('[aria-pressed=true]').textContent);
}, 20);"""
        said = self.said_in("chromium", self.page("run.cambrian"), press)
        self.assertRegex(said, r"^Best and median of each generation. The last, 2.*generation 0$")

    @unittest.skipUnless(os.path.exists(ENGINE), "needs the engine of pages")
    def test_browsers_evolve_what_the_program_evolves_and_verify_its_best(self):
        self.write("small.toml", SMALL)
        html = self.page("--evolve", "small.toml", "--seed", 7)
        wait = """$('workers').value = 3;
startEvolution();
const wait = setInterval(() => {
  const now = $('equal').textContent + ' ' + $('verdict').textContent;
  if (!now.startsWith('All 3 generations') || now.includes('Computing')) return;
  clearInterval(wait);
  say(now);
}, 50);"""
        wait = "setTimeout(() => { " + wait + " }, 1000);"
        for browser in filter(shutil.which, BROWSERS):
            self.assertEqual(self.said_in(browser, html, wait),
                             "All 3 generations equal those of the program that made this page. "
                             "The same bits in your browser.", browser)

    @unittest.skipUnless(shutil.which("chromium"), "needs a browser")
    def test_an_address_names_one_of_several_creatures(self):
        files = [CREATURES / f"{name}.creature.json" for name in ["walker", "manta", "frog"]]
        html = self.page(*files)
        wait = """const wait = setInterval(() => {
  if (!body) return;
  clearInterval(wait);
  location.hash = '#Frog';
  setTimeout(() => say(['frog', $('name').textContent, location.hash, body.parts.length].join()), 300);
}, 20);"""
        self.assertEqual(self.said_in("chromium", html, wait), "frog,Frog,#Frog,5")

    def test_the_page_of_the_first_page_has_the_samples_as_they_are(self):
        html = (ROOT / "assets/gallery/creatures.html").read_text()
        self.assertLess(len(html), 1_000_000)
        page = json.loads(re.search(r'id="page">(.*?)</script>', html, re.S)[1])
        linked = re.findall(r"creatures\.html#(\w+)", (ROOT / "README.md").read_text())
        self.assertEqual([creature["label"] for creature in page["creatures"]], linked)
        self.assertEqual(len(linked), 12)
        for creature in page["creatures"]:
            inside = re.search(rf'id="{creature["id"]}">(.*?)</script>', html, re.S)[1]
            sample = CREATURES / f'{creature["label"].lower()}.creature.json'
            self.assertEqual(json.loads(inside), json.loads(sample.read_text()), sample)

    def test_what_no_page_can_show_is_refused(self):
        for arguments in [["page", "-o", "x.html"], ["page", "missing.json", "-o", "x.html"],
                          ["page", CREATURES / "walker.creature.json", "-o", "x.png"]]:
            result = self.run_program(*arguments)
            self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
            self.assertFalse((self.folder / "x.html").exists())
        self.write("empty.html", "<!doctype html><p>nothing</p>")
        result = self.run_program("verify", "empty.html")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("a page without a creature inside", result.stderr)

    @unittest.skipUnless(os.path.exists(ENGINE) and shutil.which("node"),
                         "needs the engine of pages and node")
    def test_the_engine_of_pages_computes_every_sample_and_an_evolution_to_the_last_bit(self):
        self.write("small.toml", SMALL)
        html = self.page("--evolve", "small.toml", "--seed", 7)
        self.assertGreater(len(re.search(r'id="engine">(.*?)</script>', html, re.S)[1]), 300000)
        done = subprocess.run(["node", ROOT / "tests/page/engine_test.mjs", self.folder / "x.html",
                               *sorted(CREATURES.glob("*.json"))],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("3 generations evolved by 3 workers", done.stdout)


if __name__ == "__main__":
    unittest.main()
