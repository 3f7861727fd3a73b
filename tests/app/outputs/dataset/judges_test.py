#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is exported, before those who judge such data elsewhere: `judges_test.py EXCHANGE_TEST XAPI_TEST FOLDER`. Data sets
by npm's bids-validator (Motion-BIDS), datapackage (Frictionless) and hyparquet (Parquet), each learning record that the tests send by
xapi-validation. The packages come from npm, or its cache, into FOLDER. Exit status 1 when a judge finds something, 77
where there is no way to them."""
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parents[3] / "support"))
from npm_packages import node_modules  # noqa: E402

DATASETS = ("Dataset.IsReadByTheReferenceLibraryOfFrictionless:Dataset.IsAcceptedByTheValidatorOfBids:"
            "Dataset.AsParquetIsReadByAnotherReader:Dataset.AsLerobotIsReadByAnotherReaderAsItsDescriptionSays")
STATEMENTS = """
const validate = require("xapi-validation/dist/index").default;
const lines = require("fs").readFileSync(process.argv[1], "utf8").split("\\n").filter(Boolean);
const statements = lines.map((line) => JSON.parse(line)).filter((one) => one.actor); // a test puts others there itself
const wrong = statements.map((one) => [one, validate(one, ["statement"])]).filter(([, findings]) => findings.length > 0);
wrong.forEach(([one, findings]) => console.log(JSON.stringify(one), JSON.stringify(findings)));
console.log(`${statements.length} statements, ${wrong.length} with findings`);
process.exit(wrong.length === 0 && statements.length > 0 ? 0 : 1);"""


def output_of(command, **environment):
    done = subprocess.run(command, env={**os.environ, **environment}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, timeout=300, check=False)
    return done.returncode, done.stdout


def main(exchange_test, xapi_test, folder):
    modules = node_modules(HERE.parent / "npm", folder)
    if modules is None:
        print("npm has not got the judges and cannot fetch them")
        return 77
    code, said = output_of([exchange_test, f"--gtest_filter={DATASETS}"], NODE_PATH=str(modules))
    if code != 0 or said.count("[       OK ]") != DATASETS.count(":") + 1:
        print(said)
        return 1
    with tempfile.TemporaryDirectory() as own:
        sent = pathlib.Path(own) / "statements"
        code, said = output_of([xapi_test], TORSIO_LRS_OUT=str(sent))
        if code == 0:
            code, said = output_of(["node", "-e", STATEMENTS, str(sent)], NODE_PATH=str(modules))
    print(said)
    return 1 if code else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
