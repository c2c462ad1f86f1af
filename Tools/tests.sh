# Runs the tests. Sourced by `run`, which brings `root`, `python`, `build`, `choose_display`, `guard`.
# shellcheck shell=bash
# shellcheck disable=SC2154 # root, python: see the head of this file

# Runs a test program, shows its output and keeps a copy.
logged() {
  local log=$1
  shift
  "$@" 2>&1 | tee "$log"
}

# Runs a ctest preset and the tests of the Python package with a mark; $1 names the logs.
run_share() {
  local name=$1 preset=$2 mark=$3 logs="$root/build/dev/Testing" ctest_status=0 pytest_status=0
  shift 3
  guard logged "$logs/ctest$name.log" ctest --preset "$preset" "$@" || ctest_status=$?
  guard logged "$logs/pytest$name.log" "$python" -m pytest Testing/Python -q -m "$mark" ||
    pytest_status=$?
  ((ctest_status == 0 && pytest_status == 0))
}

report_share() {
  local name=$1 logs="$root/build/dev/Testing"
  echo "ctest$name:  $(closing_line "$logs/ctest$name.log" 'tests passed|No tests')"
  echo "pytest$name: $(closing_line "$logs/pytest$name.log" ' in [0-9.]+s')"
}

# All tests but the long ones, under the sanitizers. Those of the Python package run none of our C++.
run_sanitized() {
  local log="$root/build/asan/Testing/ctest.log" status=0
  build asan
  choose_display own
  cd "$root" || return
  mkdir -p "$root/build/asan/Testing"
  guard logged "$log" ctest --preset asan -j2 || status=$?
  echo
  echo "ctest, sanitized: $(closing_line "$log" 'tests passed|No tests')"
  return "$status"
}

# All tests but the long ones; with --long these too, one at a time, after all else.
run_tests() {
  local status=0
  build dev
  choose_display own
  cd "$root" || return
  mkdir -p "$root/build/dev/Testing"
  run_share '' dev 'not long' -j2 || status=1
  [[ $* != --long ]] || run_share '-long' long long || status=1
  echo
  report_share ''
  [[ $* != --long ]] || report_share '-long'
  return "$status"
}

# The last line of a log that matches the pattern, or the last one that is not empty.
closing_line() {
  local log=$1 pattern=$2
  grep -E "$pattern" "$log" | tail -n 1 | grep . || grep . "$log" | tail -n 1
}
