/** Pages, data and WebSockets on one port. */
module simgsm.web {
    requires transitive simgsm.base;
    requires simgsm.console;
    requires transitive jdk.httpserver;

    exports simgsm.web;
}
