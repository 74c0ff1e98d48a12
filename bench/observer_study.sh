#!/bin/sh
# Every observer, and every estimator of the legs with every estimator of the CoM: case 1 (knee and tip, lateral, seed 1)
# and case 4 (seeds 1 to 4), profiles matched and tuned. Prints docs/observer-study.md's tables; needs jq.
#   usage: bench/observer_study.sh [DIR] [JOBS]
set -eu
bin=${DOBBENCH:-build/bin/dobbench}
out=${1:-build/observer-study}
jobs=${2:-$(nproc)}
[ ! -e "$out" ] || { echo "observer_study: $out exists; name a new directory" >&2; exit 2; }
mkdir -p "$out"
legs="momentum momentum_exact nonlinear_dob kalman eso sliding_mode direct"
coms="com_wrench com_momentum_exact com_kalman com_eso com_sliding_mode"

set --
for name in none $legs $coms momentum_com contact_consistent oracle_legs oracle_full; do set -- "$@" --observer "$name"; done
for leg in $legs; do
  for com in $coms; do set -- "$@" --observer "legs=$leg,com=$com"; done
done
"$bin" run case1/knee_lateral case1/tip_lateral "$@" --profile matched --profile tuned --jobs "$jobs" --out "$out/case1" >/dev/null
"$bin" run case4 --seeds 4 "$@" --profile matched --profile tuned --jobs "$jobs" --out "$out/case4" >/dev/null
{ "$bin" table "$out/case1" --format json; "$bin" table "$out/case4" --format json; } | jq -s add >"$out/rows.json"

# Worst CoM and foot error [mm] and mean force error [N] over the seeds, or the falls.
jq -r --arg legs "none $legs" --arg coms "none $coms" '
  def mm: if . == null then "-" elif . < 0.01 then . * 1e5 | round / 100 else . * 1e4 | round / 10 end | tostring;
  def place: if .variant == "" then .scenario else "\(.scenario) \(.variant)" end;
  def cell: if .errors > 0 then "error" elif .falls > 0 then "falls \(.falls)/\(.runs)"
            else "\(.com_error_max_m_worst | mm) / \(.foot_error_max_m_worst | mm)" end;
  def force: if .falls > 0 or .grf_error_mean_N == null then "" else " / \(.grf_error_mean_N * 100 | round / 100)" end;
  def name($leg; $com): if $leg == "none" then (if $com == "none" then "none" else $com end)
                        elif $com == "none" then $leg else "legs=\($leg),com=\($com)" end;
  . as $rows | ([$rows[] | place] | reduce .[] as $p ([]; if index([$p]) then . else . + [$p] end)) as $places |
  def find($p; $o; $profile): first($rows[] | select(place == $p and .observer == $o and (.profile == $profile or .profile == "-")));
  ("matched", "tuned") as $profile |
  "## Profile `\($profile)`: all observers", "",
  "CoM max / foot max [mm] / mean force error [N], worst seed; falls k of n.", "",
  "| observer | \($places | join(" | ")) |", "|---|\($places | map("---|") | join(""))",
  ([$rows[] | select(.observer | startswith("legs=") | not) | .observer] | unique_by(.)[] as $o |
   "| `\($o)` | \([$places[] as $p | find($p; $o; $profile) | cell + force] | join(" | ")) |"), "",
  ($places[] as $p | "## Profile `\($profile)`: legs x CoM, \($p)", "",
   "| legs \\ CoM | \($coms | split(" ") | join(" | ")) |", "|---|\($coms | split(" ") | map("---|") | join(""))",
   (($legs | split(" "))[] as $leg | "| \($leg) | \([($coms | split(" "))[] as $com | find($p; name($leg; $com); $profile) | cell] | join(" | ")) |"),
   "")' "$out/rows.json"
