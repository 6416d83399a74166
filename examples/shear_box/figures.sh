#!/usr/bin/env bash
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Runs the cases of figures 8 to 14 and draws them into examples/shear_box/figures/.
#   bash examples/shear_box/figures.sh [--bin PROGRAM] [--spacing S] [--runs DIR] [--figures DIR] [--reuse]
#                                      [-- OPTIONS OF EVERY RUN]
# S is dr/H of the finest runs: 0.04, 0.02, 0.01 (default, as in the paper) or 0.005; half of it takes eight times as
# long. --reuse keeps the finished runs of an earlier call. Behind --: more options of shear_box, for example
# --set model.reading=times.

set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

bin=${BIN:-$root/build/openmp/examples/shear_box/shear_box}
python=${PYTHON:-/usr/bin/python3}
finest=0.01
runs=
figures=$here/figures
reuse=no

usage() { sed -n '5,10s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; }
while [ $# -gt 0 ]; do
  case $1 in
    --bin) bin=${2:?--bin needs a program}; shift 2 ;;
    --spacing) finest=${2:?--spacing needs a number}; shift 2 ;;
    --runs) runs=${2:?--runs needs a directory}; shift 2 ;;
    --figures) figures=${2:?--figures needs a directory}; shift 2 ;;
    --reuse) reuse=yes; shift ;;
    --) shift; break ;;
    -h | --help) usage; exit ;;
    *) echo "figures.sh: unknown argument $1" >&2; usage >&2; exit 2 ;;
  esac
done
extra=("$@")
runs=${runs:-$root/build/figures/$finest}

case $finest in
  0.04) spacings=(0.04) ;;
  0.02) spacings=(0.04 0.02) ;;
  0.01) spacings=(0.04 0.02 0.01) ;;
  0.005) spacings=(0.04 0.02 0.01 0.005) ;;
  *) echo "figures.sh: --spacing must be 0.04, 0.02, 0.01 or 0.005, not $finest" >&2; exit 2 ;;
esac
[ -x "$bin" ] || { echo "figures.sh: no program $bin; build it (cmake --build --preset openmp) or give --bin" >&2; exit 2; }

show() {
  printf '+ %s\n' "${*@Q}"
  "$@"
}
# run NAME OPTIONS: the results go to $runs/NAME.
run() {
  local output=$runs/$1
  shift
  if [ $reuse = yes ] && [ -f "$output/summary.json" ]; then
    echo "kept: $output"
    return
  fi
  rm -f "$output/summary.json"  # so that a run that is cut off is not taken for a finished one
  show "$bin" --quiet --force "$@" "${extra[@]}" --output "$output"
}
draw() { show "$python" "$here/plot.py" --output "$figures" --figure "$@"; }

symmetric=() asymmetric=()
for s in "${spacings[@]}"; do
  run "symmetric-$s" --set numerics.spacing="$s" --set output.frame_interval=2
  run "asymmetric-$s" --set numerics.spacing="$s" --set output.frame_interval=2 --set model.flux=asymmetric
  symmetric+=("$runs/symmetric-$s")
  asymmetric+=("$runs/asymmetric-$s")
done
d_bar=()
for d in 4 6 8; do
  run "d-bar-$d" --set numerics.spacing="$finest" --set output.frame_interval=2 \
    --set model.closure=shear-rate --set model.d_bar=0.00$d
  d_bar+=("$runs/d-bar-$d")
done
run one-period --set numerics.spacing="$finest" --set time.periods=1 --set output.frame_interval=0.25

draw 8 "$runs/one-period"
draw 9 "$runs/one-period"
draw 10 "$runs/symmetric-$finest" "$runs/asymmetric-$finest"
draw 11 "${asymmetric[@]}"
[ ${#spacings[@]} -lt 2 ] || draw 12 "${asymmetric[@]}" "${symmetric[@]}"
draw 13 "${d_bar[@]}"
draw 14 "$runs/symmetric-$finest" "$runs/asymmetric-$finest" "${d_bar[@]}"

find "$figures" -name 'figure_*.png' -size +150k -exec echo "note: larger than 150 kB: {}" \;
du -ch "$figures"/figure_*.png
