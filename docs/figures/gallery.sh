#!/usr/bin/env bash
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Runs the applications and draws docs/figures/gallery (docs/gallery.md): bash docs/figures/gallery.sh BUILD, for instance
# build/openmp. The runs take some seven minutes of one core. Results go to output/gallery, where finished ones are kept,
# with the time that each took in time.txt (processor seconds). Pictures of the course: examples/course/figures.sh.

set -euo pipefail
[ $# = 1 ] || { sed -n '5,7s/^# //p' "${BASH_SOURCE[0]}"; exit 2; }
build=$(cd "$1" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export OMP_PROC_BIND=${OMP_PROC_BIND-false} OMP_WAIT_POLICY=${OMP_WAIT_POLICY-passive} OMP_NUM_THREADS=${OMP_NUM_THREADS-1}
examples=$PWD/examples
out=$PWD/output/gallery
mkdir -p "$out"

# run NAME PROGRAM CASE OPTIONS: in $out, so that paths in case files are found there.
run() {
  local name=$1 program=$2 case=$3
  shift 3
  if [ -e "$out/$name/time.txt" ]; then
    echo "kept: $name"
    return
  fi
  (cd "$out" && TIMEFORMAT=%U && { time "$build/examples/$program/$program" "$examples/$program/$case" --quiet --force \
    --output "$name" "$@" >"$name.log" 2>&1; } 2>"$name.time" && mv "$name.time" "$name/time.txt")
  echo "$name: $(tail -n 1 "$out/$name/time.txt") s"
}

run column_collapse column_collapse column_collapse.toml --set output.interval=0.1
run footing footing_and_wheel footing.toml
run inclined_flow inclined_flow inclined_flow.toml --set slope.angle=22 --set output.duration=3
run shear_box shear_box shear_box.toml --set numerics.spacing=0.04
python3 "$examples/terrain/ground.py" "$out"
run terrain terrain terrain.toml --set numerics.spacing=3
run silo silo silo.toml
run wheel footing_and_wheel wheel.toml --set wheel.slip=0.3
python3 "$examples/blender/vessel.py" v "$out/v_blender.stl"
run blender blender blender.toml --set numerics.spacing=0.01 --set output.turns=0.5 --set output.frames=0.025
run drum drum ev.toml --set material.stiffness_factor=0.0028 --set time.duration=6 --set output.frame_interval=0.1
run ternary drum ternary.toml --set material.stiffness_factor=0.0028 --set time.duration=12

view() { python3 "$examples/view" "$@"; }
figures=docs/figures/gallery
mkdir -p "$figures"
view "$out/column_collapse" --field velocity --times 0,0.12,0.22,0.7 --picture "$figures/column_collapse.png"
view "$out/footing" --field pressure --states 2 --picture "$figures/footing.png"
view "$out/wheel" --field velocity --picture "$figures/wheel.png"
view "$out/shear_box" --field concentration --picture "$figures/shear_box.png"
view "$out/silo" --field concentration --times 0,0.3,0.6,1 --picture "$figures/silo.png"
view "$out/blender" --field concentration --picture "$figures/blender.png"
view "$out/drum" --field concentration --picture "$figures/drum.png"
view "$out/drum" --field concentration --inches 3.6 --film "$figures/drum.webp"
view "$out/blender" --field concentration --inches 3.6 --film "$figures/blender.webp"
/usr/bin/python3 "$examples/inclined_flow/plot.py" "$out/inclined_flow" && cp "$out/inclined_flow/profiles.png" "$figures/inclined_flow.png"
/usr/bin/python3 "$examples/drum/plot.py" "$out/ternary" --figure species
/usr/bin/python3 docs/figures/smaller.py "$out/ternary/species.png" "$figures/ternary.png" 760
(cd "$out" && /usr/bin/python3 "$examples/terrain/plot.py" terrain)
/usr/bin/python3 docs/figures/smaller.py "$out/terrain/terrain.png" "$figures/terrain.png" 760
ls -l "$figures"
