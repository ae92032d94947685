package simrobot.control;

/**
 * How a robot's modem reaches its network, or a real modem's line; callable on any thread.
 *
 * @param begin connects, and keeps connected
 * @param end disconnects in order, while the program goes on; returns at once
 * @param close releases what is left when the program ends
 */
record ModemConnection(Runnable begin, Runnable end, Runnable close) {}
