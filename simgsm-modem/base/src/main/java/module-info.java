/**
 * Packages shared by all other modules: octets, state tables, timers, threads, events, sockets with a selector, and files
 * named by users.
 */
module simgsm.base {
    exports simgsm.event;
    exports simgsm.file;
    exports simgsm.net;
    exports simgsm.octets;
    exports simgsm.state;
    exports simgsm.thread;
    exports simgsm.timer;
}
