/** M1, the handset and its window. */
module simgsm.phone {
    requires simgsm.station;
    requires simgsm.console;
    requires simgsm.desktop;
}
