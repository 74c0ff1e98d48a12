#!/bin/sh
# Every option of the whole-body controller, switched alone: case 1 (knee, tip, seed 1) and random pushes of 10 to 35 N
# (seeds 1 to 4), gain sets paper and stiff. Prints the rows of docs/controller-ablation.md.   usage: bench/ablation.sh [DIR]
set -eu
bin=${DOBBENCH:-build/bin/dobbench}
out=${1:-build/ablation}
[ ! -e "$out" ] || { echo "ablation: $out exists; name a new directory" >&2; exit 2; }
mkdir -p "$out"

# run NAME OBSERVER [dobbench options]: one run directory, one table row per gain set.
run() {
  name=$1 specification=$2
  shift 2
  for set in "case1/knee_lateral case1/tip_lateral:1" "case4:4"; do
    # shellcheck disable=SC2086  # a list of scenarios
    "$bin" run ${set%:*} --observer "$specification" --profile matched --gains paper --gains stiff --seeds "${set#*:}" \
      --out "$out/$name/${set#*:}" "$@" >/dev/null
  done
  for gains in paper stiff; do
    { "$bin" table "$out/$name/1" --format json; "$bin" table "$out/$name/4" --format json; } |
      jq -rs --arg name "$name" --arg gains "$gains" 'add |
      def mm: if . == null then "-" else . * 1e4 | round / 10 | tostring end;
      def cell: if .errors > 0 then "error: \(.error_reason)" elif .falls > 0 then "F \(.falls)/\(.runs) at \(.fall_time_median_s * 10 | round / 10) s"
                else "\(.com_error_max_m_worst | mm) / \(.foot_error_max_m_worst | mm) / \(.grf_error_mean_N * 100 | round / 100)" end;
      [.[] | select(.gains == $gains)] | "| \($name) | \($gains) | " + (map(cell) | join(" | ")) + " |"'
  done
}

echo "| option | gains | case 1 knee | case 1 tip | random push |"
echo "|---|---|---|---|---|"
run none none
run legs momentum
run both momentum_com
for observer in momentum momentum_com; do
  case $observer in momentum) who=legs ;; *) who=both ;; esac
  run "$who, (17) off" $observer:routing.wrench_17=false
  case $observer in
    momentum) run "$who, (18) on" $observer:routing.dynamics_18=true ;;
    *) run "$who, (18) off" $observer:routing.dynamics_18=false
       run "$who, CoM estimate ignored" $observer:routing.wrench_source=stance_legs ;;
  esac
  run "$who, wrench of all legs" $observer:routing.wrench_source=all_legs
  run "$who, (36) as printed" $observer:routing.torque_36=false
  run "$who, swing off" $observer:routing.swing_31=off
  run "$who, swing direct" $observer:routing.swing_31=direct
done
run "both, Coriolis terms neglected" momentum_com --set controller.coriolis=neglected
run "both, ZYX angles in (16)" momentum_com --set controller.orientation_error=zyx
run "both, no torque rows" momentum_com --set controller.torque_rows=false
run "both, torque held between solves" momentum_com --set controller.torque_between_solves=held
run "both, acceleration limits 0.025 s" momentum_com --set controller.joint_acceleration_limits=true
run "both, acceleration limits 0.01 s" momentum_com --set controller.joint_acceleration_limits=true --set controller.acceleration_horizon_s=0.01
run "both, mu 0.4" momentum_com --set controller.friction=0.4
run "both, slack weight 1e4" momentum_com --set controller.slack_weight=1e4
run "both, f_min 5 N" momentum_com --set controller.min_normal_force_N=5
run "both, sign of (21)" momentum_com --set controller.printed_sign_21=true
run "legs, planner spline" momentum --planner spline
run "both, planner spline" momentum_com --planner spline
run "legs, planner paper_split" momentum --planner paper_split
run "both, planner paper_split" momentum_com --planner paper_split
