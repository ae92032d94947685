/** The air interface: layer 3 messages, the Abis link, short messages, and the SIM; the PDUs of SMPP. */
module simgsm.air {
    requires transitive simgsm.base;

    exports simgsm.abis;
    exports simgsm.air;
    exports simgsm.air.answer;
    exports simgsm.rr;
    exports simgsm.sim;
    exports simgsm.smpp;
    exports simgsm.sms;
    exports simgsm.ss;
    exports simgsm.trace;
}
