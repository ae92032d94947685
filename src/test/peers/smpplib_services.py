"""Uses the centre's services with python-smpplib: smpplib_services.py PORT NUMBER PHONE

Binds as a transceiver for NUMBER, refuses the first text "bad" with 0x58, and prints "got TEXT" for each deliver_sm.
Submits "later" to PHONE for 6 s from now, then "now" for now. Ends with 0 once "bad" has come twice.
"""

import logging
import sys

import smpplib.client
import smpplib.consts

logging.disable(logging.CRITICAL)
port, number, phone = int(sys.argv[1]), sys.argv[2], sys.argv[3]
got = []


def received(pdu):
    text = pdu.short_message.decode("latin-1")
    print("got", text)
    got.append(text)
    return smpplib.consts.SMPP_ESME_RTHROTTLED if got.count("bad") == 1 and text == "bad" else 0


def submit(text, schedule):
    client.send_message(
        source_addr_ton=smpplib.consts.SMPP_TON_INTL,
        source_addr_npi=smpplib.consts.SMPP_NPI_ISDN,
        source_addr=number,
        dest_addr_ton=smpplib.consts.SMPP_TON_INTL,
        dest_addr_npi=smpplib.consts.SMPP_NPI_ISDN,
        destination_addr=phone,
        short_message=text.encode("ascii"),
        schedule_delivery_time=schedule,
    )


client = smpplib.client.Client("127.0.0.1", port)
client.set_message_received_handler(received)
client.set_message_sent_handler(lambda pdu: print("submitted", pdu.message_id.decode()))
client.connect()
client.bind_transceiver(system_id="smpplib", password="", address_range=number)
submit("later", "000000000006000R")
submit("now", None)
while got.count("bad") < 2:
    client.read_once()
client.unbind()
client.disconnect()
