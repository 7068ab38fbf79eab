"""A dossier as one page, for people and printers. It has no script and asks nobody for anything; each word of others is escaped."""

from __future__ import annotations

import datetime
import html
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from rosml import __version__
from rosml.base import clock, terminal
from rosml.base.problems import counted
from rosml.images.dossier import fields
from rosml.images.dossier.bill import items, shortened, text
from rosml.images.dossier.gather import Dossier
from rosml.images.dossier.support import End
from rosml.images.image_set.labels import DESCRIPTION, TITLE

STYLE = Path(__file__).with_name("style.css")

SHOWN = 200
"""As many vulnerabilities are on the page, the worst. All are in scan.json."""

WHOLE = 20
"""Cells with fewer characters have one line: days and numbers."""

POLICY = "default-src 'none'; style-src 'unsafe-inline'"
"""What a browser may do with the page: https://www.w3.org/TR/CSP3/"""


def render(dossier: Dossier, names: Iterable[str]) -> str:
    """The page. `names` are the files beside it."""
    title = _safe(dossier.image.labels.get(TITLE) or dossier.image.name)
    body = "\n".join(filter(None, _body(dossier, names)))
    head = f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Dossier of {title}</title>
<style>
{STYLE.read_text(encoding="utf-8")}</style>
</head>
<body>
<main>
<h1>Dossier of {title}</h1>
"""
    return f"{head}{body}\n</main>\n</body>\n</html>\n"


def _body(dossier: Dossier, names: Iterable[str]) -> Iterator[str]:
    yield _facts(dossier)
    yield _section("What is missing", _list(dossier.missing)) if dossier.missing else ""
    yield _section("End of support", _support(dossier))
    yield _section("Vulnerabilities", _vulnerabilities(dossier))
    yield _section("Statements about vulnerabilities (VEX)", _vex(dossier))
    yield _section("Completeness of the SBOM", _fields(dossier))
    yield _section("Licences", _licences(dossier))
    yield _section("Where it comes from", _origin(dossier))
    yield _section("How to make it again", _rebuild(dossier))
    yield _section("Components", _components(dossier))
    yield _section("Files of this dossier", _list(sorted(names)))


def _facts(dossier: Dossier) -> str:
    image, signature = dossier.image, dossier.signature
    created = image.config.facts.created or "its config does not say"
    by = f" by {signature.signer}" if signature.signer else ""
    rows = [
        ("Image", image.name),
        ("Platform", image.platform),
        ("Digest", dossier.reference),
        ("Its name points at", dossier.tagged),
        ("What it is", image.labels.get(DESCRIPTION, "")),
        ("Made", created),
        ("Signature", f"{signature.state}{by}{f': {signature.why}' if signature.why else ''}"),
        ("Dossier", f"written {dossier.now} by rosml {__version__}"),
    ]
    return f"<dl>{''.join(f'<dt>{name}</dt><dd>{_safe(value)}</dd>' for name, value in rows if value)}</dl>"


# ---- The sections ----------------------------------------------------------------------------------------------------


def _support(dossier: Dossier) -> str:
    if not dossier.ends:
        return _say("Nothing in it has an end of support that rosml knows of.")
    today = clock.day_of(dossier.now)
    rows = ((f"{it.title} {it.version}", _day(it, today), _note(it)) for it in dossier.ends)
    return _table(("what", "last day", "by whose word"), rows, marked=lambda row: "ended" in row[1])


def _day(end: End, today: datetime.date) -> str:
    return f"{end.day or 'no day'}{' (ended)' if end.has_ended(today) else ''}"


def _note(end: End) -> str:
    return f"{end.note}: {end.page}" if end.page else end.note


def _vulnerabilities(dossier: Dossier) -> str:
    scan = dossier.scan
    if scan is None:
        return _say("There was no scan: see what is missing.")
    counts = ", ".join(f"{number:,} {severity}" for severity, number in scan.counts) or "none"
    intro = _say(f"Known to the database of {scan.database.updated}: {counts}. All are in scan.json.")
    intro += _list(scan.remarks) if scan.remarks else ""
    rows = (
        (it.severity, it.id, f"{it.package} {it.installed}", it.fixed or "no version yet", scan.status(it), it.title)
        for it in scan.findings[:SHOWN]
    )
    more = len(scan.findings) - SHOWN
    columns = ("severity", "advisory", "package", "fixed in", "VEX", "title")
    table = _table(columns, rows, marked=lambda row: row[0] in ("critical", "high"))
    return intro + table + (_say(f"And {more:,} more in scan.json.") if more > 0 else "")


def _vex(dossier: Dossier) -> str:
    if dossier.vex is None:
        return _say("None is attached.")
    rows = [
        (
            text(it, "vulnerability", "name"),
            text(it, "status"),
            text(it, "justification"),
            " ".join(dict.fromkeys(filter(None, (text(it, f"{name}") for name in _NOTES)))),
            str(sum(len(items(product, "subcomponents")) for product in items(it, "products"))),
        )
        for it in items(dossier.vex.content, "statements")
    ]
    of = _say(f"By {text(dossier.vex.content, 'author') or 'nobody'}, {text(dossier.vex.content, 'timestamp')}.")
    return of + _table(("advisory", "status", "justification", "in words", "components"), rows)


_NOTES = ("status_notes", "impact_statement", "action_statement")


def _fields(dossier: Dossier) -> str:
    if dossier.bill is None:
        return _say("There is no SBOM.")
    intro = _say(
        f"{counted(len(dossier.bill.components), 'component')}, by NTIA's minimum elements (2021) and BSI TR-03183-2 version 2.1.0."
    )
    return intro + _table(fields.COLUMNS, fields.rows(dossier.fields))


def _licences(dossier: Dossier) -> str:
    by_licence = dict[str, list[str]]()
    for it in dossier.texts:
        by_licence.setdefault(it.licences, []).append(it.component)
    if not by_licence:
        return _say("There is no SBOM.")
    rows = sorted(((name, f"{len(of):,}", ", ".join(of[:3])) for name, of in by_licence.items()), key=_by_number)
    intro = "licences.txt has each component, and the place of its text in the image. The texts go with the image."
    return _say(intro) + _details(
        f"{counted(len(rows), 'licence')}", _table(("licence", "components", "such as"), rows)
    )


def _by_number(row: Sequence[str]) -> tuple[int, str]:
    return -int(row[1].replace(",", "")), row[0]


def _origin(dossier: Dossier) -> str:
    if not dossier.origins:
        return _say("The index of the image names no provenance.")
    parts = []
    for it in dossier.origins:
        rows = [("Builder", it.builder), ("Run", it.invocation), ("Finished", it.finished), *it.inputs.items()]
        facts = "".join(f"<dt>{_safe(name)}</dt><dd>{_safe(value)}</dd>" for name, value in rows if value)
        parts.append(f"<dl>{facts}</dl>" + _table(("made from", "where", "digest"), it.materials))
    return "".join(parts)


def _rebuild(dossier: Dossier) -> str:
    if dossier.rebuild is None:
        return _say("Its labels do not say.")
    commands = f"<pre>{chr(10).join(map(_safe, dossier.rebuild.commands))}</pre>" if dossier.rebuild.commands else ""
    return commands + _list(dossier.rebuild.notes)


def _components(dossier: Dossier) -> str:
    if dossier.bill is None:
        return _say("There is no SBOM.")
    rows = (
        (
            it.title,
            text(it.suppliers[0], "name") if it.suppliers else "",
            " AND ".join(licence.text for licence in it.licences),
            text(it.content, "purl"),
        )
        for it in dossier.bill.components
    )
    table = _table(("component", "supplier", "licence", "package URL"), rows)
    return _details(counted(len(dossier.bill.components), "component"), table)


# ---- HTML ------------------------------------------------------------------------------------------------------------


def _safe(words: str) -> str:
    """A stranger's words as text: no markup, no characters that hide or turn others, and not too many."""
    return html.escape(terminal.shown(shortened(words)))


