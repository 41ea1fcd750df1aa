# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
# What device.sh packs runs elsewhere, without the tree, and leaves its results there: here on PoCL.
set -eu
cmake=$1
build=$2
root=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset GRAINPROOF_DATA
PATH=$(dirname "$cmake"):$PATH
"$root/benchmarks/device.sh" pack "$build" "$work/packed"
for library in libOpenCL libbenchmark libstdc++; do
  compgen -G "$work/packed/lib/$library.so.*" >/dev/null || { echo "FAIL $library was not packed"; exit 1; }
done
mv "$work/packed" "$work/moved here"
cd /
"$work/moved here/device.sh" "$work/out" --tiny
for file in doctor.txt verify.json crowd.json bench.json; do
  test -s "$work/out/$file" || { echo "FAIL no $file"; exit 1; }
done
python3 - "$work/out" <<'CHECK'
import json, pathlib, sys
out = pathlib.Path(sys.argv[1])
verdicts = {row["verdict"] for row in json.loads((out / "verify.json").read_text())["results"]}
assert "pass" in verdicts and "fail" not in verdicts, verdicts
crowd = [row["verdict"] for row in json.loads((out / "crowd.json").read_text())["results"]]
assert crowd and set(crowd) == {"pass"}, crowd
rows = json.loads((out / "bench.json").read_text())["results"]
measured = {row["suite"] for row in rows if row["status"] == "completed"}
assert {"scaling", "cundall", "features", "roofline"} <= measured, measured
CHECK
