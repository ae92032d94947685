/** The gateway: browsers as subscribers of the GSM network. */
module simgsm.gateway {
    requires simgsm.station;
    requires simgsm.console;
    requires simgsm.web;
}
