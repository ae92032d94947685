/** M1, the handset and its window. Open, because lines of events are read from records. */
open module simgsm.phone {
    requires simgsm.station;
    requires simgsm.console;
    requires simgsm.desktop;
}
