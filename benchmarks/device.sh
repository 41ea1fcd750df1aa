#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
# Checks and measures on a machine that has a GPU and its driver, and next to nothing else.
#
#   device.sh pack BUILD FOLDER           where there is a build: an installation with its libraries and this script
#   FOLDER/device.sh OUT [--tiny|--quick] there: correctness suite, then scaling, cundall, features, into OUT
#
# Nothing is installed, compiled on the host or fetched. Needs bash, coreutils, and a C library at least as new
# as the one built with. Without NVIDIA's driver it takes whatever OpenCL platform the system has.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")

# Libraries of a program, but for the C library's own, which must be the system's.
libraries_of() {
  ldd "$1" | sed -n 's/.*=> \(\/[^ ]*\) .*/\1/p' |
    grep -Ev '/(libc|libm|libdl|libpthread|librt|libresolv|ld-linux[^/]*)\.so' || true
}

pack() {
  local build=$1 folder=$2 program
  cmake --install "$build" --prefix "$folder" >/dev/null
  mkdir -p "$folder/lib"
  for program in "$folder"/bin/* "$folder"/libexec/grainproof/*; do libraries_of "$program"; done | sort -u |
    while read -r library; do cp -L "$library" "$folder/lib/"; done
  cp "${BASH_SOURCE[0]}" "$folder/device.sh"
  chmod +x "$folder/device.sh"
}

# Where the driver is when the loader can't be asked.
has_nvidia() {
  { ldconfig -p 2>/dev/null || /sbin/ldconfig -p; } 2>/dev/null | grep -q libnvidia-opencl.so.1 ||
    compgen -G '/usr/lib*/**/libnvidia-opencl.so.1' >/dev/null || compgen -G '/usr/lib/*/libnvidia-opencl.so.1' >/dev/null
}

# The loader of OpenCL platforms is ours, so it is told of the driver by a file of ours.
name_driver() {
  has_nvidia || return 0
  mkdir -p "$1/vendors"
  echo libnvidia-opencl.so.1 >"$1/vendors/nvidia.icd"
  export OCL_ICD_VENDORS=$1/vendors
}

run() {
  local out=$1 how=${2:-} measured=opencl
  local -a cases=() sizes=()
  case $how in
    # One precision: kernels take longer to compile than all else.
    --tiny) cases=(settling) sizes=(--quick --most 900 --rounds 1 --seconds 0.002) measured=opencl:single ;;
    --quick) cases=(--quick) sizes=(--quick) ;;
    "") cases=(--quick) ;;
    *) echo "device.sh: found $how; expected --tiny or --quick" >&2; exit 2 ;;
  esac
  mkdir -p "$out"
  out=$(readlink -f "$out")
  export LD_LIBRARY_PATH=$here/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH} GRAINPROOF_DATA=$here/share/grainproof
  name_driver "$out"
  local program=$here/bin/grainproof
  "$program" doctor | tee "$out/doctor.txt"
  local status=0
  "$program" verify "${cases[@]}" --engines opencl --json "$out/verify.json" >"$out/verify.txt" || status=$?
  # Many at once take kernels of their own, on a GPU others than elsewhere: no case above has so many.
  "$program" verify "$GRAINPROOF_DATA/benchmarks/scenes/crowd.toml" --engines opencl --json "$out/crowd.json" \
    >"$out/crowd.txt" || status=$?
  tail -n 5 "$out/verify.txt" "$out/crowd.txt"
  "$program" bench scaling cundall features --engines "$measured" "${sizes[@]}" --cache "$out/cache" \
    --json "$out/bench.json" | tee "$out/bench.txt"
  [[ $status == 0 ]] || { echo "device.sh: verify ended with $status, see $out/verify.txt and crowd.txt" >&2; exit "$status"; }
}

case ${1:-} in
  pack) [[ $# == 3 ]] && pack "$2" "$3" ;;
  "" | -h | --help) sed -n '4,10s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" ;;
  *) run "$@" ;;
esac
