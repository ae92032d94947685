/** Command line, headless console, exit statuses and log settings of all programs. */
module simgsm.console {
    requires java.logging;
    requires transitive jdk.httpserver;

    exports simgsm.console;
    exports simgsm.web;
}
