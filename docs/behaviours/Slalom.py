"""A process in Python: it answers each line "decide" by a line "go" (docs/BEHAVIOUR.md, "Python and other languages")."""
import math
import sys

for line in sys.stdin:
    word, *pairs = line.split()
    if word != "decide":
        continue
    senses = dict(pair.split("=") for pair in pairs)
    sonar = [float(meters) for meters in senses["sonar"].split(",")]
    if min(sonar[2:6]) < 0.6:
        speed, turn = 0, 0.8
    else:
        speed, turn = 0.25, 0.5 * math.sin(float(senses["seconds"]))
    print(f"go robot={senses['robot']} speed={speed} turn={turn}")
