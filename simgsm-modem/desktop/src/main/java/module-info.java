/** Swing components of all windows, the canvas of their pictures, and the sound card. */
module simgsm.desktop {
    requires transitive java.desktop;
    requires transitive simgsm.console;
    requires transitive simgsm.lesson;
    requires transitive simgsm.sound;
    requires transitive simgsm.base;

    exports simgsm.audio;
    exports simgsm.draw;
    exports simgsm.ui;
    exports simgsm.ui.file;
    exports simgsm.ui.glossary;
    exports simgsm.ui.lesson;
    exports simgsm.ui.pane;
    exports simgsm.ui.scope;
    exports simgsm.ui.window;
}
