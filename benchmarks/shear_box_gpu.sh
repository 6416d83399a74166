#!/usr/bin/env bash
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Everything the shear box needs on a machine with an NVIDIA GPU, in one call: builds with CUDA and with OpenMP, runs the tests
# on the GPU, runs the shear box at four spacings in double and float on the GPU and in double on the CPU, and prints a table.
#   bash benchmarks/shear_box_gpu.sh OUT [spacing ...]
# CMAKE_ARGS adds arguments to both configurations (say -DCMAKE_PREFIX_PATH=...); SKIP_TESTS=1 leaves the tests out.
set -euo pipefail
cd "$(dirname "$0")/.."
out=${1:?usage: bash benchmarks/shear_box_gpu.sh OUT [spacing ...]}
shift
spacings=("$@")
[ ${#spacings[@]} -gt 0 ] || spacings=(0.04 0.02 0.01 0.005)
mkdir -p "$out"
export OMP_PROC_BIND=${OMP_PROC_BIND:-false} OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}
jobs=$(nproc)

build() { # preset target
  # shellcheck disable=SC2086
  cmake --preset "$1" -DSCREE_BUILD_BENCHMARKS=OFF ${CMAKE_ARGS:-} >"$out/configure_$1.log" 2>&1 ||
    { tail -30 "$out/configure_$1.log"; return 1; }
  cmake --build "build/$1" --target "$2" -- -k 0 -j"$jobs" >"$out/build_$1.log" 2>&1 ||
    { grep -E "error|FAILED" "$out/build_$1.log" | head -20; return 1; }
}
run() { # preset name options...
  local preset=$1 name=$2
  shift 2
  "build/$preset/examples/shear_box/shear_box" --output "$out/runs/$name" --force --quiet "$@" >"$out/runs_$name.log" 2>&1 ||
    tail -3 "$out/runs_$name.log"
}

run_all() { # preset prefix options...: every spacing and scheme
  local preset=$1 prefix=$2
  shift 2
  for spacing in "${spacings[@]}"; do
    for scheme in conservative hcsr; do
      run "$preset" "${prefix}_${scheme}_$spacing" --set "model.scheme=$scheme" --set "numerics.spacing=$spacing" \
        --set output.frame_interval=120 "$@"
    done
  done
}

mkdir -p "$out/runs"
SECONDS=0
build cuda shear_box
build openmp shear_box
echo "build of both: $SECONDS s"
SECONDS=0
OMP_NUM_THREADS=$((jobs > 4 ? jobs - 4 : jobs)) run_all openmp cpu_double & # beside the GPU, which needs one core
run_all cuda gpu_double
run_all cuda gpu_float --set numerics.precision=float
echo "runs on the GPU: $SECONDS s"
wait
echo "all runs: $SECONDS s"
{
  echo "host: $(nproc) cores, $(uname -m); device: $(nvidia-smi --query-gpu=name --format=csv,noheader 2>/dev/null || echo none)"
  echo "compilers: $(nvcc --version 2>/dev/null | sed -n 's/.*release \([0-9.]*\).*/nvcc \1/p'), $(c++ --version | head -1)"
  echo "source: ${GIT_HASH:-$(git rev-parse --short HEAD 2>/dev/null || echo unknown)}"
  python3 benchmarks/shear_box_table.py "$out/runs"
} | tee "$out/table.md"
if [ -z "${SKIP_TESTS:-}" ]; then
  SECONDS=0
  build cuda all || true
  echo "build of the tests: $SECONDS s"
  SECONDS=0
  (cd build/cuda && ctest -j4 --timeout 300 -E "headers|install|must_not_compile" >"$out/ctest.log" 2>&1) || true
  grep -E "tests passed|Failed|\*\*\*|Total Test time" "$out/ctest.log" | tail -40 || true
  echo "tests: $SECONDS s"
fi
