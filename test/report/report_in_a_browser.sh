#!/bin/sh
# Makes a report page of a real, small batch and tests it in chromium. Exit code 77: what it needs is not there, and it
# need not be (DOB_REPORT_BROWSER=required: exit code 1 then; =later: skipped, as it is run on its own). Where there is a
# browser, npm fetches what drives it.
#   usage: test/report/report_in_a_browser.sh DOBBENCH WORK [SHOTS]     SHOTS: for screenshots (default WORK/shots)
set -eu
here=$(cd "$(dirname "$0")" && pwd)
report=$here/../../results/report

missing() {
  echo "SKIPPED: $1"
  [ "${DOB_REPORT_BROWSER:-}" = required ] && exit 1
  exit 77
}
[ "${DOB_REPORT_BROWSER:-}" != later ] || missing "run on its own, later"
command -v node >/dev/null 2>&1 || missing "no node (Debian: nodejs)"
for name in chromium chromium-browser google-chrome; do
  DOB_CHROMIUM=${DOB_CHROMIUM:-$(command -v $name || true)}
done
[ -x "$DOB_CHROMIUM" ] || missing "no chromium (Debian: chromium)"
if [ ! -d "$report/node_modules/playwright-core" ]; then
  command -v npm >/dev/null 2>&1 || missing "no npm (Debian: npm)"
  npm ci --prefix "$report" --no-audit --no-fund >/dev/null 2>&1 || missing "npm ci --prefix results/report fails"
fi

DOB_PROGRAM=$(realpath "$1")
mkdir -p "$2" "${3:-$2/shots}"
DOB_WORK=$(realpath "$2")
DOB_SHOTS=$(realpath "${3:-$2/shots}")
export DOB_CHROMIUM DOB_PROGRAM DOB_WORK DOB_SHOTS
exec node "$here/report_test.mjs"
