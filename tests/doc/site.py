"""The site and the manual: every page in a browser at a phone's width and a desk's, links, pictures, formulas, search, versions.

    site.py <tree> <version> [long]      in a folder of the test's own
The short form looks at what needs no tool: the gallery's pictures and decks, and links to headings. The long form builds the site and the manual.
"""
import functools
import http.server
import importlib.util
import json
import pathlib
import re
import subprocess
import sys
import threading

tree, version = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
long = sys.argv[3:] == ["long"]
sys.dont_write_bytecode = True
sys.path.insert(0, str(tree / "scripts/site"))
import build

faults = []


def expect(holds, *words):
    if not holds:
        faults.append(" ".join(map(str, words)))


# The gallery: a picture of a deck that is there, small enough for a phone's line.
gallery = (tree / "share/doc/gallery.md").read_text()
for part in gallery.split("\n## ")[1:]:
    pictures, decks = re.findall(r"!\[[^\]]+\]\(([^)]+)\)", part), re.findall(r"\]\((\S+?\.lua)\)", part)
    expect(pictures and len(decks) == 1, "gallery:", part.split("\n")[0], "has", len(pictures), "pictures,", len(decks), "decks")
    for name in pictures + decks:
        expect((tree / "share/doc" / name).is_file(), "gallery: no", name)
for picture in (tree / "share/doc/figures/gallery").iterdir():
    expect(picture.name in gallery, "gallery: nobody shows", picture.name)
    most = 1_000_000 if picture.name == "fall.png" else 250_000  # the one that moves
    expect(picture.stat().st_size < most, picture.name, f"is larger than {most} bytes")
for deck in (tree / "scripts/gallery").glob("*.lua"):
    expect(deck.name in gallery, "gallery: nobody shows", deck.name)



def anchor(heading):
    return re.sub(r"[^\w\- ]", "", re.sub(r"[`*]", "", heading).strip().lower()).replace(" ", "-")


# Links to headings of other pages and of the same one.
texts = {page: re.sub(r"```.*?```", "", page.read_text(), flags=re.S) for page in [*(tree / "share/doc").rglob("*.md"), *tree.glob("*.md")]}
headings = {page: {anchor(h) for h in re.findall(r"^#+ (.*)$", text, flags=re.M)} for page, text in texts.items()}
for page, text in texts.items():
    for path, mark in re.findall(r"\]\(([^)\s#:]*)#([^)\s]+)\)", text):
        other = (page.parent / path).resolve() if path else page
        expect(mark in headings.get(other, {mark}), page.relative_to(tree), "links to no heading", f"{path}#{mark}")

if faults:
    sys.exit("\n".join(faults))
if not long:
    sys.exit()
absent = build.missing()
if absent:
    print("SKIPPED: the site was not built: apt-get install --no-install-recommends " + " ".join(absent))
    sys.exit(77)

out = pathlib.Path("site").resolve()
(out / "0.0.1").mkdir(parents=True, exist_ok=True)  # an older version beside it
(out / "0.0.1/index.html").write_text("<!DOCTYPE html><title>old</title>old")
build.build(tree, out, version, pdf=True)
expect(build.versions(out) == [version, "0.0.1"], "versions", build.versions(out))

# The pages in a browser, from a server of this test's own. One page visits all others in a frame, and says what it saw.
VISIT = """<!DOCTYPE html><meta charset="utf-8"><body><iframe id="f" style="border:0;height:800px"></iframe><script>
const pages = PAGES, seen = {}, frame = document.getElementById("f");
const load = url => new Promise(done => { frame.onload = () => setTimeout(() => done(frame.contentDocument), 30); frame.src = url; });
(async () => {
  for (const width of WIDTHS) {
    frame.style.width = width + "px";
    for (const page of pages) {
      const doc = await load("/" + page), root = doc.documentElement;
      const s = seen[page] = seen[page] || { widths: {} };
      s.widths[width] = root.scrollWidth;
      if (root.scrollWidth > width) s.wide = [...doc.querySelectorAll("article *")].filter(e => e.getBoundingClientRect().right > width + 1 &&
        !e.closest("pre, .math, .table-wrapper")).slice(0, 3).map(e => e.outerHTML.slice(0, 120));
      s.links = [...doc.querySelectorAll("a[href]")].map(a => a.href);
      s.ids = [...doc.querySelectorAll("[id]")].map(e => e.id);
      s.pictures = [...doc.images].filter(i => !i.complete || i.naturalWidth === 0).map(i => i.src);
      s.formulas = doc.querySelectorAll(".math").length;
      s.drawn = doc.querySelectorAll(".math .katex").length;
      s.wrong = [...doc.querySelectorAll(".katex-error")].map(e => e.title);
      s.versions = [...doc.querySelectorAll("#versions option")].map(o => o.value);
    }
  }
  const doc = await load("/VERSION/search.html?q=drape");
  for (let k = 0; k < 100 && !doc.querySelector("ul.search li"); ++k) await new Promise(r => setTimeout(r, 100));
  seen.search = [...doc.querySelectorAll("ul.search li a")].map(a => a.href);
  await fetch("/seen", { method: "POST", body: JSON.stringify(seen) });
})();
</script>"""

