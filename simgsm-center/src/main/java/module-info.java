/** M3, the SMS/Phone centre: exchange, registers, short message centre and their window. */
module simgsm.center {
    requires transitive simgsm.modem;

    exports simgsm.center.journal;
    exports simgsm.center.msc;
    exports simgsm.center.net;
    exports simgsm.center.smpp;
    exports simgsm.center.smsc;
    exports simgsm.center.subscriber;
    exports simgsm.center.timer;
}
