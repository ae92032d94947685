/** Pages and data over HTTP, which the programs serve read-only. */
module simgsm.web {
    requires transitive simgsm.base;
    requires simgsm.console;
    requires transitive jdk.httpserver;

    exports simgsm.web;
}
