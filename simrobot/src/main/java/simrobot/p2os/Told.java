package simrobot.p2os;

/** How often a client wants to be told something with each information packet. */
enum Told {
    NEVER,
    ONCE,
    ALWAYS;

    static Told ofMode(int mode) {
        if (mode == 1) {
            return ONCE;
        }
        return mode > 1 ? ALWAYS : NEVER;
    }

    Told afterTelling() {
        return this == ALWAYS ? ALWAYS : NEVER;
    }
}
