"""Reads JSON, YAML and TOML from outside as plain data, with limits. No other module parses them; models then check the data's shape."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar

from rosml.base.errors import RosmlError

if TYPE_CHECKING:
    import yaml

SIZE = 16 << 20
"""The most bytes of a text, unless the caller sets another limit."""

DEPTH = 100
"""The most levels of nested lists and objects. Real data has at most twenty."""

DIGITS = 20
"""The most digits of a whole number: enough for 64 bits."""

VALUES = 1_000_000
"""The most values of a JSON text. Each takes at least 60 bytes of memory, so a text of some megabytes could take gigabytes."""

NODES = 2_000_000
"""The most values of a YAML file after its aliases are replaced. rosdep's largest list has 30,000."""

EVENTS = 100_000
"""The most values and collections of a YAML file as it is written. Each takes some microseconds, and a kilobyte while it is read."""

CHECK = "check where it is from"


def json_of(data: bytes | str, what: str) -> Any:
    """As `json_value`, with RosmlError for ValueError. `what` is the text's name in messages."""
    try:
        return json_value(data)
    except ValueError as error:
        raise RosmlError(f"{what} is no JSON: {error}", CHECK) from None


def json_value(data: bytes | str, limit: int = SIZE) -> Any:
    """The value of a JSON text of at most `limit` bytes.

    Raises ValueError if it has more than `VALUES` values, is nested deeper than `DEPTH`, or no JSON in UTF-8; if it has a number of more than
    `DIGITS` digits or too large for a float, the same key twice in an object, or half of a surrogate pair.
    """
    (value,) = json_values(data, limit, one=True)
    return value


def json_object(data: bytes | str, limit: int = SIZE) -> dict[str, Any] | None:
    """None if the text is no object, or if `json_value` refuses it."""
    try:
        value = json_value(data, limit)
    except ValueError:
        return None
    return value if isinstance(value, dict) else None


def json_quick(data: bytes | str, limit: int = SIZE) -> Any:
    """As `json_value`, ten times faster, for large texts. Of a key that is there twice, the last one counts."""
    return _decoded(json_text(data, limit), Any)


def json_fields(data: bytes | str, limit: int = SIZE) -> dict[str, bytes]:
    """The fields of a JSON object, with the texts of their values, which are not parsed. Raises ValueError as `json_quick`."""
    import msgspec

    fields = _decoded(json_text(data, limit), dict[str, msgspec.Raw])
    return {name: bytes(text) for name, text in fields.items()}


def json_items(data: bytes) -> list[bytes]:
    """The texts of a JSON list's items, which are not parsed. `data` is from `json_fields`. Raises ValueError if it is no list."""
    import msgspec

    return [*map(bytes, _decoded(data, list[msgspec.Raw]))]


def _decoded(data: bytes | str, shape: Any) -> Any:
    import msgspec

    try:
        return msgspec.json.decode(data, type=shape)
    except msgspec.DecodeError as error:
        raise ValueError(str(error)) from None
    except RecursionError:
        raise ValueError(_DEEP) from None


def json_values(data: bytes | str, limit: int = SIZE, one: bool = False) -> list[Any]:
    """The values of JSON texts that follow each other, of at most `limit` bytes in all; exactly one if `one` is set. Raises ValueError."""
    text = json_text(data, limit)
    values: list[Any] = []
    place = _BLANKS.match(text, 0).end()  # type: ignore[union-attr] # it matches anywhere
    try:
        while place < len(text) or (one and not values):
            value, place = _DECODER.raw_decode(text, place)
            place = _BLANKS.match(text, place).end()  # type: ignore[union-attr]
            values.append(value)
            if one and place < len(text):
                raise ValueError("something follows its value")
    except RecursionError:
        raise ValueError(_DEEP) from None
    _require_shallow(values)
    if _SURROGATE.search(text) and not _is_unicode(values):
        raise ValueError("it has half of a surrogate pair")
    return values


def json_text(data: bytes | str, limit: int = SIZE) -> str:
    """A JSON text that something else reads. Raises ValueError if it is too large or not UTF-8, or may have more than `VALUES` values."""
    text = _text(data, limit)
    marks = sum(text.count(mark) for mark in ",[{") if len(text) > VALUES else 0  # strings may have some of them, too
    if marks > VALUES:
        raise ValueError(f"it has more than {VALUES:,} values")
    return text


_DEEP = f"it is nested more than {DEPTH} levels deep"
_BLANKS = re.compile(r"[ \t\r\n]*")
_SURROGATE = re.compile(r"\\u[dD][89a-fA-F]|[\ud800-\udfff]")


def _text(data: bytes | str, limit: int) -> str:
    if len(data) > limit:
        raise ValueError(f"it has more than {limit:,} bytes")
    if isinstance(data, str):
        return data
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ValueError(f"it is not UTF-8 (byte 0x{data[error.start]:02x})") from None


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    unique = dict(pairs)
    if len(unique) < len(pairs):
        raise ValueError("a key is there twice")
    return unique


def _whole(text: str) -> int:
    if len(text.lstrip("-")) > DIGITS:
        raise ValueError(f"it has a number of {len(text)} digits")
    return int(text)


def _fraction(text: str) -> float:
    if not math.isfinite(number := float(text)):
        raise ValueError("it has a number that is too large")
    return number


def _constant(text: str) -> float:
    raise ValueError(f"it has {text}, which is no number")


