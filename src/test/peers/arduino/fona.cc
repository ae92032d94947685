// Each call of Adafruit_FONA that a modem for voice and messages can serve: fona PORT IMEI
#include "Adafruit_FONA.h"

static char buffer[256];
static uint16_t number;

static void text(const char *call, bool isGiven, const char *expected) {
    tell(call, isGiven && (expected[0] == '\0' ? buffer[0] != '\0' : strcmp(buffer, expected) == 0), buffer);
    buffer[0] = '\0';
}

static char *writable(const char *text) {
    static char copy[64];
    return strcpy(copy, text);
}

int main(int, char **arguments) {
    ModemLine line(atoi(arguments[1]));
    Adafruit_FONA fona(4);

    tell("begin", fona.begin(line));
    tell("type", fona.type() == FONA800L);
    tell("enableRTC", fona.enableRTC(1));
    uint8_t year, month, day, hour, minute, second;
    tell("readRTC", fona.readRTC(&year, &month, &day, &hour, &minute, &second));
    text("getTime", fona.getTime(buffer, sizeof buffer), "");
    tell("enableNetworkTimeSync", fona.enableNetworkTimeSync(true));
    tell("getBattPercent", fona.getBattPercent(&number) && number == 100);
    tell("getBattVoltage", fona.getBattVoltage(&number) && number > 3500 && number < 4300);
    text("getSIMCCID", fona.getSIMCCID(buffer) > 0, "8900101000555010009");
    text("getIMEI", fona.getIMEI(buffer) == 15, arguments[2]);
    tell("getNetworkStatus", fona.getNetworkStatus() == 1);
    tell("getRSSI", fona.getRSSI() == 25);
    tell("setAudio", fona.setAudio(FONA_EXTAUDIO));
    tell("setVolume", fona.setVolume(60));
    tell("getVolume", fona.getVolume() == 60);
    tell("setMicVolume", fona.setMicVolume(0, 10));
    tell("playToolkitTone", fona.playToolkitTone(FONA_STTONE_BEEP, 100));
    tell("playDTMF", fona.playDTMF('5'));
    tell("setSMSInterrupt", fona.setSMSInterrupt(1));
    tell("getSMSInterrupt", fona.getSMSInterrupt() == 1);
    text("sendUSSD", fona.sendUSSD(writable("*100#"), buffer, sizeof buffer, &number), "5550100");
    tell("sendSMS", fona.sendSMS(writable("5550101"), writable("a text")));
    want("message");
    delay(2000);
    tell("getNumSMS", fona.getNumSMS() == 1);
    text("readSMS", fona.readSMS(1, buffer, 200, &number), "hello");
    text("getSMSSender", fona.getSMSSender(1, buffer, sizeof buffer), "+5550101");
    tell("deleteSMS", fona.deleteSMS(1) && fona.getNumSMS() == 0);
    tell("callPhone", fona.callPhone(writable("5550200")));
    delay(4000);
    tell("getCallStatus", fona.getCallStatus() == FONA_CALL_INPROGRESS);
    tell("hangUp", fona.hangUp());
    delay(1000);
    tell("callerIdNotification", fona.callerIdNotification(true));
    want("call");
    delay(500);
    ring_indicator();
    text("incomingCallNumber", fona.incomingCallNumber(buffer), "+5550101");
    tell("pickUp", fona.pickUp());
    tell("hangUp of the other's call", fona.hangUp());
    printf("%d of %d\n", right, asked);
    return right != asked;
}
