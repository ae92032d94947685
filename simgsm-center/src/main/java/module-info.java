/** M3, the SMS/Phone centre: exchange, registers, short message centre and their window. */
module simgsm.center {
    requires simgsm.modem;
}
