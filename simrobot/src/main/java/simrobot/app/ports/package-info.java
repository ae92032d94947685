/** SimRobot's listening ports: read {@link simrobot.app.ports.ListeningPorts} first. */
package simrobot.app.ports;
