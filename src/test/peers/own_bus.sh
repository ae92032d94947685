# For the scripts of this folder that talk to a daemon over D-Bus: changes to a new folder with a system bus of its own,
# so that the machine's bus is not touched, and removes the folder at the end with all processes in ${children[@]}.
folder=$(mktemp -d)
# a daemon with a user of its own must reach the bus
chmod 755 "$folder"
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

# Waits up to 60 s for a command to succeed; else shows the end of the daemon's log, daemon.log, and ends the script.
until_done() {
    for _ in $(seq 300); do
        "$@" >/dev/null 2>&1 && return 0
        sleep 0.2
    done
    echo "not done after 60 s: $*"
    tail -60 daemon.log 2>/dev/null
    exit 1
}

dbus-daemon --config-file=bus.conf --nofork >bus.log 2>&1 & children+=($!)
until_done test -S bus