pages = sorted(str(path.relative_to(out)) for path in (out / version).rglob("*.html") if "_static" not in path.parts)
(out / "visit.html").write_text(VISIT.replace("PAGES", json.dumps(pages)).replace("WIDTHS", "[360, 1200]").replace("VERSION", version))
told, ready = {}, threading.Event()


class Server(http.server.SimpleHTTPRequestHandler):
    def do_POST(self):
        told.update(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(204)
        self.end_headers()
        ready.set()

    def log_message(self, *words):
        pass


server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Server, directory=str(out)))
threading.Thread(target=server.serve_forever, daemon=True).start()
address = f"http://127.0.0.1:{server.server_port}"
profile = pathlib.Path("profile").resolve()
browser = subprocess.Popen(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", f"--user-data-dir={profile}",
                            "--remote-debugging-port=0", "--window-size=1400,900", address + "/visit.html"], stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
try:
    expect(ready.wait(1200), "the browser did not come to an end")
finally:
    browser.terminate()
    browser.wait()
    server.shutdown()

search = told.pop("search", [])
expect(any("drape" in url for url in search), "search for 'drape' finds", search)
ids = {page: set(s["ids"]) for page, s in told.items()}
links = 0
for page, s in told.items():
    for width, got in s["widths"].items():
        expect(got <= int(width), page, "is", got, "px wide on", width, "px:", s.get("wide"))
    expect(not s["pictures"], page, "shows no", s["pictures"])
    expect(not s["wrong"] and s["drawn"] >= s["formulas"], page, "formulas:", s["drawn"], "of", s["formulas"], s["wrong"])
    if not page.endswith("search.html"):
        expect(len(s["versions"]) == 2, page, "lists the versions", s["versions"])
    for link in set(s["links"]):
        if not link.startswith(address):
            continue
        links += 1
        path, _, mark = link[len(address) + 1:].partition("#")
        path = path.partition("?")[0]
        target = out / path
        expect(target.is_file() or (target / "index.html").is_file(), page, "dead link", path)
        if mark and path in ids:
            expect(mark in ids[path], page, "dead link", path + "#" + mark)
theory, law = told.get(f"{version}/theory.html", {}), told.get(f"{version}/law.html", {})
expect(theory.get("formulas", 0) > 50 and law.get("formulas", 0) >= 1, "formulas of theory and law:", theory.get("formulas"), law.get("formulas"))
manual = (out / version / "fabricsh-manual.pdf").read_bytes()
count = len(re.findall(rb"/Type\s*/Page\b", manual))
expect(manual.startswith(b"%PDF-") and count > 100, "the manual has", count, "pages")
listed = build.chapter_pages(out / version / "fabricsh-manual.pdf")
shown = dict(re.findall(r'href="(?:index.html)?#(document-[^"]+)"><span[^>]*>[^<]*</span></a><span class="page">(\d+)</span>',
                        (out / ".work/manual/index.html").read_text()))
expect(len(shown) > 40 and all(listed.get(name) == int(page) for name, page in shown.items()), "page numbers of the contents:",
       {name: (page, listed.get(name)) for name, page in shown.items() if listed.get(name) != int(page)} or len(shown))
if faults:
    sys.exit("\n".join(faults))
print(f"{len(told)} pages, {links} links, manual of {count} pages")