def _say(words: str) -> str:
    return f"<p>{_safe(words)}</p>"


def _section(title: str, content: str) -> str:
    return f"<section>\n<h2>{title}</h2>\n{content}\n</section>"


def _details(title: str, content: str) -> str:
    return f"<details>\n<summary>{_safe(title)}</summary>\n{content}\n</details>"


def _list(words: Iterable[str]) -> str:
    return f"<ul>\n{''.join(f'<li>{_safe(it)}</li>{chr(10)}' for it in words)}</ul>"


def _table(columns: Sequence[str], rows: Iterable[Sequence[str]], marked: object = None) -> str:
    """`marked` says of a row whether it stands out."""
    head = "".join(f"<th scope=col>{_safe(name)}</th>" for name in columns)
    lines = []
    for row in rows:
        cells = "".join(
            f"<td class=whole>{_safe(it)}</td>" if len(it) < WHOLE else f"<td>{_safe(it)}</td>" for it in row
        )
        is_marked = callable(marked) and marked(row)
        lines.append(f"<tr class=bad>{cells}</tr>" if is_marked else f"<tr>{cells}</tr>")
    if not lines:
        return ""
    body = "\n".join(lines)
    return (
        f"<div class=wide tabindex=0><table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody>\n</table></div>"
    )
