"""Serves one of the modem profiles of python-gsmmodem-new's own tests on a TCP port, which it prints.

Usage: fake_modem.py FOLDER PROFILE   (FOLDER holds fakemodems.py)
"""

import socket
import sys

sys.path.insert(0, sys.argv[1])
import fakemodems

modem = getattr(fakemodems, sys.argv[2])()
server = socket.create_server(("127.0.0.1", 0))
print(server.getsockname()[1], flush=True)
client, _ = server.accept()
command = ""
while True:
    octets = client.recv(1024).decode("latin-1")
    if not octets:
        break
    for octet in octets.replace("\x1b", ""):
        command += octet
        if octet == "\r":
            for part in modem.getResponse(command):
                if isinstance(part, str):
                    client.sendall(part.encode("latin-1"))
            command = ""
