#!/usr/bin/env bash
# A Slurm cluster of two nodes on this machine's loopback interface, for tests:
#
#   slurm_cluster.sh start FOLDER      writes FOLDER/slurm.conf, starts all, waits for both nodes
#   slurm_cluster.sh lose FOLDER NODE  kills a node with all that runs on it
#   slurm_cluster.sh stop FOLDER
#
# Takes root, and Debian's slurm-wlm and munge. Everything lies in FOLDER.
set -euo pipefail

configure() {
  # Three ports each: tests that begin at the same moment have numbers of processes side by side.
  local port=$((20000 + $$ % 6000 * 3))
  mkdir -p "$folder"/{state,spool-n1,spool-n2,log,run}
  chmod 755 "$folder" "$folder/run"
  head -c 1024 /dev/urandom >"$folder/munge.key"
  chmod 400 "$folder/munge.key"
  # Short waits, so that a node that is lost is noticed in seconds. The credential of a task
  # must expire quickly too, or its second run waits for minutes.
  cat >"$folder/slurm.conf" <<EOF
ClusterName=test
SlurmctldHost=localhost
SlurmctldPort=$port
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/run/munge.socket,cred_expire=10
CredType=cred/munge
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool-%n
SlurmctldPidFile=$folder/run/slurmctld.pid
SlurmdPidFile=$folder/run/slurmd-%n.pid
SlurmctldLogFile=$folder/log/slurmctld.log
SlurmdLogFile=$folder/log/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
SchedulerType=sched/backfill
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
SlurmdTimeout=6
SlurmctldTimeout=10
InactiveLimit=0
KillWait=2
CompleteWait=0
MinJobAge=30
SchedulerParameters=sched_interval=1,batch_sched_delay=0,bf_interval=1
JobRequeue=1
MaxJobCount=5000
SlurmdParameters=config_overrides
NodeName=n1 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1 RealMemory=4000
NodeName=n2 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1 RealMemory=4000
PartitionName=main Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
EOF
}

# within SECONDS COMMAND: waits until the command succeeds.
within() {
  local end=$((SECONDS + $1))
  shift
  until "$@" >/dev/null 2>&1; do
    [ "$SECONDS" -lt "$end" ] || { echo "not in time: $*" >&2 && return 1; }
    sleep 0.05
  done
}

both_idle() { [ "$(sinfo -h -N -o %T | sort -u)" = idle ]; }
is_dead() { ! kill -0 "$1"; }

start() {
  configure
  munged --key-file="$folder/munge.key" --socket="$folder/run/munge.socket" \
    --pid-file="$folder/run/munged.pid" --log-file="$folder/log/munged.log" \
    --seed-file="$folder/run/munged.seed"
  within 10 munge -n -S "$folder/run/munge.socket"
  slurmctld -c -f "$SLURM_CONF"
  within 20 scontrol ping
  slurmd -N n1 -f "$SLURM_CONF"
  slurmd -N n2 -f "$SLURM_CONF"
  within 30 both_idle
}

# A process and those below it.
tree_of() {
  local child
  echo "$1"
  for child in $(pgrep -P "$1" || true); do tree_of "$child"; done
}

runs_on() {
  tr '\0' '\n' 2>/dev/null <"/proc/$1/environ" | grep -qx "SLURMD_NODENAME=$2"
}

# The node's daemon; and of the daemons of steps, which tell no node, those whose tasks do.
lose() {
  local node=$1 daemon task
  kill -9 "$(cat "$folder/run/slurmd-$node.pid")"
  for daemon in $(pgrep -x slurmstepd || true); do
    for task in $(tree_of "$daemon"); do
      if runs_on "$task" "$node"; then
        # shellcheck disable=SC2046  # a list of numbers
        kill -9 $(tree_of "$daemon") 2>/dev/null || true
        break
      fi
    done
  done
}

stop() {
  local name pid
  timeout 5 scancel --user=root 2>/dev/null || true
  for name in slurmd-n1 slurmd-n2 slurmctld munged; do
    pid=$(cat "$folder/run/$name.pid" 2>/dev/null) || continue
    kill "$pid" 2>/dev/null || continue
    within 5 is_dead "$pid" || kill -9 "$pid"
  done
}

action=$1
folder=$2
shift 2
export SLURM_CONF=$folder/slurm.conf
"$action" "$@"
