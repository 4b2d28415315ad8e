# SPDX-License-Identifier: GPL-3.0-or-later
"""Plain English: docstrings start with their subject, constants name a quantity, no dialect."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FOLDERS = ("python", "tests", "benchmarks", "gallery", "scripts", "docs")
SOURCES = {folder: sorted((ROOT / folder).rglob("*.py")) for folder in FOLDERS}
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]

OPENING = re.compile(
    r"\s*(?:What|Of|How|Where|Those|The same|Since|As|With|And|But|Nor|So|Also|Else|Pressed)\b"
)
"""First words of a docstring without a subject; "Whether" is right for a boolean."""

INSTEAD = {
    r"\b(?:permanent|the|a|its|both|whose|deepest|rolled) prints?\b(?! of the)": "residual imprint",
    r"\bdepth of the print\b": "imprint depth",
    r"\b(?:told|tells?|telling)\b": "state, warn, report, show",
    r"\banew\b": "again, new",
    r"\bfor ever\b": "without end",
    r"\bstick and slip\b(?! (?:zone|condition|cell|map|residual))": "partial slip",
    r"\bgross sliding\b": "full sliding",
    r"\brise of (?:the )?temperature\b": "temperature rise",
    r"\b(?:un)?like bodies\b|\bbodies (?:un)?a?like\b": "dissimilar (identical) materials",
    r"\bbodies that yield\b|\binelastic bod(?:y|ies)\b": "elastic-plastic bodies",
    r"\bwindows? that grows?\b": "automatic grid enlargement",
    r"\bscenes?\b": "contact problem, case, setup",
    r"\bverdicts?\b": "check, result",
    r"\bdoubts?\b|\bdoubted\b": "plausibility check",
    r"\bgo(?:es)? on with\b": "continue, resume",
    r"\bat first\b(?! (?:yield|contact))": "initial, initially",
    r"\bbeside\b": "next to, in addition to",
    r"\btugs?\b|\btuggings\b": "collide, asperity collision",
}
"""Words of no tribologist, and what to write instead."""
DIALECT = re.compile("|".join(f"({word})" for word in INSTEAD).replace(" ", r"\s+"), re.IGNORECASE)

BARE = {
    "ALIKE", "ASKED", "BESIDE", "BEST", "BIG", "CLEAN", "CLOSED", "COARSE", "COARSEST", "DEEPEST",
    "DEPENDS", "ENOUGH", "FAR", "FASTEST", "FEW", "FEWEST", "FINE", "FINEST", "FLATTEST", "GOOD",
    "GROWS", "HIGHEST", "HOTTEST", "KEPT", "LARGE", "LARGEST", "LATER", "LEAST", "LEFT", "LONG",
    "LONGEST", "LOWEST", "LYING", "MANY", "MIXED", "MOST", "NARROWEST", "NEAR", "NEAREST", "NEEDED",
    "OLD", "PART", "PLAUSIBLE", "QUICK", "RAW", "ROOM", "ROUGHEST", "SAFE", "SAID", "SAME",
    "SHARE", "SHORT", "SHORTEST", "SLOW", "SLOWEST", "SMALL", "SMALLEST", "SMOOTH", "SOFTEST",
    "STEEPEST", "STIFFEST", "STRAY", "TAKEN", "TIGHT", "TOGETHER", "TOLD", "UNEVEN", "USUAL",
    "WIDE", "WIDER", "WIDEST", "WORST",
}  # fmt: skip
"""Names of constants that need a comment to be understood; MIN_ or MAX_ and a quantity do not."""
SUPERLATIVE = re.compile(
    r"_?(?:MOST|LEAST|LARGEST|SMALLEST|FEWEST|LONGEST|SHORTEST|TOO)_[A-Z0-9_]+"
)


def docstrings(tree):
    """(line, text) of docstrings of modules, classes and functions, and of strings after a name."""
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if not isinstance(body, list):
            continue
        owner = isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef))
        for place, line in enumerate(body):
            text = getattr(getattr(line, "value", None), "value", None)
            follows = place > 0 and isinstance(body[place - 1], (ast.Assign, ast.AnnAssign))
            documents = follows or (place == 0 and owner)
            if isinstance(line, ast.Expr) and isinstance(text, str) and documents:
                yield line.lineno, text


def messages(tree):
    """(line, text) of strings of several words in code, docstrings included."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and " " in node.value:
            yield node.lineno, node.value


