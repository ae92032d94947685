"""ARIA meets a SimRobot that is stopped in the handshake: aria_stopped.py ARIA_FOLDER SECONDS TIMES

Builds nothing: aria.sh builds ARIA; robotConnectionCallbacks is made there by `make examples/robotConnectionCallbacks`.
Each time a fresh SimRobot is stopped (SIGSTOP), ARIA's program starts, and SimRobot goes on after SECONDS.
Prints how often ARIA was connected; docs/MEASURED.md has the figures.
"""

import os
import re
import signal
import subprocess
import sys
import time

aria, seconds, times = sys.argv[1], float(sys.argv[2]), int(sys.argv[3])
dist = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../target/dist")
environment = dict(os.environ, ARIA=aria, LD_LIBRARY_PATH=os.path.join(aria, "lib"))


def connects():
    robot = subprocess.Popen(
        ["java", "-jar", os.path.join(dist, "simrobot.jar"), "--headless", "--p2os", "0", "--center", "127.0.0.1:1"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    port = re.search(r"p2os=(\d+)", robot.stdout.readline()).group(1)
    robot.send_signal(signal.SIGSTOP)
    client = subprocess.Popen(
        ["stdbuf", "-oL", os.path.join(aria, "examples/robotConnectionCallbacks"), "-rh", "127.0.0.1", "-rrtp", port],
        env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    time.sleep(seconds)
    robot.send_signal(signal.SIGCONT)
    end = time.time() + 60
    connected = False
    for line in client.stdout:
        connected = "Connected to robot" in line
        if connected or "Failed to connect" in line or time.time() > end:
            break
    for program in (client, robot):
        program.kill()
        program.wait()
    return connected


done = sum(connects() for _ in range(times))
print(f"stopped for {seconds} s: connected {done} of {times}")
