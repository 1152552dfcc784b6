"""What the pages of share/doc need of Sphinx: formulas in plain letters, sessions at the prompt, and KaTeX."""
import re

import pygments.lexer
import pygments.lexers
import pygments.token
from docutils import nodes

import formula


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


def formulas(app, page, text):
    """```formula blocks become mathematics before the page is parsed."""
    text[0] = re.sub(r"^```formula\n(.*?)^```$", lambda m: "```{math}\n" + formula.to_latex(m.group(1)) + "\n```", text[0],
                     flags=re.M | re.S)


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
    app.connect("source-read", formulas)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
