/**
 * SimRobot, started from the command line: a simulated Pioneer that can be called.
 *
 * <p>Read first: {@link simrobot.SimRobotMain} for what can be asked of it, then {@link simrobot.control.SimRobot}, which is
 * the program below its console and its window.
 */
package simrobot;
