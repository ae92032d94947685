/** The command line tools of simgsm-modem.jar. Requires java.desktop for javax.sound, which reads audio files. */
module simgsm.tools {
    requires java.desktop;
    requires simgsm.console;
    requires simgsm.station;
}
