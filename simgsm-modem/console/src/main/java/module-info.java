/** Command line, headless console, exit statuses, log settings and lessons of all programs. */
module simgsm.console {
    requires java.logging;

    exports simgsm.console;
    exports simgsm.lesson;
    exports simgsm.web;
}
