/**
 * The gateway: browsers as subscribers of the GSM network. Open, because the lines of events are read from their records.
 * Requires java.desktop for the TIFF files of ImageIO.
 */
open module simgsm.gateway {
    requires java.desktop;
    requires simgsm.station;
    requires simgsm.console;
    requires simgsm.web;
}
