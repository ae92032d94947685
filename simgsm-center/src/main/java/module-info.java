/** M3, the SMS/Phone centre: exchange, registers, short message centre and their window.
 * Open, because the lines of events are read from their records. */
@SuppressWarnings("module") // the module that it is exported to is built later
open module simgsm.center {
    requires simgsm.air;
    requires simgsm.sound;
    requires simgsm.console;
    requires simgsm.desktop;
    requires simgsm.web;

    exports simgsm.center to
            simgsm.classroom;
    exports simgsm.center.app to
            simgsm.classroom;
    exports simgsm.center.capture to
            simgsm.classroom;
    exports simgsm.center.msc to
            simgsm.classroom;
    exports simgsm.center.net to
            simgsm.classroom;

    uses simgsm.center.CenterLauncher;
}
