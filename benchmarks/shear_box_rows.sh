#!/usr/bin/env bash
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# The variants of the shear box in the README's second table: bash benchmarks/shear_box_rows.sh PROGRAM OUT [PATTERN]
# PROGRAM is build/<preset>/examples/shear_box/shear_box. Rows whose name does not match PATTERN are left out.
set -euo pipefail
program=${1:?usage: bash benchmarks/shear_box_rows.sh PROGRAM OUT}
out=${2:?usage: bash benchmarks/shear_box_rows.sh PROGRAM OUT}
pattern=${3:-.}
export OMP_PROC_BIND=${OMP_PROC_BIND:-false}
mkdir -p "$out"

row() { # name spacing options...
  local name=$1 spacing=$2
  shift 2
  [[ $name =~ $pattern ]] || return 0
  "$program" --output "$out/$name-$spacing" --force --quiet --set "numerics.spacing=$spacing" --set output.frame_interval=120 "$@" ||
    { echo "| $name | $spacing | failed |"; return; }
  python3 - "$name" "$spacing" "$out/$name-$spacing/summary.json" <<'P'
import json, sys
name, spacing, path = sys.argv[1:]
s = json.load(open(path))
errors = {round(c["time"]): c["mae_width"] for c in s["compared"]}
particles = {round(c["time"]): c["mae_particles"] for c in s["compared"]}
columns = " | ".join(f"{errors.get(t, float('nan')):.2e}" for t in (20, 40, 60, 80))
print(f"| {name} | {spacing} | {columns} | {particles.get(80, float('nan')):.2e} | {s['mean_C_drift']:.1e} "
      f"| {s['min_C']:.1e} | {1 - s['max_C']:.1e} | {s['wall_seconds']:.1f} |", flush=True)
P
}
echo "| case | dr/H | MAE width 20 T | 40 T | 60 T | 80 T | MAE of particles 80 T | mean C drift | min C | 1 - max C | seconds |"
echo "|---|---|---|---|---|---|---|---|---|---|---|"
for spacing in 0.04 0.02 0.01 0.005; do row upright $spacing --set geometry.upright=true; done
for spacing in 0.04 0.02 0.01 0.005; do row asymmetric $spacing --set model.flux=asymmetric; done
for spacing in 0.04 0.02 0.01 0.005; do row times $spacing --set model.reading=times; done
for spacing in 0.04 0.02 0.01 0.005; do row times-asymmetric $spacing --set model.reading=times --set model.flux=asymmetric; done
for spacing in 0.02 0.01 0.005; do row jitter-10 $spacing --set numerics.jitter=0.1; done
for spacing in 0.02 0.01 0.005; do row jitter-5 $spacing --set numerics.jitter=0.05; done
for d in 0.004 0.006 0.008; do
  for spacing in 0.02 0.01 0.005; do row "shear-rate-$d" $spacing --set model.closure=shear-rate --set "model.d_bar=$d"; done
done
for scheme in conservative hcsr; do
  for boundary in periodic walled; do
    row "3d-$boundary-$scheme" 0.04 --set "model.scheme=$scheme" --set numerics.dimension=3 --set "numerics.depth_boundary=$boundary"
  done
done
for flux in symmetric asymmetric; do
  for reading in chi times; do
    for spacing in 0.04 0.02 0.01 0.005; do
      row "hcsr-$reading-$flux" $spacing --set model.scheme=hcsr --set "model.reading=$reading" --set "model.flux=$flux"
    done
  done
done
