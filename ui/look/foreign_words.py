"""What libraries and operating systems say of files and fields, which errors of the core quote: here so that it is translated."""

from __future__ import annotations

FOREIGN = (
    # pydantic, of the fields of a file
    "Field required",
    "Input should be {expected}",
    "Input should be greater than {limit}",
    "Input should be greater than or equal to {limit}",
    "Input should be less than {limit}",
    "Input should be less than or equal to {limit}",
    "Input should be a valid string",
    "Input should be a valid number",
    "Input should be a valid integer",
    "Input should be a valid integer, got a number with a fractional part",
    "Input should be a valid boolean",
    "Input should be a valid list",
    "Input should be a valid tuple",
    "Input should be a valid dictionary",
    "Input should be a valid dictionary or instance of {model}",
    "Input should be a finite number",
    "Input should be a valid number, unable to parse string as a number",
    "Input should be a valid integer, unable to parse string as an integer",
    "String should have at least {count} character",
    "String should have at least {count} characters",
    "String should have at most {count} characters",
    "String should match pattern {pattern}",
    "List should have at least {count} items after validation, not {found}",
    "Tuple should have at least {count} items after validation, not {found}",
    "Tuple should have at most {count} items after validation, not {found}",
    # operating systems and the standard library
    "No such file or directory",
    "Permission denied",
    "No space left on device",
    "Input/output error",
    "Is a directory",
    "Not a directory",
    "Connection refused",
    "Connection reset by peer",
    "Read-only file system",
    "File is not a zip file",
    "file is not a database",
)
"""Texts with their values as templates."""
