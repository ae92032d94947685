/**
 * Pieces without a subject of their own that every other module may use: octets, state tables, timers, and sockets with a
 * selector.
 */
module simgsm.base {
    exports simgsm.net;
    exports simgsm.octets;
    exports simgsm.state;
    exports simgsm.timer;
}
