"""What is wrong with a case, said with its place in the file."""


class CaseError(Exception):
    """A case folder that cannot be used: `case.toml: [results] 3: what is wrong`."""
