"""Template of a deck: Jinja2 in a sandbox, which makes the mesh from mesh parameters.

Each error of a template is a CaseError with the line. Nesting, memory and output are bounded here, the time by the
process that reads the case.
"""

import math
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from traceback import walk_tb
from typing import TYPE_CHECKING, Any

from vmharness.case.decode import utf8
from vmharness.case.error import CaseError
from vmharness.execution.memory import GIGABYTE, at_most
from vmharness.round_off import ROUND_OFF

if TYPE_CHECKING:
    from jinja2 import Environment, Template, nodes

SUFFIX = ".j2"
MOST = 2 * 10**8  # characters of a deck: some million elements
MEMORY = 2 * GIGABYTE
DEEPEST = 80  # nodes within each other: below what Python's compiler can read
LARGEST = 10**6  # bits of a whole number, and items of a repeated text or list
COMPILED = "<template>"  # the file of the code that Jinja2 makes


def render(path: Path, values: Mapping[str, float], most: float = MOST) -> str:
    """The deck that the template makes of `values`; numbers that are whole to round-off become integers.

    Raises CaseError with the line for an error in the template or an undefined name, and if the deck has more than
    `most` characters.
    """
    place = f"{path.parent.name}/{path.name}"
    numbers = {name: _whole(value) for name, value in values.items()}
    text = utf8(path.read_bytes(), place)
    try:
        with at_most(MEMORY):
            return "".join(_pieces(_compiled(text, place), numbers, most, place))
    except MemoryError as error:
        raise CaseError(f"{place}: {_what(error)}") from None


def _whole(value: float) -> float | int:
    """The whole number nearest to the result of a formula, where only round-off lies between them.

    >>> _whole(0.7 * 10.0 * 3.0), _whole(2.5)
    (21, 2.5)
    """
    nearest = round(value) if math.isfinite(value) else value
    return nearest if abs(value - nearest) <= ROUND_OFF * abs(value) else value


def _compiled(text: str, place: str) -> "Template":
    from jinja2 import StrictUndefined, TemplateSyntaxError, nodes
    from jinja2.compiler import CodeGenerator, Frame
    from jinja2.parser import Parser
    from jinja2.sandbox import SandboxedEnvironment

    class AtItsTurn(CodeGenerator):
        """Computes nothing but plain text before it is its turn, so that each error has its line."""

        def _output_child_to_const(self, node: nodes.Expr, frame: Frame, finalize: Any) -> str:
            if not isinstance(node, nodes.TemplateData):
                raise nodes.Impossible
            return super()._output_child_to_const(node, frame, finalize)

    environment = SandboxedEnvironment(
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        optimized=False,
    )
    environment.code_generator_class = AtItsTurn
    environment.intercepted_binops = frozenset({"*", "**"})
    environment.binop_table |= {"*": _product, "**": _power}
    try:
        parser = Parser(environment, text)
        tree = parser.parse()
        _check(tree, place)
        return environment.template_class.from_code(
            environment, environment.compile(tree), environment.make_globals(None)
        )
    except TemplateSyntaxError as error:
        raise CaseError(f"{place}:{error.lineno}: {error.message}") from None
    except RecursionError:
        raise CaseError(f"{place}:{parser.stream.current.lineno}: nested too deeply") from None
    except SyntaxError as error:  # of the code that Jinja2 makes
        line = _line_of_code(environment, tree, error.lineno or 0)
        raise CaseError(f"{place}:{line}: {error.msg}") from None


def _check(tree: "nodes.Node", place: str) -> None:
    """Raise CaseError for what is nested too deeply, and for a constant text that no file can hold."""
    from jinja2.nodes import Const

    level: list[nodes.Node] = [tree]
    for _ in range(DEEPEST):
        for node in level:
            if isinstance(node, Const) and isinstance(node.value, str) and (wrong := _no_text(node.value)):
                raise CaseError(f"{place}:{node.lineno}: makes {wrong!r}, which no file can hold")
        level = [child for node in level for child in node.iter_child_nodes()]
    if level:
        raise CaseError(f"{place}:{level[0].lineno}: nested deeper than {DEEPEST}")


def _no_text(text: str) -> str:
    """The first character that UTF-8 does not have, half of a surrogate pair; "" without any."""
    return next((one for one in text if "\ud800" <= one <= "\udfff"), "") if not text.isascii() else ""


def _pieces(template: "Template", numbers: Mapping[str, float], most: float, place: str) -> Iterator[str]:
    """The pieces of the deck; raises CaseError for whatever the template does wrong."""
    length = 0
    rendering: Any = template.root_render_func(template.new_context(dict(numbers)))
    try:
        for piece in rendering:
            length += len(piece)
            if length > most:
                raise OverflowError(f"the deck has more than {most:g} characters: its mesh is too fine")
            if wrong := _no_text(piece):
                raise ValueError(f"makes {wrong!r}, which no file can hold")
            yield piece
    except Exception as error:  # whatever a template can raise
        frame = rendering.gi_frame
        lines = [frame.f_lineno] if frame is not None else _lines(error)
        line = f":{template.get_corresponding_lineno(lines[-1])}" if lines else ""
        raise CaseError(f"{place}{line}: {_what(error)}") from None


def _lines(error: Exception) -> list[int]:
    """The lines of the compiled template that an error came through."""
    trace = walk_tb(error.__traceback__)
    return [line for frame, line in trace if frame.f_code.co_filename == COMPILED]


def _line_of_code(environment: "Environment", tree: "nodes.Template", line: int) -> int:
    """The line of the template that a line of its code is made from."""
    code = str(environment.compile(tree, raw=True))
    pairs = re.findall(r"(\d+)=(\d+)", code.rpartition("debug_info")[2])
    return max((int(own) for own, of_code in pairs if int(of_code) <= line), default=1)


def _what(error: Exception) -> str:
    """What is wrong, in words."""
    match error:
        case MemoryError():
            return f"takes more memory than {MEMORY // GIGABYTE} GB"
        case RecursionError():
            return "calls itself without end"
    return str(error) or type(error).__name__


def _product(left: Any, right: Any) -> Any:
    """left * right, of a bounded length."""
    for some, times in ((left, right), (right, left)):
        if isinstance(some, str | list | tuple) and isinstance(times, int) and len(some) * times > LARGEST:
            raise OverflowError(f"a text or list repeated {times} times is longer than {LARGEST:.0e}")
    return left * right


def _power(left: Any, right: Any) -> Any:
    """left ** right, of a bounded size."""
    if isinstance(left, int) and isinstance(right, int) and left.bit_length() * right > LARGEST:
        raise OverflowError(f"a power with the exponent {right} is too large")
    return left**right
