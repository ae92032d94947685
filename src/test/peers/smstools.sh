#!/usr/bin/env bash
# Runs smsd of smstools on a terminal device until it has sent ORDER to ROBOT and received the reply, which is printed.
# Usage: smstools.sh DEVICE ROBOT ORDER
set -u
device=$(realpath -s "$1") robot=$2 order=$3
folder=$(mktemp -d)
trap 'kill -- -$daemon 2>/dev/null; wait 2>/dev/null; rm -rf "$folder"' EXIT
mkdir -p "$folder"/{outgoing,checked,incoming,failed,sent,stats}
cat > "$folder/smsd.conf" <<CONF
devices = GSM1
outgoing = $folder/outgoing
checked = $folder/checked
incoming = $folder/incoming
failed = $folder/failed
sent = $folder/sent
stats = $folder/stats
infofile = $folder/running
pidfile = $folder/pid
logfile = $folder/log
loglevel = 7
delaytime = 1
[GSM1]
device = $device
incoming = yes
baudrate = 115200
CONF
set -m
smsd -t -c "$folder/smsd.conf" >"$folder/out" 2>&1 & daemon=$!
set +m
printf 'To: %s\n\n%s' "$robot" "$order" > "$folder/order"
mv "$folder/order" "$folder/outgoing/order"
for _ in $(seq 300); do
    if ls "$folder"/incoming/* "$folder"/sent/* >/dev/null 2>&1; then
        echo "sent: $(ls "$folder/sent")"
        sed 's/^/received: /' "$folder"/incoming/*
        exit 0
    fi
    sleep 0.2
done
cat "$folder/out" "$folder/log"
exit 1
