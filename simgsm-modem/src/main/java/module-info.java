/**
 * What every terminal and the network share: the air interface, short messages, DTMF, speech, the mobile station, the
 * GSM modem (M2), and the small Swing and console pieces that all programs use.
 *
 * <p>Packages, arrows point down only:
 *
 * <pre>
 *   modem       -> modem.tools, station, console, dtmf, air
 *   modem.tools -> console, dtmf, speech
 *   station     -> sim, sms, dtmf, speech, air
 *   modem.tools -> modem.load, modem.fuzz, console, dtmf, speech
 *   modem.load  -> station, console, air
 *   modem.fuzz  -> station, sms, dtmf, speech, air
 *   station     -> sms, dtmf, speech, air
 *   ui          -> console, dtmf, speech
 *   sim         -> console, air
 *   sms         -> air
 *   console, dtmf, speech and air need nothing
 * </pre>
 */
module simgsm.modem {
    requires java.logging;
    requires transitive java.desktop;

    exports simgsm.air;
    exports simgsm.sms;
    exports simgsm.sim;
    exports simgsm.modem;
    exports simgsm.modem.fuzz;
    exports simgsm.station;
    exports simgsm.dtmf;
    exports simgsm.speech;
    exports simgsm.console;
    exports simgsm.ui;
}
