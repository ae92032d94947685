/** Swing components that all windows share, and the sound card. */
module simgsm.desktop {
    requires transitive java.desktop;
    requires transitive simgsm.console;
    requires transitive simgsm.sound;

    exports simgsm.audio;
    exports simgsm.ui;
}
