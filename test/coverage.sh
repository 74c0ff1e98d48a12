#!/bin/sh
# Lines of the rooms that the tests reach; exit code 1 when a room has less than 90 %.   usage: test/coverage.sh [JOBS]
# What a worker process of a batch runs is not counted (it ends without writing its counters): the true figure is higher.
# Tests that limit the size of files are left out: counters are files, too.
set -eu
cd "$(dirname "$0")/.."
jobs=${1:-2}
build=build/coverage
cmake --preset coverage >/dev/null
cmake --build --preset coverage -j "$jobs"
find $build -name '*.gcda' -delete
ctest --preset coverage -j "$jobs" -E 'report_in_a_browser|WithoutRoom' --output-on-failure --quiet
enough=0
for room in robot observers controller results; do
  gcovr --root . --object-directory $build --filter "$room/" --gcov-ignore-parse-errors -j "$jobs" \
    --fail-under-line 90 --txt $build/$room.txt --print-summary $build/$room >$build/summary.txt 2>/dev/null || enough=1
  printf '%-12s %s\n' "$room" "$(grep '^lines' $build/summary.txt)"
done
exit $enough
