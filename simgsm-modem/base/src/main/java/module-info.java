/**
 * Pieces without a subject of their own that every other module may use: octets, state tables, timers, events, sockets with a
 * selector, and the files that users name.
 */
module simgsm.base {
    exports simgsm.event;
    exports simgsm.file;
    exports simgsm.net;
    exports simgsm.octets;
    exports simgsm.state;
    exports simgsm.timer;
}
