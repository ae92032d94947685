#!/usr/bin/env python3
"""A modem that is wired to a sound card: SimRobot hears orders in its input and plays the tones of the answers.

    soundcard.py FOLDER

PulseAudio is the card: it plays into nothing, and its input is what another sink plays. A phone with --at-audio is the modem, whose
sound pacat and parec carry to and from the card. Three orders are keyed; the exit status is 0 only if all are executed.
"""
import os
import re
import socket
import subprocess
import sys
import threading
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "osmocom"))
from programs import Program, ROOT

FOLDER = sys.argv[1]
ORDERS = "**#*#90**", "**#**10**", "**#*#45**"
RAW = "--rate=8000", "--channels=1", "--format=s16le", "--latency-msec=20", "--raw"
FRAME = 320
started, programs = [], []


def server():
    """A sound server of our own, with its files in the folder. Returns once it answers."""
    run = os.path.join(FOLDER, "run")
    os.makedirs(run, 0o700)
    with open(os.path.join(FOLDER, ".asoundrc"), "w") as file:
        file.write("pcm.!default { type pulse }\nctl.!default { type pulse }\n")
    address = os.path.join(run, "native")
    os.environ.update(HOME=FOLDER, XDG_RUNTIME_DIR=run, PULSE_COOKIE=os.path.join(run, "cookie"), PULSE_SERVER="unix:" + address)
    start("pulseaudio", "-n", "--daemonize=no", "--exit-idle-time=-1", "--use-pid-file=no",
          "-L", "module-native-protocol-unix auth-anonymous=1 socket=" + address,
          "-L", "module-null-sink sink_name=card rate=8000 channels=1",
          "-L", "module-null-sink sink_name=modem rate=8000 channels=1", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    end = time.monotonic() + 60
    while subprocess.run(["pactl", "info"], capture_output=True).returncode:
        if time.monotonic() > end:
            sys.exit("pulseaudio does not answer")
    for command in ("set-default-sink", "card"), ("set-default-source", "modem.monitor"):
        subprocess.run(["pactl", *command], check=True)


def start(*command, **streams):
    started.append(subprocess.Popen(command, **streams))
    return started[-1]


def program(name, *arguments):
    programs.append(Program(FOLDER, name, *arguments))
    return programs[-1]


def carry(read, write):
    """Carries sound until either end is closed."""
    try:
        for octets in iter(lambda: read(FRAME), b""):
            write(octets)
    except (OSError, ValueError):
        pass


def wire(port):
    """Joins the modem's sound and the card."""
    sound = socket.create_connection(("127.0.0.1", port))
    play = start("pacat", "--playback", "--device=modem", *RAW, stdin=subprocess.PIPE, bufsize=0)
    record = start("parec", "--device=card.monitor", *RAW, stdout=subprocess.PIPE, bufsize=0)
    for read, write in (sound.recv, play.stdin.write), (record.stdout.read, sound.sendall):
        threading.Thread(target=carry, args=(read, write), daemon=True).start()


def session():
    center = "127.0.0.1:" + re.search(r"port=(\d+)", program(
        "simgsm-center", "--port", "0", "--data", FOLDER + "/data").expect("ready")).group(1)
    modem = program("simgsm-phone", "--no-sound", "--center", center, "--number", "5550200", "--at", "0", "--at-audio", "0")
    ports = {key: int(port) for key, port in re.findall(r"(\S+)=(\d+)", modem.expect("ready"))}
    modem.expect("registered")
    phone = program("simgsm-phone", "--no-sound", "--center", center, "--number", "5550100")
    phone.expect("registered")
    robot = program("simrobot", "--no-sound", "--modem", "127.0.0.1:%d" % ports["at"], "--modem-audio", "soundcard",
                    "--world", ROOT + "/worlds/empty.map")
    robot.expect("modem robot=\\S+ state=ready")
    wire(ports["at-audio"])
    commands = socket.create_connection(("127.0.0.1", ports["at"]))
    phone.say("dial 5550200")
    phone.expect("connected")
    commands.sendall(b"AT^DDSETEX=2\r")
    for order in ORDERS:
        phone.say("press " + order)
        phone.expect("tone key=6")
        phone.expect("tone key=3")
        print(order, "executed", flush=True)
    phone.say("hangup")
    robot.expect("released")


try:
    server()
    session()
finally:
    for each in reversed(programs):
        each.say("quit")
        each.process.wait(30)
    for each in reversed(started):
        each.kill()
        each.wait()
for name in "simgsm-phone", "simrobot":
    with open(os.path.join(FOLDER, name + ".err")) as log:
        if "Exception" in log.read():
            sys.exit(name + " printed a stack trace")
