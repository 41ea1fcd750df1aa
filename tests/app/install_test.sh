# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
# An installed program works from wherever it is moved to, spaces included, without its sources.
set -eu
cmake=$1
build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset GRAINPROOF_DATA
"$cmake" --install "$build" --prefix "$work/first" >/dev/null
mkdir "$work/moved to"
mv "$work/first" "$work/moved to/there"
program="$work/moved to/there/bin/grainproof"
cd /
"$program" doctor | grep -F "$work/moved to/there/share/grainproof"
"$program" verify settling --engines reference
ln -s "$program" "$work/linked"
"$work/linked" run settling
