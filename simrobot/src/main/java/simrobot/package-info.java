/**
 * SimRobot: a simulated Pioneer with a modem.
 *
 * <p>Read first: {@link simrobot.SimRobotMain} for its options, then {@link simrobot.control.SimRobot}, the program
 * without console and window.
 */
package simrobot;
