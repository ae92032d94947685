#!/usr/bin/env bash
# Attaches oFono to the AT port 127.0.0.1:PORT by its driver for phone simulators, sends ORDER to ROBOT by SMS, asks for
# its own number, and prints what oFono tells.
# Usage: ofono.sh PORT ROBOT ORDER
set -u
port=$1 robot=$2 order=$3
. "$(dirname "$0")/own_bus.sh"

printf '[phonesim]\nAddress=127.0.0.1\nPort=%s\n' "$port" > phonesim.conf
export OFONO_PHONESIM_CONFIG=$folder/phonesim.conf OFONO_AT_DEBUG=1

ofono() { dbus-send --system --print-reply --dest=org.ofono /phonesim "org.ofono.$@"; }

ofonod -n -d >daemon.log 2>&1 & children+=($!)
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
