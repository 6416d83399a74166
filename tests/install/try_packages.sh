#!/bin/sh
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#
# Tries a package on a system without a compiler, as root: sh try_packages.sh FILE.deb|FILE.tar.xz. Installs it, writes the preview of
# every bundled case, runs column_collapse and draws it. All of it but the installation takes less than 60 s. Python's modules
# for drawing come last, because those of Debian 12 bring a compiler.
set -eu

package=$(readlink -f "$1")
results=$(mktemp -d)
refuse_compilers() {
  if command -v c++ || command -v cc; then
    echo "there is a compiler here, so this would show nothing" >&2
    exit 1
  fi
}
refuse_compilers
apt-get -q update
export DEBIAN_FRONTEND=noninteractive
case $package in
  *.deb)
    apt-get -q -y install --no-install-recommends "$package" python3
    scree=scree
    cases=/usr/share/scree
    ;;
  *)
    apt-get -q -y install --no-install-recommends xz-utils python3
    mkdir "$results/unpacked"
    tar --extract --file "$package" --directory "$results/unpacked"
    scree=$(echo "$results"/unpacked/*/bin/scree)
    cases=$(echo "$results"/unpacked/*/share/scree)
    ;;
esac

refuse_compilers
begin=$(date +%s)
cd "$results"
python3 "$cases/blender/vessel.py" v v_blender.stl # what two of the cases read
python3 "$cases/terrain/ground.py" .
applications=0
for folder in "$cases"/*/; do
  application=$(basename "$folder")
  [ "$application" != view ] || continue
  applications=$((applications + 1))
  "$scree" "$application" --version
  for case in "$folder"*.toml; do
    "$scree" "$application" "$case" --preview --quiet --output "$results/$(basename "$case" .toml)"
    test -s "$results/$(basename "$case" .toml)/preview.html"
  done
done
[ "$applications" = 8 ] || { echo "$applications applications instead of 8" >&2; exit 1; }

"$scree" column_collapse "$cases/column_collapse/column_collapse.toml" --output "$results/column"
seconds=$(($(date +%s) - begin))

refuse_compilers
apt-get -q -y install --no-install-recommends python3-h5py python3-matplotlib
begin=$(date +%s)
"$scree" view "$results/column" --field velocity --picture "$results/column/velocity.png" --page "$results/column/run.html"
PYTHONDONTWRITEBYTECODE=1 python3 "$cases/column_collapse/plot.py" "$results/column"
for file in particles.vtkhdf velocity.png collapse.png run.html; do test -s "$results/column/$file"; done
seconds=$((seconds + $(date +%s) - begin))
echo "$(basename "$package"): $applications applications previewed, a column run and drawn in $seconds s"
[ "$seconds" -lt 60 ]
