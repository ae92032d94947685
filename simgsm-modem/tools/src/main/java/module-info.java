/** The command line tools of simgsm-modem.jar. Requires java.desktop for audio files by javax.sound. */
module simgsm.tools {
    requires java.desktop;
    requires simgsm.console;
    requires simgsm.station;
}