_DECODER = json.JSONDecoder(parse_int=_whole, parse_float=_fraction, parse_constant=_constant, object_pairs_hook=_once)


def _require_shallow(values: list[Any]) -> None:
    level: list[Any] = [item for item in values if isinstance(item, (dict, list))]
    for _ in range(DEPTH + 1):
        if not level:
            return
        below = (item.values() if isinstance(item, dict) else item for item in level)
        level = [item for items in below for item in items if isinstance(item, (dict, list))]
    raise ValueError(_DEEP)


def _is_unicode(value: Any) -> bool:
    try:
        json.dumps(value, ensure_ascii=False).encode()
    except UnicodeEncodeError:
        return False
    return True


DOTTED = re.compile(r"""(?<![A-Za-z0-9_-])(?:(?:[A-Za-z0-9_-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){20}""")
"""A key with too many parts. tomllib takes a gigabyte and seconds for one of 32 kB."""


def toml_value(text: str) -> dict[str, Any]:
    """Raises ValueError for a key with too many parts, and values that are nested too deep."""
    import tomllib

    if DOTTED.search(text):
        raise ValueError("a key has too many parts")
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise ValueError(_DEEP) from None


def yaml_of(data: bytes | str, what: str, limit: int = SIZE, remedy: str = CHECK, exit_code: int = 1) -> Any:
    """The value of a YAML text of at most `limit` bytes, from YAML's safe constructor. `what` is its name in messages.

    Raises:
        RosmlError: it is nested deeper than `DEPTH`, or no YAML in UTF-8; its aliases make more than `NODES` values, or lead into
            themselves; a value does not fit its type.
    """
    import yaml

    try:
        node = yaml_node(_text(data, limit))
        return None if node is None else _constructor().construct_document(node)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        why = f"line {mark.line + 1}: {error.problem}" if mark else str(error.problem)
    except yaml.YAMLError:
        why = "it has a character that YAML does not allow"
    except (ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError) as error:
        # PyYAML itself raises these for `0x_`, `!!bool x`, `!!timestamp x` and `!!int ""`.
        why = str(error) if type(error) is ValueError else "a value is none of its type"
    raise RosmlError(f"{what} is no YAML: {why}", remedy, exit_code)


def yaml_node(text: str, plain: bool = False) -> Any:
    """The top node of a YAML text. `plain`: the caller read all of `yaml_events`, and they have no anchor and no alias."""
    import yaml

    if not plain:
        _require_small(yaml_events(text))
    return yaml.compose(text, Loader=_loader())


def yaml_events(text: str) -> Iterator[Any]:
    """The events of a YAML text, up to `DEPTH` levels. With some ten thousand levels, libyaml's compose ends the process."""
    import yaml

    depth = 0
    for number, event in enumerate(yaml.parse(text, Loader=_loader())):
        if number > EVENTS:
            raise _refused(f"more than {EVENTS:,} values", event)
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
            if depth > DEPTH:
                raise _refused(f"nested more than {DEPTH} levels deep", event)
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1
        yield event


def _loader() -> Any:
    """libyaml's loader, which comes with PyYAML's wheels. The parser in Python reads the same, ten times slower."""
    import yaml

    return getattr(yaml, "CSafeLoader", yaml.SafeLoader)


def _refused(why: str, event: Any) -> yaml.MarkedYAMLError:
    import yaml

    return yaml.MarkedYAMLError(problem=why, problem_mark=event.start_mark)


def _require_small(events: Iterator[Any]) -> None:
    """Raises yaml.YAMLError if aliases make too much of a text, go too deep, or lead into themselves."""
    import yaml

    anchors: dict[str, tuple[int, int]] = {}  # for each anchor: the number of its values, and of their levels
    above: list[tuple[str, int, int]] = [("", 0, 0)]  # for each open collection: its anchor, values and levels so far
    for event in events:
        if isinstance(event, yaml.CollectionStartEvent):
            above.append((event.anchor or "", 1, 1))
            anchors.pop(event.anchor or "", None)
            continue
        if isinstance(event, yaml.CollectionEndEvent):
            anchor, values, levels = above.pop()
        elif isinstance(event, yaml.AliasEvent):
            anchor, (values, levels) = "", anchors.get(event.anchor or "", (0, 0))
            if not values:
                raise _refused(f"the alias {event.anchor} leads nowhere, or into itself", event)
        elif isinstance(event, yaml.ScalarEvent):
            anchor, values, levels = event.anchor or "", 1, 0
        else:
            continue
        if anchor:
            anchors[anchor] = values, levels
        outer, count, deepest = above[-1]
        above[-1] = outer, count + values, max(deepest, levels + 1)
        if count + values > NODES:
            raise _refused("its aliases make too much of it", event)
        if len(above) + levels > DEPTH + 1:
            raise _refused(f"nested more than {DEPTH} levels deep", event)


def _constructor() -> Any:
    """PyYAML's safe constructor, without very long numbers."""
    import yaml

    constructors, whole = yaml.constructor.SafeConstructor.yaml_constructors, "tag:yaml.org,2002:int"

    def short(self: Any, node: yaml.ScalarNode) -> Any:
        if isinstance(node.value, str) and len(node.value) > 2 * DIGITS:
            raise yaml.constructor.ConstructorError(None, None, "a number is too long", node.start_mark)
        return constructors[whole](self, node)

    class Constructor(yaml.constructor.SafeConstructor):
        yaml_constructors: ClassVar[dict[Any, Any]] = {**constructors, whole: short}

    return Constructor()
