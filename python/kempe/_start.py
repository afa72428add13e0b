"""Where a task begins and where it is changed by hand: templates, and the studio's page."""
from __future__ import annotations

import pathlib
from dataclasses import dataclass, field
from typing import Optional

from . import _core
from ._answers import Error, error_of
from ._program import studio_file
from ._spec import Path, Spec


@dataclass(frozen=True)
class Template:
    """A spec of a job to start from."""

    name: str  #: "sign-router"
    purpose: str  #: what it is for, a line
    toml: str = field(repr=False)  #: the spec's file, with notes

    @property
    def spec(self) -> Spec:
        """The task."""
        return Spec.from_toml(self.toml)

    def save(self, file: Path) -> None:
        """Writes the spec's file, with its notes. Raises FileExistsError where there is a file of that name."""
        with open(file, "x", encoding="utf-8", newline="\n") as stream:
            stream.write(self.toml)


def templates() -> dict[str, Template]:
    """The templates of `kempe init` by name, in its order.

    >>> next(iter(templates()))
    'sign-router'
    >>> round(templates()["sign-router"].spec.copy.real, 3)
    0.333
    """
    return {name: Template(name, purpose, toml) for name, purpose, toml in _core.templates()}


def studio_page(spec: Spec | Path, *, page: Optional[Path] = None) -> str:
    """The browser page in which a spec is changed by hand (docs/studio.md), with this spec inside: the text of one HTML file.

    spec  a Spec, or a spec's file, whose notes and drawing come along
    page  the page that scripts/studio has built; None: where it is installed or built

    Raises SpecError with the spec's faults and for a page that is none of the studio's, Error where there is no page.
    """
    built = pathlib.Path(studio_file() if page is None else page).read_text(encoding="utf-8")
    if isinstance(spec, Spec):
        found = _core.studio_page(built, spec.to_toml(), spec.title or "spec", "")
    else:
        file = pathlib.Path(spec)
        found = _core.studio_page(built, file.read_text(encoding="utf-8"), file.stem, file.parent)
    if isinstance(found, list):
        raise error_of(found)
    return found
