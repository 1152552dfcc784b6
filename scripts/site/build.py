"""The site and the manual out of share/doc: pages laid out for Sphinx, HTML with search, and a PDF by a browser's printer.

    build.py <tree> <out> <version> [--no-pdf]
<out>/<version>/ gets the pages and fabricsh-manual.pdf; <out>/index.html leads to the newest version, and a list on every page to all
versions that stand in <out>. Needs Debian's python3-sphinx, python3-myst-parser, furo, libjs-katex, and for the PDF chromium and
python3-pypdf.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

KATEX = pathlib.Path("/usr/share/javascript/katex")


def missing(pdf=True):
    """Debian's packages that are not there."""
    needed = {"python3-sphinx": shutil.which("sphinx-build"), "python3-myst-parser": _module("myst_parser"), "furo": _module("furo"),
              "libjs-katex": (KATEX / "katex.min.js").exists(), "chromium": shutil.which("chromium") or not pdf,
              "python3-pypdf": _module("pypdf") or not pdf}
    return [name for name, there in needed.items() if not there]


def _module(name):
    import importlib.util

    return importlib.util.find_spec(name) is not None


def slug(title):
    return re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-")


def toctree(caption, names):
    return "```{toctree}\n:hidden:\n:caption: " + caption + "\n\n" + "\n".join(names) + "\n```\n"


def reference(text, folder):
    """The reference a page for each of its parts; returns the first page's text."""
    folder.mkdir()
    head, *parts = re.split(r"^## ", text, flags=re.M)
    kept, names = head, []
    for part in parts:
        title, body = part.split("\n", 1)
        if "\n### " not in body:
            kept += "## " + part
            continue
        name = slug(title)
        names.append("reference/" + name)
        (folder / (name + ".md")).write_text("# " + title + "\n" + re.sub(r"^###", "##", body, flags=re.M))
    listed = "".join(f"- [{name.split('/')[1]}]({name}.md)\n" for name in names)
    return kept + "\n## Parts\n" + listed + "\n```{toctree}\n:hidden:\n\n" + "\n".join(names) + "\n```\n"


def shown_decks(tree, source):
    """Decks that pages link to get a page each, so that they are read in place and found by the search."""
    names = {}
    for page in list(source.rglob("*.md")):
        def page_of(match):
            name = match.group(1)
            deck = "decks/" + name.replace("/", "-")[:-4]
            names[name] = deck
            return "](" + "../" * (len(page.relative_to(source).parts) - 1) + deck + ".md)"

        page.write_text(re.sub(r"\]\((?:\.\./)+scripts/([^)]+\.lua)\)", page_of, page.read_text()))
    (source / "decks").mkdir()
    for name, deck in names.items():
        text = (tree / "scripts" / name).read_text()
        (source / (deck + ".md")).write_text(f"# {name}\n\n`fabricsh scripts/{name}`\n\n```lua\n{text}```\n")
    return sorted(names.values())


def lay_out(tree, source):
    """Everything that Sphinx reads."""
    shutil.rmtree(source, ignore_errors=True)
    shutil.rmtree(source.parent / "static", ignore_errors=True)
    shutil.copytree(tree / "share/doc", source)
    own = {"CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md", "SECURITY.md": "security.md"}
    own = {name: page for name, page in own.items() if (tree / name).exists()}
    for name, page in own.items():
        shutil.copy(tree / name, source / page)
    listing = (source / "README.md").read_text()
    (source / "README.md").unlink()
    # The tables of share/doc/README.md are the order of the pages.
    groups = []
    for heading, table in re.findall(r"^#+ (.*?)\n(.*?)(?=^#|\Z)", listing, flags=re.M | re.S):
        names = re.findall(r"^\| *\[[^\]]*\]\(([^)]+)\.md\)", table, flags=re.M)
        if names:
            groups.append((heading, names))
    of_project = [page[:-3] for page in own.values()]
    if groups and groups[-1][0] == "Project":
        of_project = groups.pop()[1] + of_project
    groups.append(("Project", of_project))
    index = (tree / "README.md").read_text().replace("](share/doc/README.md)", "](#pages)").replace("](share/doc/", "](")
    for name, page in own.items():
        index = index.replace(f"]({name})", f"]({page})")
    # The first tasks stand further up, in README.md.
    pages = re.sub(r"^## Tasks to begin with.*?(?=^## )", "", listing.split("\n", 1)[1], flags=re.M | re.S).replace("\n## ", "\n### ")
    index += "\n## Pages\n" + pages + "\n" + "\n".join(toctree(caption, names) for caption, names in groups)
    decks = shown_decks(tree, source)
    if decks:
        index += "\n" + toctree("Decks", decks)
    (source / "index.md").write_text(index)
    for page in source.rglob("*.md"):
        up = "../" * (len(page.relative_to(source).parts) - 1)
        text = page.read_text()
        text = text.replace("](../../README.md)", f"]({up}index.md)").replace("](README.md)", f"]({up}index.md)")
        for name, its in own.items():
            text = re.sub(rf"\]\((?:\.\./)*{re.escape(name)}\)", f"]({up}{its})", text)
        page.write_text(re.sub(r"\]\((?:\.\./)*share/doc/", f"]({up}", text))
    page = source / "reference.md"
    page.write_text(reference(page.read_text(), source / "reference"))
    # The fonts are links to files of another package.
    shutil.copytree(KATEX, source.parent / "static/katex", ignore=shutil.ignore_patterns("contrib", "*.mjs", "katex.js", "katex.css", "*.ttf"))


