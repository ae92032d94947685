/** M1, the handset and its window. Open, because the lines of events are read from their records. */
open module simgsm.phone {
    requires simgsm.station;
    requires simgsm.console;
    requires simgsm.desktop;
}
