/** Command line, headless console, exit statuses, log settings and lessons of all programs. */
module simgsm.console {
    requires java.logging;
    requires simgsm.base;
    requires transitive jdk.httpserver;

    exports simgsm.console;
    exports simgsm.lesson;
    exports simgsm.web;
}
