"""A SIP phone (pjsua2) of the gateway: calls twice with KEYS, by events and by INFO, sends them as MESSAGE, and is called.

pjsua2_calls.py GATEWAY_PORT OWN_PORT NUMBER PASSWORD CALLED KEYS
Prints what happens, a line each: "registered STATUS", "confirmed", "ended", "sent STATUS", "message TEXT", "incoming".
A line on standard input ends the call, then begins the next step.
"""
import os
import sys

import pjsua2 as pj

gateway, own, number, password, called, keys = sys.argv[1:]
host = "127.0.0.1"
target = f"sip:{called}@{host}:{gateway}"


def tell(*words):
    print(*words, flush=True)


class Call(pj.Call):
    def onCallState(self, prm):
        state = self.getInfo().state
        if state == pj.PJSIP_INV_STATE_CONFIRMED:
            tell("confirmed")
        elif state == pj.PJSIP_INV_STATE_DISCONNECTED:
            tell("ended")


class Account(pj.Account):
    incoming = None

    def onRegState(self, prm):
        tell("registered", prm.code)

    def onIncomingCall(self, prm):
        tell("incoming")
        self.incoming = Call(self, prm.callId)
        answer = pj.CallOpParam()
        answer.statusCode = 200
        self.incoming.answer(answer)

    def onInstantMessage(self, prm):
        tell("message", prm.msgBody)

    def onInstantMessageStatus(self, prm):
        tell("sent", prm.code)


endpoint = pj.Endpoint()
endpoint.libCreate()
settings = pj.EpConfig()
settings.logConfig.level = settings.logConfig.consoleLevel = 0
endpoint.libInit(settings)
transport = pj.TransportConfig()
transport.port = int(own)
transport.boundAddress = transport.publicAddress = host
endpoint.transportCreate(pj.PJSIP_TRANSPORT_UDP, transport)
endpoint.libStart()
endpoint.audDevManager().setNullDev()
config = pj.AccountConfig()
config.idUri = f"sip:{number}@{host}"
config.regConfig.registrarUri = f"sip:{host}:{gateway}"
config.sipConfig.authCreds.append(pj.AuthCredInfo("digest", "*", number, 0, password))
config.mediaConfig.transportConfig.boundAddress = config.mediaConfig.transportConfig.publicAddress = host
account = Account()
account.create(config)

for method in pj.PJSUA_DTMF_METHOD_RFC2833, pj.PJSUA_DTMF_METHOD_SIP_INFO:
    sys.stdin.readline()
    call = Call(account)
    call.makeCall(target, pj.CallOpParam(True))
    sys.stdin.readline()
    for key in keys:
        press = pj.CallSendDtmfParam()
        press.method = method
        press.duration = 160
        press.digits = key
        call.sendDtmf(press)
        sys.stdin.readline()
    call.hangup(pj.CallOpParam(True))
sys.stdin.readline()
buddy = pj.Buddy()
to = pj.BuddyConfig()
to.uri = target
buddy.create(account, to)
text = pj.SendInstantMessageParam()
text.content = keys
buddy.sendInstantMessage(text)
sys.stdin.readline()
os._exit(0)
