/**
 * SimRobot: a simulated Pioneer with a modem.
 *
 * <p>Read first: {@link simrobot.SimRobotMain} for its options, then {@link simrobot.control.SimRobot}, which is
 * the program below its console and its window.
 */
package simrobot;
