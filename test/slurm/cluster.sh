# shellcheck shell=bash
# A real Slurm of one node, this machine, with everything in a directory of its own: nothing under /etc is written, no
# service is started. For bash with `set -euo pipefail`; needs root, neither systemd nor cgroups.
#   start_cluster         installs what is missing, starts the daemons, waits for the node; exports SLURM_CONF
#   stop_cluster          cancels what still runs and ends the daemons; for a trap, may be called without start_cluster
#   wait_for SECONDS WHAT COMMAND...     until COMMAND succeeds; ends the script if it does not in time
#   state_of JOB          state and exit code of a job or task, as "FAILED 3:0"

PATH=$PATH:/usr/sbin:/sbin
cluster_dir=""
cluster_daemons=()  # process ids, the last started first

cluster_starts=""

# Exit code 77 with DOB_SLURM=optional where the cluster does not come up: that says nothing about what is tested.
fail() {
  echo "test-slurm: $*" >&2
  [ -z "$cluster_starts" ] || [ "${DOB_SLURM:-}" != optional ] || { echo "SKIPPED: no Slurm here" >&2; exit 77; }
  exit 1
}

wait_for() {
  local limit=$1 what=$2 end=$((SECONDS + $1))
  shift 2
  until "$@"; do
    if ((SECONDS >= end)); then
      [ -z "$cluster_dir" ] || show_cluster >&2
      fail "not within $limit s: $what"
    fi
    sleep 0.2
  done
}

show_cluster() {
  echo "--- jobs and node"
  timeout 20 squeue --array || true
  timeout 20 sinfo --Node --long || true
  for log in munged slurmctld slurmd; do
    echo "--- the end of $log.log"
    tail -n 15 "$cluster_dir/$log.log" || true
  done
}

write_cluster_conf() {
  local node port=$((20000 + $$ % 15000 * 2))
  node=$(hostname -s)
  # linuxproc and task/none: no cgroups. A node without RealMemory has 1 MB, and no job that asks for memory fits.
  cat >"$cluster_dir/slurm.conf" <<END
ClusterName=dobtest
SlurmctldHost=$node(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$cluster_dir/munge/socket
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmctldPidFile=$cluster_dir/slurmctld.pid
SlurmdPidFile=$cluster_dir/slurmd.pid
StateSaveLocation=$cluster_dir/state
SlurmdSpoolDir=$cluster_dir/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SwitchType=switch/none
MpiDefault=none
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
ReturnToService=2
KillWait=10
MinJobAge=3600
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$(awk '/^MemTotal/ { print int($2 / 1200) }' /proc/meminfo)
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
}

# Starts a daemon that stays in the foreground; its output is its log.
daemon() {
  local name=$1
  shift
  "$name" "$@" >"$cluster_dir/$name.log" 2>&1 </dev/null &
  cluster_daemons=("$!" "${cluster_daemons[@]}")
}

node_is_idle() { [ "$(timeout 10 sinfo --noheader --format=%T 2>/dev/null)" = idle ]; }

start_cluster() {
  cluster_starts=yes
  [ "$(id -u)" = 0 ] || fail "needs root"
  [ ! -e /etc/slurm/slurm.conf ] || fail "/etc/slurm/slurm.conf: this machine belongs to a cluster; not touched"
  "$(dirname "${BASH_SOURCE[0]}")/../../.ci/setup" "$(dirname "${BASH_SOURCE[0]}")/../../.ci/packages-slurm" ||
    fail "slurm-wlm or munge cannot be installed"
  # Below /tmp, wherever temporary files else are: munged wants its key private and its socket reachable for everybody.
  cluster_dir=$(mktemp -d /tmp/dob-slurm.XXXXXX)
  mkdir "$cluster_dir"/{munge,state,spool}
  chmod 711 "$cluster_dir" "$cluster_dir/munge"
  (umask 077 && head -c 128 /dev/urandom >"$cluster_dir/munge/key")
  write_cluster_conf
  export SLURM_CONF=$cluster_dir/slurm.conf
  daemon munged --foreground --key-file="$cluster_dir/munge/key" --socket="$cluster_dir/munge/socket" \
    --pid-file="$cluster_dir/munge/pid" --seed-file="$cluster_dir/munge/seed"
  wait_for 30 "munge's socket" test -S "$cluster_dir/munge/socket"
  daemon slurmctld -D
  daemon slurmd -D
  wait_for 60 "an idle node" node_is_idle
  touch "$cluster_dir/started"
  cluster_starts=""
}

no_jobs() { [ -z "$(timeout 10 squeue --noheader 2>/dev/null)" ]; }

stop_cluster() {
  local pid end=$((SECONDS + 30))
  [ -n "$cluster_dir" ] || return 0
  if [ -e "$cluster_dir/started" ]; then
    timeout 20 squeue --noheader --format=%A | sort -u | xargs --no-run-if-empty timeout 20 scancel || true
    until no_jobs || ((SECONDS >= end)); do sleep 0.2; done
  fi
  for pid in "${cluster_daemons[@]}"; do
    kill "$pid" 2>/dev/null || true
    for _ in $(seq 50); do kill -0 "$pid" 2>/dev/null || break; sleep 0.2; done
    kill -KILL "$pid" 2>/dev/null || true
    wait "$pid" 2>/dev/null || true
  done
  rm -rf "$cluster_dir"
  cluster_dir=""
  cluster_daemons=()
}

state_of() {
  timeout 20 scontrol --oneliner show job "$1" |
    sed -n 's/.* JobState=\([A-Z]*\) .* ExitCode=\([0-9:]*\) .*/\1 \2/p'
}
