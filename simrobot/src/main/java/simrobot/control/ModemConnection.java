package simrobot.control;

/** How a robot's modem reaches its network, or a real modem's line; callable on any thread. */
interface ModemConnection {
    /** Connects, and keeps connected. */
    void begin();

    /** Disconnects in order, while the program goes on; returns at once. */
    void end();

    /** Releases what is left when the program ends. */
    void close();
}
