# SPDX-License-Identifier: GPL-3.0-or-later
"""Print the packages that an extra of the project requires, in the format of pip, one per line.

With this list, pip installs them while the core is being compiled: `requirements.py EXTRA`.
"""

import sys
from collections.abc import Iterator
from pathlib import Path

if sys.version_info >= (3, 11):
    import tomllib
else:
    from pip._vendor import tomli as tomllib

PROJECT = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text())["project"]


def required_by(extra: str) -> Iterator[str]:
    """Yield the packages of an extra and of the extras that it contains."""
    own = f"{PROJECT['name']}["
    for requirement in PROJECT["optional-dependencies"][extra]:
        if requirement.startswith(own):
            for inner in requirement.removeprefix(own).rstrip("]").split(","):
                yield from required_by(inner)
        else:
            yield requirement


if __name__ == "__main__":
    print(*sorted({*PROJECT["dependencies"], *required_by(sys.argv[1])}), sep="\n")
