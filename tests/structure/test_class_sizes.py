# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes have few methods, so that each has one task."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
MAX_METHODS = 20
# Larger limits for classes used directly by users, whose methods are a line or two.
FACADES = {
    "python/samcontact/solutions/state.py: State": 43,  # one for each quantity of a moment
}
NO_METHOD = r"(?:using|friend|struct|class|enum|typedef|static_assert)\b"
LABEL = r"(?:\s*(?:public|private|protected)\s*:)*\s*"


def stripped(text):
    """Return C++ code without comments, texts and preprocessor lines."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.DOTALL)
    text = re.sub(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', '""', text)
    return re.sub(r"^\s*#[^\n]*(?:\\\n[^\n]*)*$", "", text, flags=re.MULTILINE)


def without_blocks(text):
    """Return the text from a brace to its end, with {} for each inner block."""
    depth, kept = 0, []
    for letter in text:
        depth += (letter == "{") - (letter == "}")
        if letter == "{" and depth == 2:
            kept.append("{}")
        elif letter != "}" and depth == 1:
            kept.append(letter)
        if depth == 0:
            break
    return "".join(kept[1:])


def declarations(body):
    """Yield the members of a class; each ends at a semicolon or with a block."""
    ends_here = r"(?<=\{\})(?=\s*(?:[\w\[~]|$))"
    for part in body.split(";"):
        for one in re.split(ends_here, part):
            text = re.sub(r"^template\s*<[^{;]*?>\s*(?=[\w:])", "", re.sub(LABEL, "", one, count=1))
            if text.strip():
                yield text.strip()


def cpp_methods(name, body):
    """Return the names of methods, without constructors, destructors and operators."""
    found = set()
    for text in declarations(body):
        before = text
        while (shorter := re.sub(r"<[^<>]*>", "", before)) != before:
            before = shorter
        before = re.sub(r"^\[\[\w+\]\]\s*", "", before)
        match = re.match(r"[^=(]*?([~\w]+)\s*\(", before)
        if (
            match
            and not re.match(NO_METHOD, before)
            and not re.search(r"\boperator\b", before.split("(")[0])
        ):
            found.add(match[1])
    return found - {name, f"~{name}"}


def cpp_classes(text):
    text = stripped(text)
    for match in re.finditer(
        r"\b(?:class|struct)\s+(\w+)(?:\s+final)?\s*(?::[^;{()]*)?(?=\{)", text
    ):
        yield match[1], cpp_methods(match[1], without_blocks(text[match.end() :]))


def python_classes(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ClassDef):
            names = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
            yield node.name, {name for name in names if not name.startswith("__")}


def classes():
    for folder, kinds, of in (
        ("cpp", ("*.hpp", "*.cpp"), cpp_classes),
        ("python", ("*.py",), python_classes),
    ):
        for file in sorted(f for kind in kinds for f in (ROOT / folder).rglob(kind)):
            for name, methods in of(file.read_text()):
                yield f"{file.relative_to(ROOT)}: {name}", methods


def test_methods_are_counted():
    text = """
    struct Part { int n; bool is() const { return n > 0; } };
    class Whole final : public Base<Part> {
     public:
      explicit Whole(int n) : n_(n), part_{n} { check(n); }
      ~Whole() override = default;
      Whole& operator=(const Whole&) = delete;
      int first() const { return n_; }  // f();
      const std::map<int, Part>& second(const std::function<int(int)>& f = {}) const;
      template <class T> void third(const T& t);
      double third(double t);
      [[noreturn]] void fourth(const std::string& why = "no(t)");
      struct Inner { void hidden(); };
     private:
      using Call = std::function<void(int)>;
      static constexpr double half(double x) { return x / 2; }
      Call call_ = nullptr;
      std::atomic<int> n_{0};
    };
    """
    assert dict(cpp_classes(text)) == {
        "Part": {"is"},
        "Whole": {"first", "second", "third", "fourth", "half"},
        "Inner": {"hidden"},
    }
    python = "class A:\n    def __init__(self): ...\n    def b(self): ...\n"
    assert dict(python_classes(python)) == {"A": {"b"}}


def test_classes_have_few_methods():
    found = dict(classes())
    assert len(found) > 500
    assert "cpp/include/samcontact/simulation/setup/setup.hpp: Setup" in found
    sizes = {name: len(methods) for name, methods in found.items()}
    assert {n: size for n, size in sizes.items() if size > FACADES.get(n, MAX_METHODS)} == {}


@pytest.mark.parametrize("name", FACADES)
def test_classes_with_many_methods_are_listed_and_need_it(name):
    assert MAX_METHODS < len(dict(classes())[name]) <= FACADES[name]
