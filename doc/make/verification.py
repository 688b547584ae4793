#!/usr/bin/env python3
"""Writes the page of verification from the tests themselves.

    verification.py BUILD_DIRECTORY UNIT_TESTS OUTPUT

A test of ctest is a suite of GoogleTest and carries a label, the kind of its
evidence; the names of the tests are the claims.
"""

import collections
import contextlib
import json
import re
import subprocess
import sys

KINDS = {
    "theory": ("Theory", "Compared with a formula, an exact solution or an invariant that must hold."),
    "reference": ("Other codes and tables", "Compared with published values or with the results of an independent program (`tests/reference`)."),
    "documents": ("Pages", "Their tables, numbers in the text, pictures and quoted output are what the program gives."),
    "interface": ("Interface", "What the program reads, writes, says and answers to mistakes."),
}


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def sentence(name):
    """The words of a name: PeakForceIsFound becomes "Peak force is found"."""
    name = re.sub(r"/\d+$", "", name)
    words = re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+", name)
    words = [word if word.isupper() and len(word) > 1 else word.lower() for word in words]
    text = " ".join(words)
    return text[:1].upper() + text[1:]


def claims(unit_tests):
    """Names of the tests of every suite, instances of parameters once."""
    found = collections.defaultdict(list)
    suite = None
    for line in output_of(unit_tests, "--gtest_list_tests").splitlines():
        if line.startswith("Running "):
            continue
        if not line.startswith(" "):
            suite = line.split("#")[0].strip().rstrip(".").split("/")[-1]
        else:
            name = re.sub(r"/.*$", "", line.split("#")[0].strip())
            if name not in found[suite]:
                found[suite].append(name)
    return found


def main():
    build, unit_tests = sys.argv[1:3]
    tests = json.loads(output_of("ctest", "--test-dir", build, "--show-only=json-v1"))["tests"]
    by_kind = collections.defaultdict(list)
    for test in tests:
        labels = next((p["value"] for p in test.get("properties", []) if p["name"] == "LABELS"), ["without label"])
        for label in labels:
            if label != "long":
                by_kind[label].append(test["name"])
    known = claims(unit_tests)

    print("# Verification {#verification}\n")
    print("From each claim to the test that checks it, by kind of evidence; written from "
          "the tests and their labels when this site is built. A test runs with "
          "`ctest --test-dir build/release -R SUITE` or "
          "`build/release/tests/unit_tests --gtest_filter=SUITE.TEST`.")
    for label in sorted(by_kind, key=lambda l: (list(KINDS) + [l]).index(l)):
        title, meaning = KINDS.get(label, (label.capitalize(), ""))
        suites = by_kind[label]
        number = sum(len(known.get(suite, [suite])) for suite in suites)
        print(f"\n## {title}\n\n{meaning} {number} claims.\n\n| claim | suite | test |\n| --- | --- | --- |")
        for suite in suites:
            for name in known.get(suite, []) or [""]:
                print(f"| {sentence(name or suite)} | {suite} | {f'`{name}`' if name else 'by ctest'} |")


if __name__ == "__main__":
    with open(sys.argv[-1], "w", encoding="utf-8") as page, contextlib.redirect_stdout(page):
        main()
