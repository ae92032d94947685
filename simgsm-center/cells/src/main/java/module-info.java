/** The towers of a town between terminals and a controller: radio, cells, handover. */
module simgsm.cells {
    requires simgsm.air;
    requires simgsm.console;
    requires simgsm.desktop;
}
