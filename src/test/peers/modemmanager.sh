#!/usr/bin/env bash
# Attaches ModemManager to the AT port 127.0.0.1:PORT, sends ORDER to ROBOT by SMS, and prints what mmcli shows, up to the
# reply. A D-Bus of its own, with polkitd on it; nothing of the machine's own bus is touched.
# Usage: modemmanager.sh PORT ROBOT ORDER
set -u
port=$1 robot=$2 order=$3
folder=$(mktemp -d)
# polkitd runs as a user of its own, who must reach the bus
chmod 755 "$folder"
children=()
finish() {
    for child in "${children[@]}"; do kill "$child" 2>/dev/null; done
    wait 2>/dev/null
    rm -rf "$folder"
}
trap finish EXIT
cd "$folder"

cat > bus.conf <<CONF
<!DOCTYPE busconfig PUBLIC "-//freedesktop//DTD D-Bus Bus Configuration 1.0//EN" "http://www.freedesktop.org/standards/dbus/1.0/busconfig.dtd">
<busconfig>
  <type>system</type>
  <listen>unix:path=$folder/bus</listen>
  <policy context="default">
    <allow user="*"/>
    <allow own="*"/>
    <allow send_type="method_call"/>
    <allow send_type="signal"/>
    <allow send_requested_reply="true"/>
    <allow receive_type="method_call"/>
    <allow receive_type="signal"/>
    <allow receive_requested_reply="true"/>
  </policy>
</busconfig>
CONF
export DBUS_SYSTEM_BUS_ADDRESS=unix:path=$folder/bus

# Waits up to 60 s for a command to succeed.
until_done() {
    for _ in $(seq 300); do
        "$@" >/dev/null 2>&1 && return 0
        sleep 0.2
    done
    echo "not done after 60 s: $*"
    return 1
}

dbus-daemon --config-file=bus.conf --nofork >bus.log 2>&1 & children+=($!)
until_done test -S bus || exit 1
polkitd=$(command -v polkitd || echo /usr/lib/polkit-1/polkitd)
"$polkitd" --no-debug >polkit.log 2>&1 & children+=($!)
socat UNIX-LISTEN:virt,fork TCP:127.0.0.1:"$port" >socat.log 2>&1 & children+=($!)
ModemManager --no-auto-scan --test-enable --test-no-udev --test-no-qrtr --test-no-suspend-resume --debug >mm.log 2>&1 & children+=($!)
until_done dbus-send --system --print-reply --dest=org.freedesktop.ModemManager1 /org/freedesktop/ModemManager1 \
    org.freedesktop.DBus.Peer.Ping || exit 1
dbus-send --system --print-reply --dest=org.freedesktop.ModemManager1 /org/freedesktop/ModemManager1 \
    org.freedesktop.ModemManager1.Test.SetProfile string:virt string:generic array:string:virt >/dev/null || exit 1

until_done mmcli -m any || { tail -40 mm.log; exit 1; }
mmcli -m any -e
registered() { mmcli -m any -K | grep -q '^modem.generic.state *: registered'; }
until_done registered || { tail -40 mm.log; exit 1; }
mmcli -m any -K | grep -E '^modem\.(generic\.(state|own-numbers|signal-quality|manufacturer|model)|3gpp\.(operator|imei|registration))'

sms=$(mmcli -m any --messaging-create-sms="number='$robot',text='$order'" | grep -o '/org[^ ]*SMS/[0-9]*')
mmcli -s "$sms" --send
answered() { mmcli -m any --messaging-list-sms | grep -q received; }
until_done answered || { tail -40 mm.log; exit 1; }
reply=$(mmcli -m any --messaging-list-sms | grep received | grep -o '/org[^ ]*SMS/[0-9]*' | head -1)
mmcli -s "$reply" -K | grep -E '^sms\.content\.(number|text)'

call=$(mmcli -m any --voice-create-call="number=$robot" | grep -o '/org[^ ]*Call/[0-9]*')
mmcli -o "$call" --start
active() { mmcli -o "$call" -K | grep -q '^call.properties.state *: active'; }
until_done active || { tail -40 mm.log; exit 1; }
mmcli -o "$call" --send-dtmf=5
mmcli -o "$call" --hangup
