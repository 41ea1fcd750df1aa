# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
# The launchers' shared part, against lists of its own and with apt-get replaced by a recorder.
set -u
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# expect NAME WANTED FOUND
expect() {
  [[ $2 == "$3" ]] && return
  printf 'FAIL %s\n  wanted: %s\n  found:  %s\n' "$1" "$2" "$3"
  failures=$((failures + 1))
}

expect_has() { expect "$1 (has '$2')" yes "$([[ $3 == *"$2"* ]] && echo yes || echo "$3")"; }

# Runs a line in a fresh shell with the launchers' functions; apt-get and dpkg-query are ours. The only
# packages "installed" are bash and coreutils; what apt-get is asked for goes to $work/asked.
in_bootstrap() {
  mkdir -p "$work/bin"
  printf '#!/bin/bash\necho "$@" >>%q\nexit ${APT_STATUS:-0}\n' "$work/asked" >"$work/bin/apt-get"
  printf '#!/bin/bash\nprintf "ii  bash\\nii  coreutils\\nrc  gone\\n"\n' >"$work/bin/dpkg-query"
  printf '#!/bin/bash\n[[ $1 == -u ]] && echo "${FAKE_UID:-0}"\n' >"$work/bin/id"
  chmod +x "$work"/bin/*
  rm -f "$work/asked"
  PATH="$work/bin:/usr/bin:/bin" bash -c "source '$root/scripts/bootstrap.sh'; $1" 2>&1 </dev/null
}

printf '# a comment\nbash   # shell\n\ncoreutils\n' >"$work/all.txt"
printf 'bash  # shell\ngone  # removed, its settings kept\nno-such-package  # nothing\n' >"$work/some.txt"

expect "comments and blanks are no packages" "bash coreutils" \
  "$(in_bootstrap "listed_packages '$work/all.txt'" | xargs)"
expect "nothing is missing when all is installed" "" "$(in_bootstrap "missing_packages '$work/all.txt'")"
expect "removed and unknown packages are missing" "gone no-such-package" \
  "$(in_bootstrap "missing_packages '$work/some.txt'" | xargs)"

expect "nothing is said when nothing is missing" "" "$(in_bootstrap "install_missing '$work/all.txt'")"
expect "apt-get is not started when nothing is missing" no "$([[ -e $work/asked ]] && echo yes || echo no)"

said=$(in_bootstrap "install_missing '$work/some.txt'")
expect_has "what is installed is said first" "no-such-package  # nothing" "$said"
expect_has "apt-get installs what is missing" "install --no-install-recommends gone no-such-package" "$(cat "$work/asked")"
expect_has "apt-get asks no question" " -y " "$(cat "$work/asked")"

said=$(FAKE_UID=1000 in_bootstrap "sudo() { return 1; }; install_missing '$work/some.txt'; echo went on")
expect_has "without root and sudo it says what to ask for" "apt-get install --no-install-recommends gone no-such-package" "$said"
expect "without root and sudo it stops" "" "$(grep 'went on' <<<"$said")"

said=$(APT_STATUS=100 in_bootstrap "install_missing '$work/some.txt'; echo went on")
expect_has "a failing apt-get is reported" "apt-get failed" "$said"
expect "a failing apt-get stops" "" "$(grep 'went on' <<<"$said")"

expect "GRAINPROOF_NO_INSTALL leaves the system alone" "" \
  "$(GRAINPROOF_NO_INSTALL=1 in_bootstrap "install_missing '$work/some.txt'")"

said=$(in_bootstrap "command() { return 1; }; install_missing '$work/some.txt'; echo went on")
expect_has "elsewhere than on Debian it lists what is needed" "this is not Debian" "$said"
expect_has "elsewhere than on Debian it names the packages" "gone  # removed" "$said"

exit $((failures > 0))
