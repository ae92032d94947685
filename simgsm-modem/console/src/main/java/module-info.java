/** Command line, headless console, exit statuses and log settings of all programs. */
module simgsm.console {
    requires java.logging;

    exports simgsm.console;
}
