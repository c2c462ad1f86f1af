# Installs missing Debian packages. Sourced by `run`, which brings `root` and `die`.
# shellcheck shell=bash

# Prints the packages in Tools/packages-NAME.txt, one a line.
packages_in() {
  # shellcheck disable=SC2154 # root: see the head of this file
  sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$root/Tools/packages-$1.txt"
}

# Prints those of the given packages that are not installed.
not_installed() {
  local package
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
      echo "$package"
  done
}

as_root() {
  if ((EUID == 0)); then
    "$@"
  else
    sudo "$@"
  fi
}

require_root_for() {
  ((EUID == 0)) && return
  command -v sudo >/dev/null ||
    die "installing needs root or sudo; ask for: apt-get install --no-install-recommends $*"
  sudo -n true 2>/dev/null || [[ -t 0 ]] ||
    die "sudo asks for a password, and there is no terminal; run './run deps test' in one first"
}

apt_get() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-remove -o DPkg::Lock::Timeout=600 "$@"
}

# Installs what is missing from the lists Tools/packages-NAME.txt of the given names.
install_missing() {
  local list packages=() missing log
  [[ -x /usr/bin/dpkg-query && -x /usr/bin/apt-get ]] ||
    die "this is not Debian; install what Tools/packages-*.txt names, then use cmake --preset"
  for list in "$@"; do
    mapfile -t -O "${#packages[@]}" packages < <(packages_in "$list")
  done
  mapfile -t missing < <(not_installed "${packages[@]}")
  if ((${#missing[@]} == 0)); then
    echo "Debian packages: nothing is missing"
    return
  fi
  require_root_for "${missing[@]}"
  log=$(mktemp --tmpdir volumebench-apt.XXXXXX)
  echo "Debian packages to install: ${missing[*]}"
  echo "This may take minutes; apt-get writes to $log"
  apt_get update >"$log" 2>&1 || echo "run: apt-get update failed; using the lists at hand" >&2
  if ! apt_get install --no-install-recommends "${missing[@]}" >>"$log" 2>&1; then
    tail -n 20 "$log" >&2
    die "apt-get could not install: ${missing[*]} (Debian 12 is expected; all of it is in $log)"
  fi
  rm -f "$log"
}
