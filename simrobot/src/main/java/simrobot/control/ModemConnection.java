package simrobot.control;

/**
 * The connection of a robot's modem to its network, or the line of a real modem; callable on any thread.
 *
 * @param begin connects, and keeps connected
 * @param end disconnects in order while the program continues; returns at once
 * @param close releases all resources when the program ends
 */
record ModemConnection(Runnable begin, Runnable end, Runnable close) {}
