"""Writes tests/stability/cases and cases.json:  python3 tests/stability/make

Each case is a folder of project files (and the files that they name) and a row of cases.json. Reference values are
calculated here, from closed forms and integrals that stand beside them, or quoted with their source; never by Goniolux.
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.dont_write_bytecode = True

import direct  # noqa: E402
import files  # noqa: E402
import glass  # noqa: E402
import interreflection  # noqa: E402
import mirrors  # noqa: E402
import robustness  # noqa: E402
import suite  # noqa: E402

for part in (direct, files, interreflection, glass, mirrors, robustness):
    part.make()
suite.write(Path(__file__).resolve().parent.parent)
