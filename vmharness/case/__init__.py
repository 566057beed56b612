"""A case folder, read and checked, as frozen data."""

from vmharness.case.case import Case
from vmharness.case.error import CaseError
from vmharness.case.read import read

__all__ = ["Case", "CaseError", "read"]
