"""Extensions of Sphinx for the pages of share/doc: sessions at the prompt, KaTeX, pictures in their size on paper, the sign
of plus and minus, and links that show the title of a page in the place of its file's name."""
import os
import pathlib
import re
import struct

import pygments.lexer
import pygments.lexers
import pygments.token
from docutils import nodes



class SessionLexer(pygments.lexer.Lexer):
    """A session at the prompt: what is typed behind > or >> is Lua, the rest is what came."""
    name, aliases = "fabricsh", ["fabricsh"]

    def get_tokens_unprocessed(self, text):
        lua, at = pygments.lexers.LuaLexer(), 0
        for line in text.splitlines(keepends=True):
            typed = re.match(r">>? ", line)
            if typed:
                yield at, pygments.token.Generic.Prompt, typed.group()
                for place, token, value in lua.get_tokens_unprocessed(line[typed.end():]):
                    yield at + typed.end() + place, token, value
            else:
                yield at, pygments.token.Generic.Output, line
            at += len(line)


def titles(app, page, text):
    """[howto/plot.md](howto/plot.md) is right where files are read; on a site the link shows the title of that page."""
    def titled(match):
        shown, target = match.groups()
        a_file = (shown.endswith(".md") or "/" in shown) and target.partition("#")[0].removesuffix(".md").endswith(shown.removesuffix(".md"))
        return f"[]({target})" if a_file else match.group()

    text[0] = re.sub(r"\[((?:[\w-]+/)*[\w-]+(?:\.md)?)\]\(((?:[\w.-]+/)*[\w-]+\.md(?:#[\w-]+)?)\)", titled, text[0])


def signs(app, page, text):
    """80.1 +- 1.1 is what decks print; a page shows the sign, except in code."""
    parts = re.split(r"(^```.*?^```$|`[^`\n]*`)", text[0], flags=re.M | re.S)
    text[0] = "".join(part if k % 2 else re.sub(r"(?<=[\s(])\+- ?(?=\d)", "± ", part) for k, part in enumerate(parts))


PER_MM = {"mm": 1, "cm": 10, "in": 25.4, "pt": 25.4 / 72, "px": 25.4 / 96, "": 25.4 / 96}


def width_on_paper(path):
    """mm: of an SVG its width, of a PNG the width at the resolution that it states, or at 200 pixels per inch. None: another kind of file."""
    if path.suffix == ".svg":
        found = re.search(r"<svg[^>]*?\bwidth=[\"']([\d.]+)([a-z]*)[\"']", path.read_text(), re.S)
        return float(found.group(1)) * PER_MM[found.group(2)] if found else None
    if path.suffix != ".png":
        return None
    data, at, across, each = path.read_bytes(), 8, 0, 25.4 / 200
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            across, = struct.unpack(">I", data[at + 8:at + 12])
        if kind == b"pHYs" and data[at + 16] == 1:
            each = 1000 / struct.unpack(">I", data[at + 8:at + 12])[0]
        if kind == b"IDAT":
            break
        at += size + 12
    return across * each


def sizes(app, doctree):
    """Pictures are drawn for paper: the manual shows them in that size, a screen half as large again, so that their letters are those of the text."""
    by = 1 if os.environ.get("FABRICSH_SITE_MANUAL") else 1.5
    for image in doctree.findall(nodes.image):
        width = width_on_paper(pathlib.Path(app.srcdir) / image["uri"]) if "width" not in image else None
        if width:
            image["width"] = f"{round(by * width * 96 / 25.4)}px"


def inline(self, node):
    self.body.append(self.starttag(node, "span", "", CLASS="math"))
    self.body.append(self.encode(node.astext()) + "</span>")
    raise nodes.SkipNode


def block(self, node):
    self.body.append(self.starttag(node, "div", CLASS="math display"))
    self.body.append(self.encode(node.astext()) + "</div>\n")
    raise nodes.SkipNode


def setup(app):
    app.add_lexer("fabricsh", SessionLexer)
    app.add_html_math_renderer("katex", (inline, None), (block, None))
    app.connect("source-read", titles)
    app.connect("source-read", signs)
    app.connect("doctree-read", sizes)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
