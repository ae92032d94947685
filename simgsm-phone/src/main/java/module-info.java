/** M1, the handset and its window. */
module simgsm.phone {
    requires simgsm.modem;
}
