/** The gateway: browsers as subscribers of the GSM network. Open, because the lines of events are read from their records. */
open module simgsm.gateway {
    requires simgsm.station;
    requires simgsm.console;
    requires simgsm.web;
}
