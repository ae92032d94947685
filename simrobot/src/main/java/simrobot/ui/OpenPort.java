package simrobot.ui;

/**
 * A TCP port on which the program listens.
 *
 * @param protocol P2OS, HTTP or AT
 * @param robot that the port belongs to; empty for a port of the whole program
 */
public record OpenPort(String protocol, String robot, int port) {}
