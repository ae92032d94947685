/** The ports on which SimRobot listens: read {@link simrobot.app.ports.ListeningPorts}. */
package simrobot.app.ports;
