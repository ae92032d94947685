package simrobot.p2os;

/** How often a client wants to be told something with each information packet. */
enum ReportMode {
    NEVER,
    ONCE,
    ALWAYS;

    static ReportMode ofMode(int mode) {
        if (mode == 1) {
            return ONCE;
        }
        return mode > 1 ? ALWAYS : NEVER;
    }

    ReportMode afterTelling() {
        return this == ALWAYS ? ALWAYS : NEVER;
    }
}
