# shellcheck shell=sh
# Sourced by the run.sh scripts.
#
#   install_packages NAME...    installs those Debian packages that are missing; "a|b" means a, or b where a is not offered.
#
# Without apt, or without the right to use it, it prints what is missing and stops.

is_installed() {
  dpkg-query -W -f='${db:Status-Abbrev}\n' "$1" 2>/dev/null | grep -q '^ii'
}

run_as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

# Quiet unless it fails.
run_apt() {
  if ! apt_log=$(run_as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq "$@" 2>&1); then
    echo "$apt_log" >&2
    echo "apt-get $* failed" >&2
    exit 1
  fi
}

install_packages() {
  missing=
  for names in "$@"; do
    found=no
    for name in $(echo "$names" | tr '|' ' '); do
      if is_installed "$name"; then found=yes; fi
    done
    if [ $found = no ]; then missing="$missing $names"; fi
  done
  if [ -z "$missing" ]; then return; fi

  if ! command -v apt-get >/dev/null || { [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; }; then
    echo "Please install these packages (Debian names) and start again:$missing" >&2
    exit 1
  fi
  echo "Installing$missing"
  run_apt update
  offered=
  for names in $missing; do
    for name in $(echo "$names" | tr '|' ' '); do
      if apt-get -qq --simulate install "$name" >/dev/null 2>&1; then break; fi
    done
    offered="$offered $name"
  done
  # shellcheck disable=SC2086  # a list of names
  run_apt install -y --no-install-recommends $offered
}
