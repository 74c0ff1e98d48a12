#!/bin/sh
# The order study (docs/order-study.md): momentum observers of order 1 to 5 with equal K_i and at equal -3 dB bandwidth,
# on the ideal plant (analyse) and on the standing and trotting robot.   usage: bench/order_study.sh OUT_DIR [JOBS]
set -eu
dobbench=$(dirname "$0")/../build/bin/dobbench
out=$1
jobs=${2:-2}
set --
for r in 1 2 3 4 5; do
  K=$(printf '6.28;%.0s' $(seq "$r"))
  set -- "$@" "momentum:gains=${K%;},allow_unstable=true"
done
for width in 6.283 72.26; do  # rad/s: 1 Hz, and 11.5 Hz as in the profile `matched`
  set -- "$@" "momentum:family=bessel,order=1,bandwidth_rad_s=$width"  # of order 1 all families are one
  for family in bessel butterworth binomial; do
    for r in 2 3 4 5; do set -- "$@" "momentum:family=$family,order=$r,bandwidth_rad_s=$width"; done
  done
done
"$dobbench" analyse "$@" --profile paper
for specification; do
  shift
  set -- "$@" --observer "$specification"
done
"$dobbench" run order_study "$@" --observer none --profile paper --jobs "$jobs" --out "$out"
