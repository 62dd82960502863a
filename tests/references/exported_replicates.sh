#!/bin/sh
# Replicates of what `goniolux export PROJECT --to radiance -o DIR` wrote, by Radiance: mean and standard error of every grid.
#
#   tests/references/exported_replicates.sh DIR [REPLICATES [AMBIENT_DIVISIONS]]      default: 6 and 128
#
# Needs rtrace and oconv on the PATH and RAYPATH set (Debian: radiance; or the folders bin and lib of `pip install pyradiance`).
# The order of the points is shuffled for each replicate, which changes Radiance's random numbers.
set -eu
cd "$1"
replicates=${2:-6}
divisions=${3:-128}
options="-I -h -aa 0 -ab 12 -ad $divisions -as 0 -lr -20 -lw 1e-3 -dt 0 -dc 1 -ds .1 -dj .95 -dr 2 -dp 0 -st 0"
oconv scene.rad >scene.oct
for points in *.pts; do
  replicate=1
  while [ "$replicate" -le "$replicates" ]; do
    # shellcheck disable=SC2086
    awk -v seed="$replicate" 'BEGIN { srand(seed) } { print rand(), $0 }' "$points" | sort -n | cut -d' ' -f2- |
      rtrace $options scene.oct | awk '{ sum += $1 + $2 + $3 } END { print sum / NR }'
    replicate=$((replicate + 1))
  done | awk -v name="${points%.pts}" '{ n++; sum += $1; squares += $1 * $1 }
    END { mean = sum / n; printf "%s: %.2f lx, standard error %.2f lx of %d replicates\n", name, mean,
          n > 1 ? sqrt((squares / n - mean * mean) / (n - 1)) : 0, n }'
done
