// Each call of TinyGSM's SIM800 client that a modem for voice and messages can serve: tinygsm PORT
#define TINY_GSM_MODEM_SIM800
#include "Arduino.h"
// after Arduino.h
#include "TinyGsmClient.h"

static void text(const char *call, const String &result, const char *expected) {
    tell(call, expected[0] == '\0' ? result.length() > 0 : result == expected, result.c_str());
}

static void number(const char *call, int result, int least, int most) {
    tell(call, result >= least && result <= most, String(result).c_str());
}

int main(int, char **arguments) {
    ModemLine line(atoi(arguments[1]));
    TinyGsmSim800 modem(line);

    tell("init", modem.init());
    tell("testAT", modem.testAT());
    tell("setBaud", modem.setBaud(115200));
    tell("factoryDefault", modem.factoryDefault());
    tell("restart", modem.restart());
    tell("waitForNetwork", modem.waitForNetwork(20000));
    tell("isNetworkConnected", modem.isNetworkConnected());
    number("getRegistrationStatus", modem.getRegistrationStatus(), 1, 1);
    text("getModemInfo", modem.getModemInfo(), "SIM800 R13.08");
    text("getModemName", modem.getModemName(), "SIMCOM_Ltd SIMCOM_SIM800L");
    text("getModemManufacturer", modem.getModemManufacturer(), "SIMCOM_Ltd");
    text("getModemModel", modem.getModemModel(), "SIMCOM_SIM800L");
    text("getModemRevision", modem.getModemRevision(), "Revision:1308B08SIM800L16");
    text("getModemSerialNumber", modem.getModemSerialNumber(), arguments[2]);
    text("getIMEI", modem.getIMEI(), arguments[2]);
    text("getIMSI", modem.getIMSI(), "001010005550100");
    text("getSimCCID", modem.getSimCCID(), "8900101000555010009");
    number("getSimStatus", modem.getSimStatus(), SIM_READY, SIM_READY);
    text("getOperator", modem.getOperator(), "SimGSM");
    text("getProvider", modem.getProvider(), "SimGSM");
    number("getSignalQuality", modem.getSignalQuality(), 25, 25);
    number("getBattVoltage", modem.getBattVoltage(), 3500, 4300);
    number("getBattPercent", modem.getBattPercent(), 100, 100);
    number("getBattChargeState", modem.getBattChargeState(), 0, 0);
    int8_t state = -1, percent = -1;
    int16_t millivolts = -1;
    bool got = modem.getBattStats(state, percent, millivolts);
    tell("getBattStats", got && state == 0 && percent == 100 && millivolts > 3500);
    int year, month, day, hour, minute, second;
    float zone;
    got = modem.getNetworkTime(&year, &month, &day, &hour, &minute, &second, &zone);
    tell("getNetworkTime", got && year >= 2025 && month >= 1 && month <= 12 && zone >= -12 && zone <= 14);
    text("getGSMDateTime", modem.getGSMDateTime(DATE_FULL), "");
    tell("setVolume", modem.setVolume(70));
    number("getVolume", modem.getVolume(), 70, 70);
    tell("setMicVolume", modem.setMicVolume(0, 9));
    tell("setAudioChannel", modem.setAudioChannel(1));
    tell("playToolkitTone", modem.playToolkitTone(1, 100));
    delay(200); // the library has sent two commands, without their plus, and has read one answer
    modem.streamClear();
    tell("sleepEnable on", modem.sleepEnable(true));
    tell("sleepEnable off", modem.sleepEnable(false));
    text("sendUSSD", modem.sendUSSD("*100#"), "5550100");
    tell("sendSMS", modem.sendSMS("5550101", "a text"));
    const uint16_t letters[] = {0x0048, 0x00ed, 0x0416, 0x20ac};
    tell("sendSMS_UTF16", modem.sendSMS_UTF16("5550101", letters, 4));
    tell("callNumber", modem.callNumber("5550200"));
    delay(4000);
    tell("dtmfSend", modem.dtmfSend('*', 200));
    tell("callHangup", modem.callHangup());
    delay(1000);
    want("call");
    tell("RING", line.await("RING", 10000));
    tell("callAnswer", modem.callAnswer());
    tell("callHangup of the other's call", modem.callHangup());
    tell("setGsmBusy", modem.setGsmBusy(true) && modem.setGsmBusy(false));
    tell("setPhoneFunctionality", modem.setPhoneFunctionality(4) && modem.setPhoneFunctionality(1));
    tell("radioOff", modem.radioOff());
    tell("poweroff", modem.poweroff());
    printf("%d of %d\n", right, asked);
    return right != asked;
}
