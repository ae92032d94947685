package simrobot.ui;

/**
 * A TCP port of the program.
 *
 * @param protocol P2OS, HTTP or AT
 * @param robot served by the port; empty for a port of the whole program
 */
public record OpenPort(String protocol, String robot, int port) {}
