#!/usr/bin/env bash
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# From a fresh clone to a result:
#
#   bash cmake/quickstart.sh column-collapse      run a column of sand that collapses, draw it, compare it with experiments
#   bash cmake/quickstart.sh shear-box            run the shear box, draw it, compare it with its reference
#   bash cmake/quickstart.sh drum [--cuda]        build an example, by its folder, and tell how it is run
#   bash cmake/quickstart.sh drum --mpi           the same for the processes of mpirun; the first two too run on them
#   bash cmake/quickstart.sh test [--cuda]        build and run all tests: about half an hour on two cores
#   bash cmake/quickstart.sh test --quick         a part of them: about two minutes
#   bash cmake/quickstart.sh docs                 build the documentation site in build/docs: some seconds
#   bash cmake/quickstart.sh pack                 build all examples; pack them for machines without a compiler
#   bash cmake/quickstart.sh packages             install all packages that developers use, and do nothing else
#
# It may be repeated: only what is missing or has changed is done again. Debian or Ubuntu packages that are missing are
# installed (as root, or through sudo); elsewhere it names what is missing. --cuda uses the GPU when there is one.

set -euo pipefail

source_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=openmp

usage() { sed -n 's/^# \{0,1\}//; 5,19p' "${BASH_SOURCE[0]}"; }
say() { printf '\n== %s\n' "$*"; }
fail() { printf '\nquickstart: %s\n' "$*" >&2; exit 1; }
as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }

# --- what is needed ----------------------------------------------------------------------------------------------------

packages=(g++ cmake ninja-build ccache libeigen3-dev libhdf5-dev libcli11-dev libtomlplusplus-dev python3-matplotlib python3-h5py
          ca-certificates)
packages_of_docs=(doxygen mkdocs mkdocs-material katex python3)
packages_of_developers=(clang-format dpkg-dev file git libbenchmark-dev reuse)
tools=(c++ cmake ninja python3) # looked for where there is no dpkg

missing_packages() {
  local package
  for package in "${packages[@]}"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || echo "$package"
  done
}

install_packages() {
  if ! command -v dpkg-query >/dev/null; then
    local tool
    for tool in "${tools[@]}"; do
      command -v "$tool" >/dev/null || fail "'$tool' is missing. Install what these Debian packages hold: ${packages[*]}"
    done
    return
  fi
  local missing
  missing=$(missing_packages)
  [ -n "$missing" ] || return 0
  say "Installing" $missing
  [ "$(id -u)" = 0 ] || command -v sudo >/dev/null || fail "run this as root: apt-get install" $missing
  # Package lists may be old or absent: refresh them only when the first try fails.
  apt_install $missing || { as_root apt-get -q update && apt_install $missing; } ||
    fail "apt-get could not install:" $missing
  # Where Catch2 is new enough (Debian 13, Ubuntu 24.04) it need not be built.
  [[ $command != @(test|packages) ]] || [[ $(apt-cache policy catch2) != *"Candidate: 3."[4-9]* ]] || apt_install catch2 || true
}

apt_install() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y install --no-install-recommends "$@"
}

# --- CPU or GPU --------------------------------------------------------------------------------------------------------

find_nvcc() {
  command -v nvcc || ls "${CUDA_ROOT:-/usr/local/cuda}/bin/nvcc" 2>/dev/null
}

choose_gpu() {
  local capability
  if ! find_nvcc >/dev/null; then
    say "There is no CUDA compiler (nvcc) here: using the CPU. Install the CUDA toolkit or set CUDA_ROOT to use the GPU."
    return
  fi
  if capability=$(nvidia-smi --query-gpu=compute_cap --format=csv,noheader 2>/dev/null | head -n 1); then
    say "Using the GPU, of compute capability $capability"
    options+=(-DSCREE_CUDA_ARCH="${capability/./}")
  elif [ -e /dev/nvidia0 ]; then
    say "Using the GPU; nvidia-smi does not tell its compute capability, so it is taken for an H100 or H200"
  else
    say "There is no NVIDIA GPU here: using the CPU"
    return
  fi
  preset=cuda
}

# --- steps -------------------------------------------------------------------------------------------------------------

# Memory, not cores, limits how many compilers may run: up to 3 GB each.
jobs() {
  local cores gigabytes
  cores=$(nproc)
  gigabytes=$(awk '/MemAvailable/ { print int($2 / 3000000) }' /proc/meminfo)
  echo $((gigabytes < 1 ? 1 : gigabytes < cores ? gigabytes : cores))
}

configure() {
  # A new build folder gets tests and benchmarks, which need more packages, when 'test' asks for them.
  if [ "$command" = test ]; then
    options+=(-DSCREE_BUILD_TESTS=ON -DSCREE_BUILD_BENCHMARKS=ON)
  elif ! [ -e "$source_folder/build/$preset/CMakeCache.txt" ]; then
    options+=(-DSCREE_BUILD_TESTS=OFF -DSCREE_BUILD_BENCHMARKS=OFF)
  fi
  say "Configuring build/$preset (the first time, this also builds Kokkos: a minute or two)"
  cmake -S "$source_folder" --preset "$preset" ${options[@]+"${options[@]}"} || fail "configuring failed; see above"
}

build() {
  say "Building $*"
  cmake --build "$source_folder/build/$preset" --parallel "$(jobs)" --target "$@" || fail "building failed; see above"
}

# Benchmarks are no tests; CTest runs theirs where they are built.
run_tests() {
  local folders="core kernels laws neighbours pairs" case="verification: a column rests under the linear filter"
  if [ "$quick" = yes ]; then
    say "Building and running tests of: $folders; and '$case'. This takes about two minutes on two cores."
    configure
    # shellcheck disable=SC2086
    build $(printf 'test_%s ' $folders) test_verification_column_at_rest
    run_ctest --tests-regex "^((${folders// /|}): |$case\$)"
  else
    say "Building and running all tests: this takes about half an hour on two cores, of which the tests run for less than half."
    configure
    build scree_tests
    run_ctest --label-exclude '^(benchmarks|programs|headers_alone)$'
  fi
}

