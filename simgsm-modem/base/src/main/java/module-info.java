/** Pieces without a subject of their own that every other module may use: state tables and timers. */
module simgsm.base {
    exports simgsm.state;
    exports simgsm.timer;
}
