/** The towers of a town between terminals and a controller: radio, cells, handover.
 * Open, because the lines of events are read from their records. */
open module simgsm.cells {
    requires simgsm.air;
    requires simgsm.console;
    requires simgsm.desktop;
}