run_ctest() {
  say "Testing"
  ctest --test-dir "$source_folder/build/$preset" --output-on-failure --progress --parallel "$(jobs)" "$@"
}

# Nothing is compiled for it.
build_site() {
  say "Building the documentation site"
  python3 docs/site/build.py build/docs || fail "the documentation has mistakes; see above"
}

build_example() {
  local case
  configure
  build "$example"
  case=$(cd "$source_folder/examples/$example" && ls -- *.toml | head -n 1)
  say "Run it with"
  echo "${mpirun:+$mpirun }build/$preset/examples/$example/$example examples/$example/$case --output OUT"
}

make_packages() {
  configure
  build scree_examples
  say "Packing"
  rm -rf "build/$preset/packages"
  cpack --config "build/$preset/CPackConfig.cmake" || fail "packing failed; see above"
  say "Packages: how they are installed is told in docs/install.md"
  ls "build/$preset"/packages/scree*
}

# Runs an example of which one instance can be built alone, draws its results, and says whether they are right.
run_example() {
  local program="$source_folder/build/$preset/examples/$example/${example}_quick"
  local folder="$source_folder/examples/$example"
  local output="$source_folder/output/$example"
  configure
  build "${example}_quick"
  say "Running $example"
  mkdir -p "$(dirname "$output")"
  $mpirun "$program" "$folder/$example.toml" --output "$output" --force
  say "Drawing"
  local python
  for python in python3 /usr/bin/python3; do # one of the user's own may stand before the system's, which has the modules
    "$python" -c 'import h5py, matplotlib' 2>/dev/null && break
  done
  "$python" "$folder/plot.py" "$output"
  say "Results"
  find "$output" \( -name '*.png' -o -name '*.pdf' -o -name '*.svg' -o -name '*.vtkhdf' \) | sort
  say "Is it right?"
  "$python" "$folder/verdict.py" "$output" || fail "the result is not the expected one; see above"
  say "Next"
  echo "$python examples/view output/$example --page output/$example/run.html"
  echo "  makes a page that shows the particles over time in a browser;"
  if [ "$example" = column_collapse ]; then
    echo "bash cmake/quickstart.sh shear-box"
    echo "  runs grains that separate by size, and compares them with a reference solution."
  else
    echo "bash cmake/quickstart.sh column-collapse"
    echo "  runs sand that flows, with stress and walls."
  fi
  echo "examples/course/README.md goes on to programs of your own; examples/$example/README.md explains the results above."
}

# --- main --------------------------------------------------------------------------------------------------------------

command=${1-}
shift || true
want_gpu=no
want_mpi=no
quick=no
example=
mpirun=
for option in "$@"; do
  case $option in
    --cuda) want_gpu=yes ;;
    --mpi) want_mpi=yes ;;
    --quick) quick=yes ;;
    *) usage >&2; fail "unknown option '$option'" ;;
  esac
done
case $command in
  column-collapse | column_collapse | shear-box | shear_box) example=${command//-/_} command=run ;;
  test)
    [ "$want_mpi" = no ] || fail "--mpi goes with an example"
    packages+=(libbenchmark-dev)
    ;;
  docs)
    [ "$quick$want_gpu$want_mpi" = nonono ] || fail "'docs' has no options"
    packages=("${packages_of_docs[@]}")
    tools=(doxygen mkdocs python3)
    ;;
  pack)
    [ "$quick$want_gpu$want_mpi" = nonono ] || fail "'pack' has no options"
    packages+=(dpkg-dev file) # CPack looks at programs with 'file'
    ;;
  packages)
    [ "$quick$want_gpu$want_mpi" = nonono ] || fail "'packages' has no options"
    packages+=("${packages_of_docs[@]}" "${packages_of_developers[@]}")
    tools+=(doxygen mkdocs clang-format git reuse)
    ;;
  help | -h | --help) usage; exit ;;
  *)
    example=${command//-/_}
    ls "$source_folder/examples/$example"/*.toml >/dev/null 2>&1 ||
      { usage >&2; fail "say an example, 'test', 'docs', 'pack' or 'packages'"; }
    command=example
    ;;
esac
[ "$quick" = no ] || [ "$command" = test ] || fail "--quick goes with 'test'"

export OMP_PROC_BIND=${OMP_PROC_BIND-spread} OMP_PLACES=${OMP_PLACES-threads} # else Kokkos warns
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY-passive} # threads that spin stop each other on a busy machine
options=()
if [ "$want_mpi" = yes ]; then
  packages+=(libopenmpi-dev openmpi-bin)
  tools+=(mpirun)
  options+=(-DSCREE_MPI=ON)
  grep -qw 'MPI\|RANKS' "$source_folder/examples/$example/CMakeLists.txt" || fail "'$example' does not run on ranks"
  # Open MPI counts cores, not their threads.
  mpirun="env OMP_NUM_THREADS=1 mpirun -n $(lscpu --parse=Core | grep -v '^#' | sort -u | wc -l)"
  [ "$(id -u)" != 0 ] || mpirun+=" --allow-run-as-root" # it asks for that
else
  options+=(-DSCREE_MPI=OFF) # CMake keeps that of an earlier run
fi
cd "$source_folder"
install_packages
[ "$want_gpu" = no ] || choose_gpu
case $command in
  run) run_example ;;
  example) build_example ;;
  test) run_tests ;;
  docs) build_site ;;
  pack) make_packages ;;
esac
