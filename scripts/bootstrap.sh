# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the launchers: installs what is missing, then builds. Everything it says goes to stderr.
set -euo pipefail

say() { printf 'grainproof: %s\n' "$*" >&2; }

stop() {
  say "$@"
  exit 2
}

# Package names of a list, without its comments.
listed_packages() { sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$1"; }

# Those of a list that dpkg does not have installed.
missing_packages() {
  local names installed
  names=$(listed_packages "$1")
  # shellcheck disable=SC2086  # one word a package
  installed=$(dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' $names 2>/dev/null | sed -n 's/^ii  *//p' || true)
  comm -23 <(sort -u <<<"$names") <(sort -u <<<"$installed")
}

# How to become root without a question where nobody could answer it; fails where that is not possible.
as_root() {
  if [[ $(id -u) == 0 ]]; then
    "$@"
  elif command -v sudo >/dev/null && { [[ -t 0 ]] || sudo -n true 2>/dev/null; }; then
    sudo "$@"
  else
    return 125
  fi
}

apt() { as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 "$@" </dev/null; }

install_packages() {
  local log status=0
  log=$(mktemp)
  { apt update && apt install --no-install-recommends "$@"; } >"$log" 2>&1 || status=$?
  if [[ $status == 125 ]]; then
    stop "installing needs root, and there is neither root nor sudo here. Ask for:
    apt-get install --no-install-recommends $*
or set GRAINPROOF_NO_INSTALL=1 to build with what is there."
  elif [[ $status != 0 ]]; then
    cat "$log" >&2
    stop "apt-get failed (above). Install by hand, then start again:
    apt-get install --no-install-recommends $*"
  fi
  rm -f "$log"
}

# install_missing LIST: without a missing package this asks dpkg only, never the network.
install_missing() {
  [[ -z ${GRAINPROOF_NO_INSTALL:-} ]] || return 0
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    command -v cmake >/dev/null && command -v ninja >/dev/null || stop "this is not Debian, so nothing is installed \
for you. Install your system's packages for these and start again:
$(sed -n 's/^[a-z]/    &/p' "$1")"
    return 0
  fi
  local missing
  missing=$(missing_packages "$1")
  [[ -n $missing ]] || return 0
  say "installing what is missing (apt-get, from scripts/packages.txt):"
  awk 'NR == FNR { missing[$1]; next } $1 in missing { print "    " $0 }' - "$1" <<<"$missing" >&2
  # shellcheck disable=SC2086
  install_packages $missing
  say "installed."
}

# Shows ninja's steps: one rewritten line on a terminal, else one line when there is work at all.
show_progress() {
  local line shown=
  while IFS= read -r line; do
    [[ $line == \[* ]] || continue
    if [[ -t 2 ]]; then
      printf '\r\033[Kgrainproof: building %s' "${line%%]*}]" >&2
    elif [[ -z $shown ]]; then
      say "building …"
    fi
    shown=yes
  done
  [[ -z $shown || ! -t 2 ]] || printf '\r\033[K' >&2
}

# A build folder that was configured for another place, as after a move, is configured anew.
configure() {
  local build=$1 log=$1/configure.log
  local home
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt" 2>/dev/null || true)
  [[ ! -f $build/build.ninja || $home != "$PWD" ]] || return 0
  say "configuring …"
  ! command -v ccache >/dev/null || export CMAKE_CXX_COMPILER_LAUNCHER=ccache
  rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
  if ! cmake --preset release >"$log" 2>&1; then
    cat "$log" >&2
    stop "configuring failed (above; kept in $log)"
  fi
}

# build ROOT TARGET…: leaves an up-to-date Release build in ROOT/build/release.
build() {
  local build=$1/build/release
  mkdir -p "$build"
  (
    cd "$1"
    exec 9>"$build/.lock"
    flock 9
    configure "$build"
    if ! ninja -C "$build" "${@:2}" 2>&1 | tee "$build/build.log" | show_progress; then
      cat "$build/build.log" >&2
      stop "the build failed (above; kept in $build/build.log)"
    fi
  )
}
