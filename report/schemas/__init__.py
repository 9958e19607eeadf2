"""JSON Schemas of all JSON files, checked by jsonschema."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema

from report.errors import ReportError

DIRECTORY = Path(__file__).parent


def check_schema(name: str, data: Any, where: str) -> None:
    """Raises ReportError, with the field that is wrong, where `data` does not fit the schema."""
    error = jsonschema.exceptions.best_match(_validator(name).iter_errors(data))
    if error is not None:
        field = ".".join(map(str, error.absolute_path)) or "the document"
        raise ReportError(f"{where}: {field}: {error.message}")


@cache
def _validator(name: str) -> Any:
    return jsonschema.Draft202012Validator(json.loads((DIRECTORY / f"{name}.json").read_text()))
