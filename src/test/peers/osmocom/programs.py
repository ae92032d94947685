"""Programs of the suite as processes, driven over their consoles."""
import os
import queue
import re
import subprocess
import threading
import time

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), *[".."] * 4)
DIST = os.environ.get("SIMGSM_DIST", os.path.join(ROOT, "target", "dist"))
JAVA = os.path.join(os.environ["JAVA_HOME"], "bin", "java") if "JAVA_HOME" in os.environ else "java"
BEGIN = time.monotonic()


class Missing(Exception):
    pass


class Program:
    """A program with its console."""

    def __init__(self, folder, name, *arguments):
        self.name, self.events, self.log = name, queue.Queue(), []
        self.process = subprocess.Popen(
            [JAVA, "-jar", os.path.join(DIST, name + ".jar"), "--headless", "--lang", "en", *arguments],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=open(os.path.join(folder, name + ".err"), "a"), text=True)
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        for line in self.process.stdout:
            self.log.append("%.1f %s" % (time.monotonic() - BEGIN, line.strip()))
            self.events.put(line.strip())

    def say(self, line):
        self.log.append("%.1f > %s" % (time.monotonic() - BEGIN, line))
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def clear(self):
        while not self.events.empty():
            self.events.get()

    def expect(self, pattern, seconds=30, without=None):
        end = time.monotonic() + seconds
        while True:
            try:
                line = self.events.get(timeout=max(0.01, end - time.monotonic()))
            except queue.Empty:
                raise Missing("%s did not say %s in %d s" % (self.name, pattern, seconds))
            if re.match(pattern, line):
                return line
            if without and re.match(without, line):
                raise Missing("%s said %s before %s" % (self.name, line, pattern))
