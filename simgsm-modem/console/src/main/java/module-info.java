/** Command line, headless console, exit statuses and log settings of all programs. */
module simgsm.console {
    requires java.logging;
    requires simgsm.base;

    exports simgsm.console;
}
