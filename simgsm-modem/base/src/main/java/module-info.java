/** Pieces without a subject of their own that every other module may use: octets, state tables and timers. */
module simgsm.base {
    exports simgsm.octets;
    exports simgsm.state;
    exports simgsm.timer;
}
