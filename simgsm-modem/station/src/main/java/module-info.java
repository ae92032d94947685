/** The mobile station and the GSM modem (M2) built on it. */
module simgsm.station {
    requires transitive simgsm.base;
    requires transitive simgsm.air;
    requires transitive simgsm.sound;

    exports simgsm.modem;
    exports simgsm.modem.at;
    exports simgsm.modem.at.command;
    exports simgsm.modem.at.port;
    exports simgsm.modem.client;
    exports simgsm.modem.line;
    exports simgsm.station;
    exports simgsm.station.call;
    exports simgsm.station.context;
    exports simgsm.station.mobility;
    exports simgsm.station.sms;
    exports simgsm.station.ss;
}
