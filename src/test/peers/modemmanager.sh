#!/usr/bin/env bash
# Attaches ModemManager to the AT port 127.0.0.1:PORT, sends ORDER to ROBOT by SMS, and prints what mmcli shows, up to the
# reply; polkitd is on the bus, too.
# Usage: modemmanager.sh PORT ROBOT ORDER
set -u
port=$1 robot=$2 order=$3
. "$(dirname "$0")/own_bus.sh"

polkitd=$(command -v polkitd || echo /usr/lib/polkit-1/polkitd)
"$polkitd" --no-debug >polkit.log 2>&1 & children+=($!)
socat UNIX-LISTEN:virt,fork TCP:127.0.0.1:"$port" >socat.log 2>&1 & children+=($!)
ModemManager --no-auto-scan --test-enable --test-no-udev --test-no-qrtr --test-no-suspend-resume --debug >daemon.log 2>&1 & children+=($!)
until_done dbus-send --system --print-reply --dest=org.freedesktop.ModemManager1 /org/freedesktop/ModemManager1 \
    org.freedesktop.DBus.Peer.Ping
dbus-send --system --print-reply --dest=org.freedesktop.ModemManager1 /org/freedesktop/ModemManager1 \
    org.freedesktop.ModemManager1.Test.SetProfile string:virt string:generic array:string:virt >/dev/null || exit 1

until_done mmcli -m any
mmcli -m any -e
registered() { mmcli -m any -K | grep -q '^modem.generic.state *: registered'; }
until_done registered
mmcli -m any -K | grep -E '^modem\.(generic\.(state|own-numbers|signal-quality|manufacturer|model)|3gpp\.(operator|imei|registration))'

sms=$(mmcli -m any --messaging-create-sms="number='$robot',text='$order'" | grep -o '/org[^ ]*SMS/[0-9]*')
mmcli -s "$sms" --send
answered() { mmcli -m any --messaging-list-sms | grep -q received; }
until_done answered
reply=$(mmcli -m any --messaging-list-sms | grep received | grep -o '/org[^ ]*SMS/[0-9]*' | head -1)
mmcli -s "$reply" -K | grep -E '^sms\.content\.(number|text)'

call=$(mmcli -m any --voice-create-call="number=$robot" | grep -o '/org[^ ]*Call/[0-9]*')
mmcli -o "$call" --start
active() { mmcli -o "$call" -K | grep -q '^call.properties.state *: active'; }
until_done active
mmcli -o "$call" --send-dtmf=5
mmcli -o "$call" --hangup
