/**
 * SimRobot's wiring: which robots, ports, recordings and views a command line asks for. Read {@link simrobot.app.WindowModel}.
 */
package simrobot.app;
