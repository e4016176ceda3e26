#!/bin/sh
# Builds the examples and runs them, on a fresh Debian or Ubuntu too:  sh examples/run.sh [--full]
#
# --full: the specimens of both documents at their sizes, compiled for this machine's processor. That takes hours; Ctrl-C stops
# it, the same command goes on.
set -eu
case ${1:-} in
-h | --help)
  sed -n '1d; /^#/!q; s/^# \{0,1\}//p' "$0"
  exit 0
  ;;
esac
cd "$(dirname "$0")/.."
full= native=OFF
case ${1:-} in
'') ;;
--full) full=--full native=ON ;;
*)
  echo "examples/run.sh: $1 is not --full" >&2
  exit 2
  ;;
esac

# shellcheck source=cmake/install_packages.sh
. cmake/install_packages.sh
install_packages g++ make cmake libeigen3-dev libxsimd-dev nlohmann-json3-dev 'libboost1.81-dev|libboost-dev' libtomlplusplus-dev \
  libcli11-dev python3-matplotlib

cmake --preset release -B build/examples -DCONTACTLAWS_BUILD_TESTS=OFF -DCONTACTLAWS_BUILD_BENCH=OFF \
  -DCONTACTLAWS_NATIVE=$native
cmake --build build/examples -j "$(nproc)" --target first_contact verify_your_law drop memo contact_curves class5 probe bridge_curves \
  contact_path

build/examples/bin/first_contact
build/examples/bin/verify_your_law build/results/verify_your_law
build/examples/bin/drop build/results/drop
wrong=0
build/examples/bin/memo build/results || wrong=$?
build/examples/bin/contact_curves build/results || wrong=$?
# shellcheck disable=SC2086  # no word, where $full is empty
build/examples/bin/class5 build/results $full || wrong=$?
if [ $wrong -gt 1 ]; then exit $wrong; fi  # a fault, or stopped
# shellcheck disable=SC2086
build/examples/bin/probe build/results $full || wrong=$?
if [ $wrong -gt 1 ]; then exit $wrong; fi
build/examples/bin/bridge_curves build/results

# The first Python that has matplotlib: Debian's package serves /usr/bin/python3, which need not be the first on the path.
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import matplotlib' 2>/dev/null; then break; fi
done
"$python" examples/drop_figures.py build/results
"$python" examples/memo/figures.py build/results
"$python" examples/memo/class5/figures.py build/results
"$python" examples/ballast/figures.py build/results
"$python" examples/ballast/probe/figures.py build/results
"$python" examples/capillary/figures.py build/results

example=examples/contact_path
mkdir -p build/results/contact_path
for name in memo_hill:stage_b ballast:ballast_cycles oblique_impact:oblique_impact rotating_pair:rotating_pair; do
  path=$example/paths/${name#*:}.csv
  out=build/results/contact_path/${name%:*}.csv
  build/examples/bin/contact_path "$example/laws/${name%:*}.toml" "$path" -o "$out"
  "$python" $example/plot_path.py "$out" --path "$path"
done
exit $wrong
