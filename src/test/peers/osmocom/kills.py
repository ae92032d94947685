#!/usr/bin/env python3
"""Kills the programs of an Osmocom core at random moments and requires that all terminals work 60 s later.

    core.sh worlds/village.town 5550100,5550101,5550200 'python3 kills.py COUNT SEED FOLDER'

FOLDER has core.sh's logs and process ids ($OSMOCOM_LOGS). Two phones and a robot are busy while osmo-msc, osmo-hlr, osmo-bsc or
osmo-stp is killed; their users go on for 40 s. After 60 s: an order by short message with its reply, a message between the
phones, an order by tones, and no channel in use afterwards. A line for each kill, and the exit status is 0 only if all passed.
"""
import os
import random
import re
import signal
import socket
import sys
import time

from programs import Missing, Program, ROOT

COUNT, SEED, FOLDER = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
PROGRAMS = ["osmo-msc", "osmo-hlr", "osmo-bsc", "osmo-stp"]
USABLE_SECONDS, GIVEN_UP_SECONDS = 60, 400
A, B, ROBOT = "5550100", "5550101", "5550200"


def channels():
    """The channels that osmo-bsc has in use."""
    with socket.create_connection(("127.0.0.1", 4242), 5) as vty:
        vty.sendall(b"show lchan summary\r\nexit\r\n")
        text = b""
        while True:
            part = vty.recv(65536)
            if not part:
                break
            text += part
    return [line.strip() for line in text.decode("latin1").splitlines() if "Lchan" in line and "BTS" in line]


def busy(moment, dice):
    """Begins what the terminals do when the program is killed."""
    if moment == "message":
        a.say("sms %s hello" % B)
    elif moment == "setup":
        a.say("dial " + ROBOT)
    elif moment == "registration":
        a.say("power off")
        a.say("power on")
    elif moment in ("call", "handover"):
        a.say("dial " + ROBOT)
        a.expect("tone key=1")
        if moment == "handover":
            cells.say("place %s %d 0" % (A, dice.choice((300, 3700))))
        else:
            a.say("press **#**400**")
    time.sleep(dice.uniform(0, 4))


def await_idle():
    """osmo-msc refuses a service that is asked for while it releases the phone's last connection."""
    for _ in range(100):
        cells.say("mobiles")
        if "state=idle" in cells.expect("mobile number=" + A):
            return
        time.sleep(0.1)
    raise Missing(A + " is not idle")


def work(number):
    """All terminals work: messages, orders both ways, and every channel is free afterwards."""
    for each in (a, b, robot, cells):
        each.clear()
    a.say("sms %s ** #*#%d **" % (ROBOT, 90))
    a.expect("sms-sent", without="sms-failed")
    robot.expect("sms .*from=" + A)
    a.expect("sms .*from=" + ROBOT)
    b.say("sms %s number %d" % (A, number))
    b.expect("sms-sent", without="sms-failed")
    a.expect("sms .*from=" + B)
    time.sleep(1)
    await_idle()
    a.say("dial " + ROBOT)
    a.expect("connected", without="released|call-failed")
    a.expect("tone key=1")
    a.say("press **#*#90**")
    a.expect("tone key=3")
    a.say("hangup")
    a.expect("released")
    robot.expect("released")


def kill(number, program, moment, dice):
    busy(moment, dice)
    pid = int(open(os.path.join(FOLDER, program + ".pid")).read())
    os.kill(pid, signal.SIGKILL)
    killed = time.monotonic()
    time.sleep(dice.uniform(1, 15))
    tried = dice.choice(("sms %s hello again" % B, "dial " + ROBOT, "hangup", "inbox"))
    a.say(tried)
    time.sleep(max(0, killed + 40 - time.monotonic()))
    a.say("hangup")
    time.sleep(killed + USABLE_SECONDS - time.monotonic())
    first, faults = None, []
    while first is None and time.monotonic() - killed < GIVEN_UP_SECONDS:
        begun = time.monotonic() - killed
        try:
            work(number)
            first = begun
        except Missing as missing:
            faults.append("%.0f s: %s" % (begun, missing))
            print("  " + faults[-1], flush=True)
            a.say("hangup")
            time.sleep(5)
    for _ in range(20):
        time.sleep(1)
        stuck = channels()
        if not stuck:
            break
    passed = not faults and not stuck
    print("kill=%d program=%s moment=%s then=%s usable=%s result=%s%s%s" % (
        number, program, moment, tried.split()[0], "never" if first is None else "%.0f" % first,
        "pass" if passed else "fail", " faults=" + "; ".join(faults) if faults else "",
        " stuck=" + "; ".join(stuck) if stuck else ""), flush=True)
    if not passed:
        for each in (a, b, robot, cells):
            print("--- %s\n  %s" % (each.name, "\n  ".join(each.log[-40:])), flush=True)
    return passed


cells = Program(FOLDER, "simgsm-cells", "--town", os.path.join(ROOT, "worlds", "village.town"), "--controller", "osmo-bsc",
                "--center", "127.0.0.1:3003", "--port", "0")
address = "127.0.0.1:" + re.search(r"port=(\d+)", cells.expect("ready")).group(1)
a = Program(FOLDER, "simgsm-phone", "--no-sound", "--center", address, "--number", A)
a.expect("registered", 60)
b = Program(FOLDER, "simgsm-phone", "--no-sound", "--center", address, "--number", B)
b.expect("registered", 60)
robot = Program(FOLDER, "simrobot", "--no-sound", "--center", address, "--number", ROBOT, "--answer-after", "1500",
                "--world", os.path.join(ROOT, "worlds", "empty.map"))
robot.expect("registered", 60)
dice = random.Random(SEED)
passed = 0
for number in range(1, COUNT + 1):
    moment = dice.choice(("idle", "message", "setup", "call", "handover", "registration"))
    program = PROGRAMS[(number + SEED) % len(PROGRAMS)]
    try:
        passed += kill(number, program, moment, dice)
    except Missing as missing:
        print("kill=%d program=%s moment=%s result=not-begun %s" % (number, program, moment, missing), flush=True)
print("%d of %d kills: all terminals usable after %d s, no channel in use" % (passed, COUNT, USABLE_SECONDS), flush=True)
for each in (a, b, robot, cells):
    each.say("quit")
    each.process.wait(30)
sys.exit(0 if passed == COUNT else 1)
