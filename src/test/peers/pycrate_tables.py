"""Compares tables of layer 3 messages with those of pycrate.

The file named by the argument has a line per element: discriminator, message type, direction, IEI, name, type and clause, presence,
format, length; after "message", discriminator, type and direction alone. Prints a line per difference, then the number of messages."""
import re
import sys

from pycrate_mobile.TS24007 import Type1V, Type2, Type3TV, Type3V, Type4LV, Type4TLV
from pycrate_mobile.TS24008_CC import CCTypeMOClasses, CCTypeMTClasses
from pycrate_mobile.TS24008_MM import MMTypeClasses
from pycrate_mobile.TS24080_SS import SSTypeMOClasses, SSTypeMTClasses
from pycrate_mobile.TS44018_RR import RRTypeMOClasses, RRTypeMTClasses

CLASSES = {
    ("3", "UPLINK"): CCTypeMOClasses, ("3", "DOWNLINK"): CCTypeMTClasses,
    ("5", "UPLINK"): MMTypeClasses, ("5", "DOWNLINK"): MMTypeClasses,
    ("6", "UPLINK"): RRTypeMOClasses, ("6", "DOWNLINK"): RRTypeMTClasses,
    ("11", "UPLINK"): SSTypeMOClasses, ("11", "DOWNLINK"): SSTypeMTClasses,
}
# Names that pycrate has of its own.
NAMES = {"AUTS": "Authentication failure parameter", "NetFullName": "Full name for network"}
FORMATS = {Type1V: "V", Type2: "T", Type3V: "V", Type3TV: "TV", Type4LV: "LV", Type4TLV: "TLV"}


def rows_of(message):
    """IEI, format, length or None, and the names of element and type."""
    for element in message()._content:
        kind = FORMATS.get(type(element))
        if kind is None:
            continue
        iei = "%02X" % element["T"].get_val() if kind.startswith("T") else ""
        if type(element) is Type1V:
            length = "1/2"
        elif kind in ("V", "TV"):
            length = str(element._V.get_bl() // 8 + len(kind) - 1)
        else:
            length = None
        value_type = getattr(element, "_IE_stat", None)
        yield iei, kind, length, [element._name] + ([value_type._name] if value_type is not None else [])


def abbreviates(short, long):
    """Whether the letters of the abbreviation follow one another in the name."""
    letters = iter(re.sub("[^a-z0-9]", "", long.lower()))
    return all(letter in letters for letter in re.sub("[^a-z0-9]", "", short.lower()))


def differences(key, ours):
    theirs = list(rows_of(CLASSES[key[0], key[2]][int(key[1])]))
    imperative = [row for row in ours if not row[0] and row[1] != "Spare half octet"]
    expected = [row for row in theirs if not row[0]]
    pairs = list(zip(imperative, expected))
    if len(imperative) != len(expected):
        yield "%d elements without IEI, pycrate has %d" % (len(imperative), len(expected))
    for row in ours:
        if row[0]:
            same = [other for other in theirs if other[0] == row[0]]
            if same:
                pairs.append((row, same[0]))
            else:
                yield "pycrate has no element " + row[0]
        elif row[3] != "M":
            yield row[1] + " is not mandatory"
    for (iei, name, value_type, presence, form, length), (_, kind, size, names) in pairs:
        if form != kind or size not in (None, length):
            yield "%s is %s %s, pycrate has %s %s" % (name, form, length, kind, size)
        if length != "1/2" and not any(abbreviates(NAMES.get(other, other), name + " " + value_type) for other in names):
            yield "%s, pycrate has %s" % (name, names)


messages = {}
for line in open(sys.argv[1], encoding="utf-8"):
    cells = line.rstrip("\n").split("\t")
    if cells[0] == "message":
        messages.setdefault(tuple(cells[1:4]), [])
    else:
        messages[tuple(cells[:3])].append(cells[3:])
compared = 0
for key, ours in messages.items():
    if (key[0], key[2]) not in CLASSES:
        continue
    compared += 1
    if int(key[1]) not in CLASSES[key[0], key[2]]:
        print(*key, "pycrate has no such message")
        continue
    for difference in differences(key, ours):
        print(*key, difference)
print(compared, "messages compared")
