#!/usr/bin/env bash
# Attaches oFono to the AT port 127.0.0.1:PORT by its driver for phone simulators, sends ORDER to ROBOT by SMS, asks for
# its own number, and prints what oFono tells. A D-Bus of its own; nothing of the machine's own bus is touched.
# Usage: ofono.sh PORT ROBOT ORDER
set -u
port=$1 robot=$2 order=$3
folder=$(mktemp -d)
children=()
finish() {
    for child in "${children[@]}"; do kill "$child" 2>/dev/null; done
    wait 2>/dev/null
    rm -rf "$folder"
}
trap finish EXIT
cd "$folder" || exit 1

cat > bus.conf <<CONF
<!DOCTYPE busconfig PUBLIC "-//freedesktop//DTD D-Bus Bus Configuration 1.0//EN" "http://www.freedesktop.org/standards/dbus/1.0/busconfig.dtd">
<busconfig>
  <type>system</type>
  <listen>unix:path=$folder/bus</listen>
  <policy context="default">
    <allow own="*"/>
    <allow send_destination="*"/>
    <allow receive_sender="*"/>
  </policy>
</busconfig>
CONF
printf '[phonesim]\nAddress=127.0.0.1\nPort=%s\n' "$port" > phonesim.conf
export DBUS_SYSTEM_BUS_ADDRESS=unix:path=$folder/bus OFONO_PHONESIM_CONFIG=$folder/phonesim.conf OFONO_AT_DEBUG=1

# Waits up to 60 s for a command to succeed.
until_done() {
    for _ in $(seq 300); do
        "$@" >/dev/null 2>&1 && return 0
        sleep 0.2
    done
    echo "not done after 60 s: $*"
    tail -60 ofono.log
    exit 1
}
ofono() { dbus-send --system --print-reply --dest=org.ofono /phonesim "org.ofono.$@"; }

dbus-daemon --config-file=bus.conf --nofork >bus.log 2>&1 & children+=($!)
until_done test -S bus
ofonod -n -d >ofono.log 2>&1 & children+=($!)
dbus-monitor --system "type='signal',interface='org.ofono.MessageManager',member='IncomingMessage'" >incoming & children+=($!)
until_done ofono Modem.SetProperty string:Powered variant:boolean:true
until_done ofono Modem.SetProperty string:Online variant:boolean:true
registered() { ofono NetworkRegistration.GetProperties > network && grep -q '"registered"' network; }
until_done registered
grep -o '"SimGSM"' network
until_done ofono MessageManager.SetProperty string:UseDeliveryReports variant:boolean:true
ofono MessageManager.SendMessage string:"$robot" string:"$order" | grep -o '/phonesim/message'
until_done grep -q '"3 ' incoming
grep -o '"3 .*"' incoming
ofono SupplementaryServices.Initiate string:'*100#' | grep -o '"[0-9]*"'
