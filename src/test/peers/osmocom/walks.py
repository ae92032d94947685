#!/usr/bin/env python3
"""Walks a phone through a town to and fro in one call to a robot, and requires that the call is kept.

    walks.py FILE.town COUNT FOLDER ours|osmo-bsc

Beside our centre it starts that, too; osmo-bsc's core is core.sh's. The walk is from the first tower to the last; after each way
an order by tones is executed. Prints a line for each there and back; the exit status is 0 only if all kept the call.
"""
import re
import sys

from programs import Missing, Program, ROOT

TOWN, COUNT, FOLDER, CONTROLLER = sys.argv[1], int(sys.argv[2]), sys.argv[3], sys.argv[4]
SPEED = 200
A, ROBOT = "5550100", "5550200"
towers = re.findall(r"^tower (\S+) (\S+) (\S+)", open(TOWN).read(), re.M)
programs = []


def start(name, *arguments):
    programs.append(Program(FOLDER, name, *arguments))
    return programs[-1]


def walk(to):
    """Walks to a tower. Returns the handovers."""
    name, x, y = to
    cells.clear()
    cells.say("walk %s %s %s %d" % (A, x, y, SPEED))
    path = []
    while not path or path[-1] != name:
        line = cells.expect("handover|radio-link-failure", 90)
        if not re.search("result=success", line):
            raise Missing(line)
        path.append(re.search("to=(\\S+)", line).group(1))
    phone.clear()
    phone.say("press **#*#90**")
    phone.expect("tone key=3", 20, without="released")
    return path


center = "127.0.0.1:3003"
if CONTROLLER == "ours":
    center = "127.0.0.1:" + re.search(r"port=(\d+)", start(
        "simgsm-center", "--port", "0", "--data", FOLDER + "/data").expect("ready")).group(1)
cells = start("simgsm-cells", "--town", TOWN, "--controller", CONTROLLER, "--center", center, "--port", "0")
address = "127.0.0.1:" + re.search(r"port=(\d+)", cells.expect("ready")).group(1)
cells.say("place %s %s %s" % (A, *towers[0][1:]))
cells.say("place %s %s %s" % (ROBOT, *towers[0][1:]))
phone = start("simgsm-phone", "--no-sound", "--center", address, "--number", A)
phone.expect("registered", 60)
robot = start("simrobot", "--no-sound", "--center", address, "--number", ROBOT, "--answer-after", "1500",
              "--world", ROOT + "/worlds/empty.map")
robot.expect("registered", 60)
phone.say("dial " + ROBOT)
phone.expect("tone key=1")
kept = 0
for number in range(1, COUNT + 1):
    try:
        there, back = walk(towers[-1]), walk(towers[0])
        kept += 1
        print("walk=%d there=%s back=%s" % (number, ",".join(there), ",".join(back)), flush=True)
    except Missing as missing:
        print("walk=%d lost: %s" % (number, missing), flush=True)
        phone.say("hangup")
        cells.say("place %s %s %s" % (A, *towers[0][1:]))
        robot.expect("released|error", 60)
        for _ in range(3):
            try:
                phone.say("dial " + ROBOT)
                phone.expect("tone key=1")
                break
            except Missing:
                phone.say("hangup")
print("%d of %d walks there and back kept the call" % (kept, COUNT), flush=True)
for each in reversed(programs):
    each.say("quit")
    each.process.wait(30)
sys.exit(0 if kept == COUNT else 1)