def manual(source, out, version):
    """The same pages in one document: a title, contents, and the index as the first chapter."""
    shutil.rmtree(out, ignore_errors=True)
    shutil.copytree(source, out)
    about, *trees = re.split(r"^(?=```\{toctree\})", (out / "index.md").read_text(), flags=re.M)
    about = re.sub(r"\n## Pages\n.*", "\n", about, flags=re.S).replace("](#pages)", "](index.md)")
    (out / "about.md").write_text(re.sub(r"\A# .*", "# What it is for", about))
    groups = [("", ["about"])]
    for tree in trees:
        groups.append((re.search(r"^:caption: (.*)$", tree, flags=re.M).group(1), re.findall(r"^[a-z][\w/-]+$", tree, flags=re.M)))
    contents = "\n".join((f"**{caption}**\n\n" if caption else "") + "".join(f"- [](<{name}.md>)\n" for name in names) for caption, names in groups)
    names = [name for _, names in groups for name in names]
    (out / "index.md").write_text(f"# fabricsh {version}: the manual\n\n<div class=\"contents\">\n\n{contents}\n</div>\n\n" +
                                  toctree("", names).replace(":caption: \n", ""))


def sphinx(builder, source, out, work, version, **more):
    here = pathlib.Path(__file__).resolve().parent
    subprocess.run(["sphinx-build", "-q", "-W", "--keep-going", "-b", builder, "-c", str(here), "-d", str(work / ("doctrees-" + builder)),
                    str(source), str(out)], check=True,
                   env={**os.environ, "FABRICSH_SITE_VERSION": version, "FABRICSH_SITE_STATIC": str(work / "static"), "PYTHONDONTWRITEBYTECODE": "1", **more})


def browser(*options):
    """Chromium without a window; what it prints."""
    return subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", *options], check=True,
                          capture_output=True, text=True).stdout


def chapter_pages(manual):
    """The page, from 1, on which each chapter of the PDF begins, by the name of its anchor."""
    import pypdf

    pdf = pypdf.PdfReader(manual)
    return {name[1:]: pdf.get_destination_page_number(place) + 1 for name, place in pdf.named_destinations.items()}


def print_manual(html, pdf):
    """Browsers cannot write the page of a link's target (CSS target-counter), so the manual is printed twice: the first printing says
    on which pages the chapters begin. The numbers have a column of their own, so that they move nothing."""
    link = re.compile(r'(href="(?:index\.html)?#(document-[^"]+)">.*?</a>)')
    text = html.read_text()
    start, end = re.search(r'<div class="contents">.*?</div>', text, flags=re.S).span()
    pages = {}
    for _ in range(2):
        listed = link.sub(lambda m: f'{m[1]}<span class="page">{pages.get(m[2], 0)}</span>', text[start:end])
        html.write_text(text[:start] + listed + text[end:])
        browser("--no-pdf-header-footer", "--generate-pdf-document-outline", f"--print-to-pdf={pdf}", html.resolve().as_uri())
        pages = chapter_pages(pdf)


def versions(out):
    """The folders of versions in <out>, the newest first."""
    found = [path.parent.name for path in out.glob("*/index.html")]
    return sorted(found, key=lambda name: [int(part) if part.isdigit() else -1 for part in re.split(r"[.-]", name)], reverse=True)


def build(tree, out, version, pdf=True):
    work = out / ".work"
    out.mkdir(parents=True, exist_ok=True)
    lay_out(tree, work / "source")
    shutil.rmtree(out / version, ignore_errors=True)
    sphinx("html", work / "source", out / version, work, version)
    if pdf:
        manual(work / "source", work / "manual-source", version)
        sphinx("singlehtml", work / "manual-source", work / "manual", work, version, FABRICSH_SITE_MANUAL="1")
        print_manual(work / "manual/index.html", out / version / "fabricsh-manual.pdf")
    known = versions(out)
    (out / "versions.js").write_text("window.fabricshVersions = " + json.dumps(known) + ";\n")
    (out / "index.html").write_text(f'<!DOCTYPE html><meta charset="utf-8"><meta http-equiv="refresh" content="0; url={known[0]}/index.html">'
                                    f'<title>fabricsh</title><a href="{known[0]}/index.html">fabricsh {known[0]}</a>\n')


if __name__ == "__main__":
    pdf = "--no-pdf" not in sys.argv
    tree, out, version = [word for word in sys.argv[1:] if word != "--no-pdf"]
    absent = missing(pdf)
    if absent:
        sys.exit("the site needs: apt-get install --no-install-recommends " + " ".join(absent))
    build(pathlib.Path(tree).resolve(), pathlib.Path(out).resolve(), version, pdf)
    print(pathlib.Path(out).resolve() / "index.html")
