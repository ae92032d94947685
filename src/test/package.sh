#!/usr/bin/env bash
# Installs the built Debian package (target/image, by mvn -Pimage -DskipTests package) into an empty root, starts its demo
# from there with windows on a display of its own, compares each window's class with its menu entry, checks menu entries and
# software centre's page by the desktops' own tools, and removes the package again. Needs dpkg, Xvfb, openbox and xprop; a
# plain user runs it in a user namespace (unshare). What else is missing is named and skipped. Takes about 20 s.
set -euo pipefail
if [ "$(id -u)" != 0 ]; then exec unshare --map-root-user "$0" "$@"; fi
root=$(cd "$(dirname "$0")/../.." && pwd)
package=$(ls "$root"/target/image/simgsm_*.deb)
place=$(mktemp -d)
demo= cells= server= manager= watch=
finish() {
    for process in $demo $cells $watch $manager $server; do kill "$process" 2>/dev/null || true; done
    wait
    rm -rf "$place" "$place.log"
}
trap finish EXIT
fail() { echo "package: $*" >&2; exit 1; }
have() { command -v "$1" >/dev/null 2>&1 || { echo "package: $1 is not there: skipped"; return 1; }; }

installer() { dpkg --root="$place" --log=/dev/null --force-not-root --force-depends "$@" >"$place.log" 2>&1 || fail "$* failed: $(cat "$place.log")"; }
mkdir -p "$place"/var/lib/dpkg/{info,updates,triggers}
touch "$place/var/lib/dpkg/status"
installer --install "$package"
for needed in $(dpkg-deb -f "$package" Depends | tr -d ','); do
    dpkg -s "$needed" >/dev/null 2>&1 || fail "it depends on $needed, which is not a package of this system"
done

for entry in "$place"/usr/share/applications/*.desktop; do
    command=$(sed -n 's/^Exec=//p' "$entry")
    [ -x "$place/usr/bin/$command" ] || fail "$entry starts $command, which is not there"
    [ -f "$place/usr/share/icons/hicolor/48x48/apps/$(sed -n 's/^Icon=//p' "$entry").png" ] || fail "$entry has no icon"
done
if have desktop-file-validate; then desktop-file-validate "$place"/usr/share/applications/*.desktop || fail "menu entries"; fi
if have appstreamcli; then appstreamcli validate --no-net "$place"/usr/share/metainfo/*.xml >/dev/null || fail "software centre's page"; fi

exec 3< <(exec Xvfb -displayfd 1 -screen 0 1920x1080x24 -noreset 2>/dev/null)
server=$!
read -r -t 30 number <&3 || fail "no virtual display came up"
export DISPLAY=":$number"
openbox >/dev/null 2>&1 &
manager=$!
until xprop -root _NET_CLIENT_LIST 2>/dev/null | grep -q WINDOW; do kill -0 "$manager" || fail "openbox has ended"; done
exec 4< <(exec xprop -spy -root _NET_CLIENT_LIST 2>/dev/null)
watch=$!
HOME="$place" "$place/usr/bin/simgsm" --fresh --port 0 --no-sound >"$place.log" 2>&1 &
demo=$!
HOME="$place" "$place/usr/bin/simgsm-cells" --town village.town --fresh --port 0 --center 127.0.0.1:9 >/dev/null 2>&1 &
cells=$!
windows=
while [ "$(wc -w <<<"$windows")" -lt 4 ]; do
    read -r -t 60 line <&4 || fail "four windows did not come up: $(cat "$place.log")"
    windows=$(grep -o '0x[0-9a-f]*' <<<"$line" || true)
done
seen=$(for window in $windows; do xprop -id "$window" WM_CLASS | sed 's/.*, "\(.*\)"/\1/'; done | sort)
said=$(sed -n 's/^StartupWMClass=//p' "$place"/usr/share/applications/*.desktop | sort)
[ "$seen" = "$said" ] || fail "windows of the classes
$seen
but menu entries of
$said"
kill "$demo" "$cells"
wait "$demo" "$cells" 2>/dev/null || true
demo= cells=
installer --remove simgsm
left=$(find "$place" -path "*/var/lib/dpkg" -prune -o -type f -path "*/usr/*" -print | head -5)
[ -z "$left" ] || fail "removed, but there is still $left"
echo "package: $(basename "$package") installs, starts, is grouped by its menu entries, and is removed"
