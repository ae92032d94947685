"""A mail server (aiosmtpd) with faults by the receiver's name. Prints each mail that it takes as "mail MESSAGE-ID TO"."""
import asyncio
import sys
from email import message_from_bytes, policy

from aiosmtpd.controller import Controller


class Faults:
    """Answers by the left part of the receiver's address."""

    async def handle_RCPT(self, server, session, envelope, address, options):
        name = address.split("@")[0]
        if name == "silent":
            await asyncio.sleep(60)
        if name == "later":
            return "451 4.3.0 try later"
        if name == "nobody":
            return "550 5.1.1 no such user"
        envelope.rcpt_tos.append(address)
        return "250 OK"

    async def handle_DATA(self, server, session, envelope):
        mail = message_from_bytes(envelope.content, policy=policy.default)
        name = envelope.rcpt_tos[0].split("@")[0]
        if name == "full":
            print("full", mail["Message-ID"], flush=True)
            return "452 4.3.1 full"
        if name == "closes":
            print("closed", mail["Message-ID"], flush=True)
            server.transport.abort()
            return "250 never read"
        print("text", mail.get_content().strip().replace("\n", " / "), flush=True)
        print("mail", mail["Message-ID"], envelope.rcpt_tos[0], mail["Auto-Submitted"], flush=True)
        return "250 taken"


controller = Controller(Faults(), hostname="127.0.0.1", port=int(sys.argv[1]))
controller.start()
print("ready", flush=True)
sys.stdin.read()
controller.stop()
