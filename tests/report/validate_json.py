#!/usr/bin/env python3
"""Validates JSON files: validate_json.py SCHEMA FILE... Prints what is wrong; exit code 1."""

import json
import sys

import jsonschema


def no_constants(name):
    raise ValueError(f"{name} is no JSON")


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    faults = 0
    for name in sys.argv[2:]:
        with open(name, encoding="utf-8") as file:
            report = json.load(file, parse_constant=no_constants)
        for fault in validator.iter_errors(report):
            print(f"{name}: {'/'.join(map(str, fault.absolute_path))}: {fault.message[:300]}")
            faults += 1
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
