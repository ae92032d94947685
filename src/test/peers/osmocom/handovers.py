#!/usr/bin/env python3
"""Hands a phone over in the middle of orders by tones, and counts what became of the orders.

    handovers.py COUNT SEED FOLDER ours|osmo-bsc

Both controllers decide on the first report that names a better cell. Of each order: executed; reported as broken by tone 7; not
begun (its first key was lost, tone 7 after 10 s without a key); wrong (executed, but the robot turned otherwise); silent. The exit
status is 0 only if none is wrong or silent.
"""
import random
import re
import socket
import sys
import time

from programs import Missing, Program, ROOT

COUNT, SEED, FOLDER, CONTROLLER = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3], sys.argv[4]
TOWN = ROOT + "/worlds/village.town"
A, ROBOT = "5550100", "5550200"
ORDER = "**#*#90**"
dice = random.Random(SEED)


def start(name, *arguments):
    programs.append(Program(FOLDER, name, *arguments))
    return programs[-1]


def decide_at_once():
    with socket.create_connection(("127.0.0.1", 4242), 5) as vty:
        vty.sendall(b"\n".join([
            b"enable", b"configure terminal", b"network", b"handover1 window rxlev averaging 1",
            b"handover1 window rxlev neighbor averaging 1", b"handover1 power budget interval 1", b"end", b"exit", b"exit", b""]))
        while vty.recv(65536):
            pass


def heading():
    robot.clear()
    robot.say("pose")
    return float(re.search("heading=(\\S+)", robot.expect("pose ")).group(1))


def turn(place):
    """One order; the phone is carried to the other tower at a random moment. Returns what became of it and the gap."""
    before = heading()
    for each in (phone, cells, robot):
        each.clear()
    phone.say("press " + ORDER)
    time.sleep(dice.uniform(0, 1.6))
    cells.say("place %s %d 0" % (A, place))
    line = cells.expect("handover number=" + A)
    if "result=success" not in line:
        return "failed", 0
    gap = int(re.search("millis=(\\d+)", cells.expect("speech-gap")).group(1))
    end, tones = time.monotonic() + 15, []
    while time.monotonic() < end and not {"3", "7"} & set(tones):
        try:
            tones.append(re.search("key=(\\S+)", phone.expect("tone key=", end - time.monotonic())).group(1))
        except Missing:
            break
    turned = (before - heading()) % 360
    if "3" in tones:
        return ("executed" if abs(turned - 90) < 0.1 else "wrong"), gap
    if turned:
        return "wrong", gap
    return ("broken" if "7" in tones else "silent"), gap


programs = []
center = "127.0.0.1:3003"
if CONTROLLER == "ours":
    center = "127.0.0.1:" + re.search(r"port=(\d+)", start(
        "simgsm-center", "--port", "0", "--data", FOLDER + "/data", "--handover",
        "power-budget,levels=1,neighbours=1,interval=1,hysteresis=3").expect("ready")).group(1)
else:
    decide_at_once()
cells = start("simgsm-cells", "--town", TOWN, "--controller", CONTROLLER, "--center", center, "--port", "0")
address = "127.0.0.1:" + re.search(r"port=(\d+)", cells.expect("ready")).group(1)
phone = start("simgsm-phone", "--no-sound", "--center", address, "--number", A)
phone.expect("registered", 60)
robot = start("simrobot", "--no-sound", "--center", address, "--number", ROBOT, "--answer-after", "1500",
              "--world", ROOT + "/worlds/empty.map")
robot.expect("registered", 60)
phone.say("dial " + ROBOT)
phone.expect("tone key=1")
results, gaps = {}, []
for number in range(COUNT):
    result, gap = turn((3700, 300)[number % 2])
    results[result] = results.get(result, 0) + 1
    gaps.append(gap)
    if result != "executed":
        keys = "".join(re.findall("keys robot=\\S+ keys=(\\S+)", "\n".join(robot.log[-40:])))
        time.sleep(12)  # an order that has not begun is answered after 10 s
        print("handover=%d %s gap=%d heard ...%s" % (number + 1, result, gap, keys[-14:]), flush=True)
gaps.sort()
print("%d handovers at %s: %s; gap median %d, 95 %% %d, at most %d ms; load %s" % (
    COUNT, CONTROLLER, results, gaps[COUNT // 2], gaps[COUNT * 95 // 100], gaps[-1], open("/proc/loadavg").read().split()[0]))
for each in reversed(programs):
    each.say("quit")
    each.process.wait(30)
sys.exit(0 if not {"wrong", "silent", "failed"} & set(results) else 1)
