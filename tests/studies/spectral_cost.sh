#!/bin/sh
# What nine wavelengths cost against three on the same rays, in instructions: unlike times, these do not depend on what else the machine does.
# Needs valgrind (Debian package) and the built test_studies; some four minutes.
#
#   tests/studies/spectral_cost.sh [BUILD FOLDER]      default: build/release
set -eu
cd "$(dirname "$0")/../.."
build=${1:-build/release}
command -v callgrind_annotate >/dev/null || { echo "valgrind is missing: apt-get install valgrind"; exit 2; }
out=$(mktemp)
trap 'rm -f "$out"' EXIT
valgrind --tool=callgrind --callgrind-out-file="$out" --toggle-collect='*cpuOf*' "$build/bin/test_studies" \
  --gtest_filter='SpectralCost.NineSamplesCostLittleMoreThanThree' >/dev/null 2>&1 || true  # its times mean nothing here
callgrind_annotate --inclusive=yes --threshold=100 "$out" | awk '
  /PathSolver<4>::radiance\(/ { gsub(",", "", $1); three = $1 + 0 }
  /PathSolver<16>::radiance\(/ { gsub(",", "", $1); nine = $1 + 0 }
  END {
    if (!three || !nine) { print "no counts: were both kernels run?"; exit 1 }
    printf "nine samples against three: %.0f and %.0f million instructions, %.3f times\n", nine / 1e6, three / 1e6, nine / three
    exit nine > 1.05 * three
  }'
