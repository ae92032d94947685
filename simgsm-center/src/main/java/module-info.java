/** M3, the SMS/Phone centre: exchange, registers, short message centre and their window. */
module simgsm.center {
    requires simgsm.air;
    requires simgsm.sound;
    requires simgsm.console;
    requires simgsm.desktop;
}
