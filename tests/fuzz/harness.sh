#!/bin/sh
# One harness of run.sh:   harness.sh BUILD NAME PROGRAM INPUTS RUNS_AN_INPUT
set -eu
build=$1 name=$2 program=$3 inputs=$4 each=$5
corpus=$build/corpus/$name
mkdir -p "$corpus" "$build/findings"
log=$build/$name.log
seeds=''
if [ -d "tests/fuzz/corpus/$name" ]; then seeds=tests/fuzz/corpus/$name; fi
case $name in
law_file) seeds="$seeds examples/contact_path/laws" ;;
path_file) seeds="$seeds examples/contact_path/paths" ;;
esac

findings=0 worst=''
# shellcheck disable=SC2086  # a list of folders
if ! "$build/tests/fuzz/$program" "--law=$name" -runs="$inputs" -timeout=10 \
  -artifact_prefix="$build/findings/$name." "$corpus" $seeds >"$log" 2>&1; then
  findings=1
  worst=$(grep -m 1 -E 'violated|runtime error|ERROR:|the message does not' "$log" | tr -d '"\\' | cut -c 1-200)
  echo "$name: $worst; the input: $(ls -t "$build/findings/$name."* | head -n 1)" >&2
fi
count=$(($(grep -oE '^#[0-9]+' "$log" | tail -n 1 | tr -d '#') * each))
if [ $findings -eq 0 ]; then met=true; else met=false; fi
printf '{"item":11,"name":"fuzz.%s","figure":%s,"unit":"findings","target":0,"met":%s,"count":%s,"worst":"%s","reason":"","command":"sh tests/fuzz/run.sh"}\n' \
  "$name" $findings $met "$count" "$worst"