def constants(tree):
    """(line, name) of the constants of a module."""
    for node in tree.body:
        targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
        for target in targets:
            for name in ast.walk(target) if target is not None else ():
                if isinstance(name, ast.Name) and name.id.isupper():
                    yield node.lineno, name.id


def prose(text):
    """Return text without code, identifiers in backticks and link targets; lines are kept."""
    blank = lambda found: re.sub(r"[^\n]", " ", found[0])  # noqa: E731
    text = re.sub(r"^```.*?^```$", blank, text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"``?[^`]*``?|\]\([^)]*\)|<[^>]*>", blank, text)
    return re.sub(r"^[ >]*(?:>>>|\.\.\.).*$", blank, text, flags=re.MULTILINE)


def dialect(text, first=1):
    """Yield (line, word, replacement) for each forbidden word in a text."""
    for found in DIALECT.finditer(prose(text)):
        line = first + text.count("\n", 0, found.start())
        yield line, found[0], list(INSTEAD.values())[found.lastindex - 1]


def listed(folder, finding):
    """Return the findings of a function in the files of a folder, one per line."""
    return [
        f"{path.relative_to(ROOT)}:{line}: {text}"
        for path in SOURCES[folder]
        for line, text in finding(ast.parse(path.read_text(encoding="utf-8")))
    ]


@pytest.mark.parametrize("folder", FOLDERS)
def test_docstrings_begin_with_their_subject(folder):
    def finding(tree):
        found = ((line, text) for line, text in docstrings(tree) if OPENING.match(text))
        return ((line, text.strip().partition("\n")[0]) for line, text in found)

    assert listed(folder, finding) == []


@pytest.mark.parametrize("folder", FOLDERS)
def test_docstrings_and_messages_are_plain_english(folder):
    def finding(tree):
        texts = messages(tree) if folder == "python" else docstrings(tree)
        for first, text in texts:
            for line, word, instead in dialect(text, first):
                yield line, f"{word!r}: {instead}"

    assert listed(folder, finding) == []


def test_pages_are_plain_english():
    found = [
        f"{page.relative_to(ROOT)}:{line}: {word!r}: {instead}"
        for page in PAGES
        for line, word, instead in dialect(page.read_text(encoding="utf-8"))
    ]
    assert found == []


@pytest.mark.parametrize("folder", FOLDERS)
def test_constants_name_a_quantity(folder):
    def finding(tree):
        return (
            (line, name)
            for line, name in constants(tree)
            if name.strip("_") in BARE or SUPERLATIVE.fullmatch(name)
        )

    assert listed(folder, finding) == []


def test_forbidden_words_are_found():
    tree = ast.parse(
        '"""What a body does."""\nMOST = 1\n_LEAST_CELLS: int = 2\nMAX_CELLS, RAW = 3, 4\n'
        'def f():\n    """Whether it sticks."""\n    raise ValueError("the user is told anew")\n'
    )
    assert [line for line, text in docstrings(tree) if OPENING.match(text)] == [1]
    names = [name for _, name in constants(tree)]
    assert names == ["MOST", "_LEAST_CELLS", "MAX_CELLS", "RAW"]
    assert [n for n in names if n.strip("_") in BARE] == ["MOST", "RAW"]
    assert [n for n in names if SUPERLATIVE.fullmatch(n)] == ["_LEAST_CELLS"]
    words = [word for _, text in messages(tree) for _, word, _ in dialect(text)]
    assert words == ["told", "anew"]
    page = "`tell()` and\n```\ntold\n```\n[a](told.md) the\nprint\n"
    assert list(dialect(page)) == [(5, "the\nprint", "residual imprint")]
