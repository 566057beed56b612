"""What is wrong in a deck, and where."""


class DeckError(Exception):
    """A deck cannot be read or used; `str` is "file:line: *KEYWORD: FIELD = value: what is wrong".

    Parts that are not known are left out.

    >>> str(DeckError("only 2 is supported", "deck.k", 21, "SECTION_SHELL", "elform", 16))
    'deck.k:21: *SECTION_SHELL: ELFORM = 16: only 2 is supported'
    >>> str(DeckError("no such file", "deck.k"))
    'deck.k: no such file'
    """

    def __init__(
        self,
        what: str,
        file: str = "",
        line: int = 0,
        keyword: str = "",
        field: str = "",
        value: object = None,
    ) -> None:
        super().__init__(what, file, line, keyword, field, value)  # args: so that it survives a pickle
        self.what = what
        self.file = file
        self.line = line
        self.keyword = keyword
        self.field = field
        self.value = value

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}" if self.line else self.file
        keyword = f"*{self.keyword}" if self.keyword else ""
        field = f"{self.field.upper()} = {show(self.value)}" if self.field else ""
        return ": ".join(part for part in (place, keyword, field, self.what) if part)


def show(value: object) -> str:
    """A value as a deck would write it.

    >>> show(0.5), show(""), show("A")
    ('0.5', '(blank)', 'A')
    """
    return "(blank)" if value is None or value == "" else str(value)
