"""Formulas that the documents write in plain letters, between ```formula fences, as LaTeX.

A line is a row. Two or more spaces part its columns, where the columns of neighbouring rows begin at the same place. Names of Greek
letters, digits behind a name (D1, nu12) and what stands behind _ or a comma (x_i, r,k) become what they mean; other words stay words.
"""
import re

GREEK = set("alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi pi rho sigma tau phi chi psi omega".split())
GREEK |= {name.capitalize() for name in "gamma delta theta lambda xi pi sigma phi psi omega".split()}
FUNCTIONS = {"min", "max", "sin", "cos", "tan", "exp", "log", "ln", "arg"}
SIGNS = {">=": r"\ge ", "<=": r"\le ", "!=": r"\ne ", "->": r"\to ", "...": r"\dots ", "*": r"\cdot ", "|": r"\vert ", "%": r"\% ", "{": r"\{",
         "}": r"\}", "&": r"\& ", "#": r"\# ", "$": r"\$ ", "~": r"\sim ", "\\": r"\backslash "}
PRODUCT = r"\cdot "
TOKEN = re.compile(r"sum over [a-z]+(?: at [a-z]+)?|[A-Za-z]+\d*(?:_\w+)?(?:,[a-z](?![\w]))?'*|\d+(?:\.\d+)?(?:e-?\d+)?|\^(?:-?\w+|\([^()]*\))"
                   r"|>=|<=|!=|->|\.\.\.| \. |\s+|.")
SMALL_WORDS = {"at", "of", "by", "is", "in", "on", "to", "or", "if", "no", "as", "be", "it", "so", "an"}


def _letter(name):
    """One letter or Greek name, else None."""
    return name if len(name) == 1 else "\\" + name + " " if name in GREEK else None


def _name(word):
    """A name with its indices, or words."""
    primes = len(word) - len(word.rstrip("'"))
    body, _, behind = word.rstrip("'").partition(",")
    body, _, index = body.partition("_")
    letters = body.rstrip("0123456789")
    index = ",".join(part for part in (body[len(letters):], index) if part)
    differential = ""
    symbol = _letter(letters)
    if symbol is None and letters in FUNCTIONS:
        return "\\" + letters + " "
    if symbol is None and letters == "sum":
        symbol = r"\sum "
    if symbol is None and letters[0] == "d" and _letter(letters[1:]) and letters not in SMALL_WORDS:
        differential, symbol = r"\mathrm{d} ", _letter(letters[1:])
    if symbol is None and re.fullmatch("[A-Z][a-z]", letters) and letters not in GREEK:  # Du: D of unloading
        symbol, index = letters[0], letters[1] + index
    if symbol is None:
        return r"\text{" + word.replace("_", r"\_") + "}"
    if behind:
        index += "," + behind
    return differential + symbol.strip() + (f"_{{{_index(index)}}}" if index else " " * symbol.endswith(" ")) + "'" * primes


def _index(text):
    return ",".join(_letter(part) or (part if part.isdigit() or len(part) < 3 else r"\text{" + part + "}") if part else ""
                    for part in text.split(",")).strip()


def _cell(text):
    # d2d/dx_i: the two of a second derivative is a power.
    text = re.sub(r"\bd2(?=[A-Za-z])", "\x01", text)
    out = []
    for token in TOKEN.findall(text):
        if token.startswith("sum over "):
            out.append(r"\sum_{\text{" + token[len("sum over "):] + "}} ")
        elif token == " . ":
            out.append(PRODUCT)
        elif token == "\x01":
            out.append(r"\mathrm{d}^{2} ")
        elif token[0] == "^":
            out.append("^{" + _cell(token[1:].strip("()")) + "}")
        elif token[0].isalpha():
            out.append(_name(token))
        elif token.isspace():
            out.append(" ")
        else:
            out.append(SIGNS.get(token, token))
    # Between a word and what stands beside it the space is to be seen.
    joined = re.sub(r"\\text\{([^{}]*)\} (?=\\text)", r"\\text{\1 }", "".join(out))
    joined = re.sub(r"(?<=[^\s{]) (?=\\text)", r"\\ ", joined)
    return re.sub(r"(\\text\{[^{}]*\}) (?=\S)", r"\1\\ ", joined).strip()


def to_latex(text):
    """The block as one LaTeX array."""
    lines = [line.rstrip() for line in text.strip("\n").splitlines()]
    places = sorted({match.start() for line in lines for match in re.finditer(r"(?:^|(?<=\s\s))\S", line)})
    # A column is where at least two rows have something to begin; the others go with what stands before them.
    shared = [p for p in places if p == 0 or sum(line[p - 2:p] == "  " and line[p:p + 1].strip() != "" for line in lines) > 1]
    rows = []
    for line in lines:
        cells, begin = [], 0
        for place in shared[1:] + [None]:
            if place is not None and line[place - 2:place].strip() and len(line) > place:
                cells.append(None)  # what stands before runs on over this place
                continue
            cells.append(line[begin:place])
            begin = place
        row, empty = [], 0
        for cell in cells:
            if cell is None:
                empty += 1
                continue
            row.append(r" \quad ".join(_cell(part) for part in re.split(r"\s{2,}(?![=<>+])", cell.strip())))
            row += [""] * empty
            empty = 0
        rows.append(row)
    # A row that fills one column alone does not widen it for the others: it stands outside of their table.
    parts = []
    for row in rows:
        alone = not any(row[1:])
        if alone or not parts or parts[-1][0]:
            parts.append((alone, []))
        parts[-1][1].append(" & ".join(row[:1] if alone else row))
    return _array("l", [part[0] if alone else _array("l" * len(shared), part, "0.4em") for alone, part in parts], "0.6em")


def _array(columns, rows, gap):
    return rf"\begin{{array}}{{{columns}}}" + "\n" + rf" \\[{gap}]".join(row + "\n" for row in rows) + r"\end{array}"
