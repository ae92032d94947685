/**
 * The telephone control of robots: connects each robot with a modem (M2) and a verifier (VeriCommand).
 *
 * <p>Read first {@link simrobot.control.SimRobot}, the program without console and window, then
 * {@link simrobot.control.RobotControl}. Two threads are used: the simulation's owns robots and verifiers, the
 * stations' owns modems; they exchange tasks in {@link simrobot.control.ModemLink} only.
 *
 * <pre>
 *   SimRobotMain, ui
 *         |
 *      control ---- vericommand, simgsm.modem, simgsm.console
 *         |
 *     simulation, robot, world
 * </pre>
 */
package simrobot.control;
