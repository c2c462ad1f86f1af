# Child processes and the X display. Sourced by `run`, which brings `root` and `die`.
# shellcheck shell=bash

child='' # leads the process group of the command that guard runs
xvfb=''  # our X server
xvfb_folder=''

# Runs a command in a process group of its own, so that cleanup can end all of it.
guard() {
  local status=0
  set -m
  "$@" </dev/null &
  child=$!
  set +m
  wait "$child" || status=$?
  child=''
  return "$status"
}

# Ends a process, or a process group if the number is negative, kindly at first.
end_process() {
  local _
  kill -TERM -- "$1" 2>/dev/null || return 0
  for _ in {1..600}; do # a study still writes its report
    kill -0 -- "$1" 2>/dev/null || return 0
    sleep 0.1
  done
  kill -KILL -- "$1" 2>/dev/null || true
}

cleanup() {
  trap '' HUP INT TERM
  [[ -z $child ]] || end_process "-$child"
  [[ -z $xvfb ]] || end_process "$xvfb"
  [[ -z $xvfb_folder ]] || rm -rf "$xvfb_folder"
  wait 2>/dev/null || true
}

display_has_gl() {
  # shellcheck disable=SC2154 # root: see the head of this file
  timeout 20 "$root/Tools/display-has-gl" 2>/dev/null
}

# $1: own, or auto to prefer the user's display. VOLUMEBENCH_DISPLAY overrides it.
choose_display() {
  local choice=${VOLUMEBENCH_DISPLAY:-auto}
  [[ $choice != auto ]] || choice=$1
  case $choice in
    keep)
      display_has_gl || die "display '${DISPLAY:-}' does not answer, or lacks OpenGL 4.3"
      ;;
    # A display with a host name is forwarded, and its OpenGL too slow to measure.
    auto)
      if [[ ${DISPLAY:-} != :* ]] || ! display_has_gl; then start_xvfb; fi
      ;;
    own) start_xvfb ;;
    *) die "VOLUMEBENCH_DISPLAY is '$choice'; it may be auto, own or keep" ;;
  esac
  echo "X display: $DISPLAY${xvfb:+ (our own Xvfb)}"
}

start_xvfb() {
  local number_file _
  xvfb_folder=$(mktemp -d --tmpdir volumebench-display.XXXXXX)
  number_file="$xvfb_folder/number"
  # In a group of its own Ctrl-C passes it by; without -noreset it dies with its last client.
  set -m
  setpriv --pdeathsig TERM Xvfb -displayfd 3 -noreset -screen 0 1920x1200x24 \
    3>"$number_file" >"$xvfb_folder/log" 2>&1 </dev/null &
  xvfb=$!
  set +m
  for _ in {1..200}; do
    [[ -s $number_file ]] && break
    kill -0 "$xvfb" 2>/dev/null || break
    sleep 0.1
  done
  if [[ ! -s $number_file ]]; then
    cat "$xvfb_folder/log" >&2
    die "Xvfb did not start"
  fi
  DISPLAY=":$(<"$number_file")"
  export DISPLAY
  unset XAUTHORITY WAYLAND_DISPLAY
  display_has_gl || die "Xvfb at $DISPLAY gives no OpenGL 4.3 context"
}
