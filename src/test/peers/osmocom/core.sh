#!/usr/bin/env bash
# Starts a real Osmocom core for the towers of a town, runs one command, and stops the core.
#
#   src/test/peers/osmocom/core.sh worlds/village.town 5550100-5550103,5550200 'COMMAND'
#
# The command finds osmo-bsc's RSL port at 127.0.0.1:3003; VTYs: home register 4258, exchange 4254, controller 4242. Where it is
# allowed, everything runs in a network namespace of its own, so no port of the machine is taken. Needs the packages osmo-stp,
# osmo-hlr, osmo-mgw, osmo-msc, osmo-bsc and osmo-bts; gcc too where the kernel has no SCTP. Root is not needed.
# Logs stay in $OSMOCOM_LOGS, if that is set. With $OSMOCOM_SIMS, a file of SIMs as of --sim, those subscribers have its keys, and
# the core authenticates, and ciphers with the algorithms of $OSMOCOM_A5 ("0 1"; default 0, none). Emergency calls go to 5550200.
set -u
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../../.." && pwd)

if [ "${1:-}" != --inside ]; then
    [ $# -eq 3 ] || { echo "usage: core.sh FILE.town NUMBERS COMMAND" >&2; exit 2; }
    for program in osmo-stp osmo-hlr osmo-mgw osmo-msc osmo-bsc osmo-bts-omldummy; do
        command -v "$program" >/dev/null || { echo "core.sh: $program is not installed" >&2; exit 69; }
    done
    for isolation in "unshare -n" "unshare -rn"; do
        if $isolation true 2>/dev/null; then
            exec $isolation -- "$0" --inside "$@"
        fi
    done
    set -- --inside "$@"
fi
town=$2 numbers=$3 command=$4

run=${OSMOCOM_LOGS:-$(mktemp -d)}
mkdir -p "$run"
run=$(cd "$run" && pwd)
ip link set lo up 2>/dev/null || true
ip route add 239.0.0.0/8 dev lo 2>/dev/null || true

preload=
if ! python3 -c 'import socket; socket.socket(socket.AF_INET, socket.SOCK_STREAM, 132)' 2>/dev/null; then
    gcc -shared -fPIC -O2 -o "$run/sctp_over_tcp.so" "$here/sctp_over_tcp.c" -ldl || exit 69
    preload=$run/sctp_over_tcp.so
fi

pids=()
stop() {
    [ ${#pids[@]} -eq 0 ] || kill "${pids[@]}" 2>/dev/null
    wait 2>/dev/null
    [ -n "${OSMOCOM_LOGS:-}" ] || rm -rf "$run"
}
trap stop EXIT
trap 'exit 130' INT TERM

# Runs a program in $run and starts it again 1 s after its end. Its process id is in $run/PROGRAM.pid. An exchange that ended has
# forgotten who is where; osmo-bsc is ended with it, so that all phones register again.
supervise() {
    cd "$run" || exit
    trap 'kill "$child" 2>/dev/null; wait "$child"; exit' TERM
    while :; do
        LD_PRELOAD=$preload "$@" &
        child=$!
        echo "$child" >"$1.pid"
        wait "$child"
        [ "$1" != osmo-msc ] || kill "$(cat osmo-bsc.pid)"
        sleep 1
    done
}

start() {
    supervise "$@" >>"$run/$1.log" 2>&1 &
    pids+=($!)
}

# Waits up to 60 s for a TCP port of loopback.
listens() {
    for _ in $(seq 600); do
        (exec 3<>"/dev/tcp/127.0.0.1/$1") 2>/dev/null && return
        sleep 0.1
    done
    echo "core.sh: nothing listens on port $1; logs in $run" >&2
    exit 1
}

# Sends lines to a VTY and waits for its end.
vty() {
    exec 4<>"/dev/tcp/127.0.0.1/$1"
    { echo enable; cat; echo exit; echo exit; } >&4
    cat <&4 >>"$run/vty.log"
    exec 4>&-
}

java=${JAVA_HOME:+$JAVA_HOME/bin/}java
"$java" -jar "$root/target/dist/simgsm-cells.jar" --town "$town" --print-osmo-bsc >"$run/bsc.cfg" || exit
cp "$here/msc.cfg" "$run/msc.cfg"
if [ -n "${OSMOCOM_SIMS:-}" ]; then
    a5="encryption a5 ${OSMOCOM_A5:-0}"
    sed -i "s/encryption a5 0/$a5/; s/authentication optional/authentication required/" "$run/msc.cfg"
    sed -i "s/encryption a5 0/$a5/" "$run/bsc.cfg"
fi
start osmo-stp -c "$here/stp.cfg"
listens 4239
start osmo-hlr -c "$here/hlr.cfg" -l "$run/hlr.db"
start osmo-mgw -c "$here/mgw.cfg"
listens 4258
listens 4243
start osmo-msc -c "$run/msc.cfg"
listens 4254
start osmo-bsc -c "$run/bsc.cfg"
listens 4242

# The numbers of the open network: IMSI 00101 and the number padded to ten digits.
for range in ${numbers//,/ }; do
    seq "${range%-*}" "${range#*-}"
done | while read -r number; do
    imsi=00101$(printf %010d "$number")
    echo "subscriber imsi $imsi create"
    echo "subscriber imsi $imsi update msisdn $number"
done | vty 4258
if [ -n "${OSMOCOM_SIMS:-}" ]; then
    sed -n -e 's/^sim number=[0-9]* imsi=\([0-9]*\) k=\([0-9a-f]*\) opc=\([0-9a-f]*\).*/subscriber imsi \1 update aud3g milenage k \2 opc \3/p' \
        -e 's/^sim number=[0-9]* imsi=\([0-9]*\) k=\([0-9a-f]*\) algorithm=\([a-z0-9]*\).*/subscriber imsi \1 update aud2g \3 ki \2/p' \
        "$OSMOCOM_SIMS" | vty 4258
fi

# OML, by which the controller starts each base station; it ends with the tower's RSL link and begins anew.
sed -n 's/^  ipa unit-id \([0-9]*\) 0$/\1/p' "$run/bsc.cfg" >"$run/sites"
while read -r site; do
    supervise osmo-bts-omldummy 127.0.0.1 "$site" 1 >"$run/oml-$site.log" 2>&1 &
    pids+=($!)
done <"$run/sites"
listens 3003

# Until controller and exchange have found each other, every registration fails.
connected() { grep -q "BSSMAP assocation is up" "$run/osmo-bsc.log"; }
for _ in $(seq 600); do
    connected && break
    sleep 0.1
done
connected || { echo "core.sh: controller and exchange have not found each other; logs in $run" >&2; exit 1; }

sh -c "$command"
