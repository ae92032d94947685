#!/usr/bin/env bash
# Unpacks the built image (target/image, by mvn -Pimage -DskipTests package) in an empty place, takes the right to write away,
# and plays the demo there: without a display, without a JDK on PATH, with an empty environment, in Spanish, and as another
# user if root runs this. Ends with 0 only if all went as it should. Takes about 20 s.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
archive=$(ls "$root"/target/image/simgsm-*.tar.gz)
place=$(mktemp -d)
trap 'chmod -R u+w "$place"; rm -rf "$place"' EXIT
tar -xzf "$archive" -C "$place"
chmod 755 "$place"
chmod -R a-w "$place"
image=$(ls -d "$place"/simgsm-*)

other=()
[ "$(id -u)" = 0 ] && other=(setpriv --reuid=65534 --regid=65534 --clear-groups)
alone() { (cd / && "${other[@]}" env -i PATH=/usr/bin:/bin HOME=/nonexistent LANG=es_ES.UTF-8 "$@"); }

fail() { echo "image: $*" >&2; exit 1; }
if alone sh -c 'command -v javac' >/dev/null; then echo "image: note: this machine has a JDK on PATH; the image does not use it"; fi

release=$(sed -n 's/^JAVA_VERSION="\([0-9]*\).*/\1/p' "$image/runtime/release")
for program in "$image"/bin/*; do
    name=$(basename "$program")
    alone "$program" --help >/dev/null || fail "$name --help"
    alone "$program" --version | grep " ${image##*-}$" >/dev/null || fail "$name --version"
done
alone "$image/bin/simrobot" --print-world --world office.map | grep '^line,' >/dev/null || fail "a world of the image"
output=$(alone "$image/bin/simgsm" --port 0) || fail "the demo ended with $?: $output"
grep -q 'sms-sent' <<<"$output" || fail "the demo's transcript lacks its message: $output"
grep -q 'Todo fue' <<<"$output" || fail "the demo is not in Spanish: $(tail -1 <<<"$output")"
# Each class of the suite comes from an archive or, in an image of Java 25 or newer, from the program's own cache.
for program in simgsm-center simgsm-phone simrobot simgsm-cells; do
    loaded=$(alone JDK_JAVA_OPTIONS=-Xlog:class+load "$image/bin/$program" --version 2>&1)
    ! grep 'sim.*source: jrt:' <<<"$loaded" || fail "$program: classes come from no archive"
    grep -q 'simgsm.console.Program source: shared objects file' <<<"$loaded" || fail "$program: loads no class of the suite"
    if [ "$release" -ge 25 ]; then
        alone JDK_JAVA_OPTIONS="-XX:AOTMode=on" "$image/bin/$program" --version >/dev/null 2>&1 || fail "$program: its cache is not used"
    fi
done
echo "image: $(basename "$image") runs read-only, without a JDK, in Spanish"
