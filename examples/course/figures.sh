#!/usr/bin/env bash
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Runs every program of the course and draws figures/<program>.png: bash examples/course/figures.sh BUILD, for instance
# build/openmp. The runs take two to three minutes of one core and go to output/course, where finished ones are kept.

set -euo pipefail
[ $# = 1 ] || { sed -n '5,6s/^# //p' "${BASH_SOURCE[0]}"; exit 2; }
build=$(cd "$1" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export OMP_PROC_BIND=${OMP_PROC_BIND-false} OMP_WAIT_POLICY=${OMP_WAIT_POLICY-passive}

declare -A fields=([03]=group [05]=velocity [11]=fluid_pressure) # velocity where none is named
declare -A times=([01]=0,0.06,0.12,1 [02]=0,0.08,0.16,0.5 [17]=0,0.2,0.38,1) # s; four states of the whole run where none are named
mkdir -p examples/course/figures
for source in examples/course/*.cpp; do
  name=$(basename "$source" .cpp)
  folder=output/course/$name
  if [ ! -e "$folder/finished" ]; then
    mkdir -p "$folder"
    arguments=()
    if [ "$name" = 13_own_vessel ]; then
      python3 examples/course/vessel.py "$folder/vessel.stl"
      arguments=(vessel.stl)
    fi
    (cd "$folder" && "$build/examples/course/course_$name" ${arguments[@]+"${arguments[@]}"} >log && touch finished)
  fi
  at=${times[${name:0:2}]-}
  python3 examples/view "$folder" --field "${fields[${name:0:2}]-velocity}" ${at:+--times $at} \
    --picture "examples/course/figures/$name.png"
done
