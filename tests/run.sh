#!/bin/sh
# Builds and runs the tests, on a fresh Debian or Ubuntu too:  sh tests/run.sh [--all|--hosts|--docs]
#
# --all: what must pass before a change goes in. Also the examples' code, lints, each header alone, the fuzz corpus, packs as
# wide as this machine has them, consumers' projects, and the sanitizers of a second compiler.
# --docs: builds the documentation and opens it in a browser, and nothing else.
# --hosts: the adapters of examples/hosts, each inside its host, and nothing else. A host that cannot be had here is skipped, with a word.
set -eu
case ${1:-} in
-h | --help)
  sed -n '1d; /^#/!q; s/^# \{0,1\}//p' "$0"
  exit 0
  ;;
esac
cd "$(dirname "$0")/.."
all=OFF
case ${1:-} in
'') ;;
--all) all=ON ;;
--hosts | --docs) ;;
*)
  echo "tests/run.sh: $1 is none of --all, --hosts and --docs" >&2
  exit 2
  ;;
esac

# shellcheck source=cmake/install_packages.sh
. cmake/install_packages.sh
if [ "${1:-}" = --docs ]; then
  sh docs/build.sh
  (install_packages 'chromium|chromium-browser') || true  # without it the test is skipped, with a word
  python3 tests/docs/check_site.py || [ $? -eq 77 ]
  exit 0
fi
if [ "${1:-}" = --hosts ]; then
  if ! (install_packages lammps liblammps-dev liggghts libliggghts-dev mpi-default-bin mpi-default-dev g++ gfortran python3 \
    libeigen3-dev libxsimd-dev libtomlplusplus-dev nlohmann-json3-dev); then
    echo 'hosts: skipped, their packages cannot be installed here'
    exit 0
  fi
  # Both rows read LAMMPS's headers. Where they cannot be fetched, the tests say so.
  sh examples/hosts/lammps/headers.sh build/hosts/lammps/headers > /dev/null 2>&1 || true
  # Two rows of tests side by side, of equal length; what a test prints is shown when it is done, in one piece.
  results=$(mktemp -d)
  trap 'rm -rf "$results"' EXIT
  # in_turn ROW COMMAND...: 77 says that a test was skipped, and why.
  in_turn() {
    row=$1
    shift
    for test in "$@"; do
      code=0
      $test > "$results/$row" 2>&1 || code=$?
      cat "$results/$row"
      if [ $code -ne 0 ] && [ $code -ne 77 ]; then return $code; fi
    done
  }
  in_turn one 'sh tests/hosts/lammps.sh build/hosts/lammps' 'python3 tests/hosts/liggghts/run.py' &
  one=$!
  failed=0
  library=build/hosts/c/libcontactlaws.so
  in_turn two "sh tests/hosts/library.sh $library" "python3 tests/hosts/c/run.py $library" "python3 tests/hosts/yade/run.py $library" \
    'python3 examples/hosts/report_cards/run.py' || failed=$?
  wait $one || failed=$?
  if [ $failed -ne 0 ]; then exit $failed; fi
  exit 0
fi
install_packages g++ make cmake pkg-config python3 python3-mpmath libeigen3-dev catch2 'libboost1.81-dev|libboost-dev' \
  libxsimd-dev nlohmann-json3-dev
if [ $all = ON ]; then
  install_packages libtomlplusplus-dev libcli11-dev clang libclang-rt-dev 'clang-format-14|clang-format' 'clang-tidy-14|clang-tidy' \
    python3-vtk9
fi

# build FOLDER PRESET COMPILER LABEL: builds the tests and runs those with the label.
build() {
  cmake --preset "$2" -B "$1" -DCMAKE_CXX_COMPILER="$3" -DCONTACTLAWS_BUILD_BENCH=OFF -DCONTACTLAWS_BUILD_EXAMPLES=OFF \
    -DCONTACTLAWS_ALL_TESTS=$all
  cmake --build "$1" -j "$(nproc)"
  ctest --test-dir "$1" -j "$(nproc)" --output-on-failure -L "$4"
}

build build/tests release g++ '.'
if [ $all = ON ]; then build build/tests-sanitize sanitize clang++ programs; fi
