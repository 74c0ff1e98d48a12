#!/usr/bin/env bash
# How far results lie apart when the same program is built otherwise, or the C library chooses other functions; the table
# of docs/repeatability.md. Builds what is missing below OUT (each variant takes minutes), runs a sample of trials with
# build/bin/dobbench and has every variant verify it.
#   bench/repeatability.sh OUT JOBS [VARIANT...|none]      no VARIANT: all of them; none: only what needs no other build
# The sample: 16 trials, four scenarios, two observers, two seeds; of 5 s, and as long as they are.
set -euo pipefail
out=$1
jobs=$2
shift 2
reference=build/bin/dobbench
sample=(case1/tip_lateral case3/left_10 case5/plus_30 undisturbed --observer momentum --observer momentum_com --profile tuned
        --seeds 2 --keep none --jobs "$jobs")

# VARIANT: compiler | flags behind those of CMake | further options
declare -A variants=(
  [gxx-O2]="g++|-O2 -DNDEBUG|"
  [gxx-O1]="g++|-O1 -DNDEBUG|"
  [clang-O2]="clang++|-O2 -DNDEBUG|"
  [clang-O3]="clang++|-O3 -DNDEBUG|"
  [fast]="g++|-O3 -DNDEBUG|-DDOB_FAST_MODEL=ON"
  [native]="g++|-O3 -DNDEBUG -march=native|"
)
order="gxx-O2 gxx-O1 clang-O2 clang-O3 fast native"
wanted=${*:-$order}
[ "$wanted" != none ] || wanted=""
for variant in $wanted; do
  [ -n "${variants[$variant]:-}" ] || { echo "repeatability: no variant '$variant'; there are: $order, none" >&2; exit 2; }
done

build() {  # build VARIANT: the program alone
  IFS='|' read -r compiler flags options <<<"${variants[$1]}"
  # shellcheck disable=SC2086  # options are a list of words
  cmake -S . -B "$out/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" \
    -DCMAKE_CXX_FLAGS_RELEASE="$flags" -DDOB_UNITY=ON -DDOB_TESTS=OFF $options >/dev/null
  cmake --build "$out/$1" -j "$jobs" --target dobbench >"$out/$1.log" || { tail -20 "$out/$1.log" >&2; exit 1; }
}

# row NAME RUN PROGRAM: a line of the table; exit code 1 of verify is a result like any other.
row() {
  local answer code=0
  answer=$("$3" verify "$2" --sample 0 --jobs "$jobs" --across --format md 2>"$out/verify.err") || code=$?
  [ $code -le 1 ] || { cat "$out/verify.err" - <<<"$answer" >&2; exit $code; }
  awk -F ' *\\| *' -v name="$1" '
    function shown(largest, where) { return largest == "" ? "0" : largest " (" where ")" }
    $2 == "equal" { equal = $3 }
    $2 == "different" { different = $3 }
    $2 == "outcome flipped" { flipped = $3 }
    $4 ~ /^[0-9]+$/ && $5 ~ /^[0-9.e+-]+$/ {
      gsub(/\\/, "", $2)
      if ($5 + 0 > survived + 0) { survived = $5; of_survived = $2 }
      if ($6 + 0 > fell + 0) { fell = $6; of_fell = $2 }
      if ($2 == "com_error_max_m") com = $5
    }
    END { printf "| %s | %d/%d | %d | %s | %s | %s |\n", name, equal, equal + different + flipped, flipped,
                 com == "" ? "0" : com, shown(survived, of_survived), shown(fell, of_fell) }' <<<"$answer"
}

mkdir -p "$out"
[ -d "$out/short" ] || "$reference" run "${sample[@]}" --set duration_s=5 --out "$out/short" >/dev/null
[ -d "$out/whole" ] || "$reference" run "${sample[@]}" --out "$out/whole" >/dev/null
for variant in $wanted; do build "$variant"; done

for run in short whole; do
  printf '\n%s, against %s\n\n' "$run" "$("$reference" --version)"
  echo '| program | equal | outcomes flipped | CoM error, survived | largest of any metric, survived | largest, fell |'
  echo '| --- | ---: | ---: | ---: | --- | --- |'
  row "the same" "$out/$run" "$reference"
  GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA row "the same, C library without AVX2 and FMA" "$out/$run" "$reference"
  for variant in $wanted; do
    IFS='|' read -r compiler flags options <<<"${variants[$variant]}"
    row "$compiler ${flags/ -DNDEBUG/}${options:+ $options}" "$out/$run" "$out/$variant/bin/dobbench"
  done
done
