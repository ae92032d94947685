/**
 * The robot's side of the telephone: for each robot a modem (M2) joined to a verifier (VeriCommand) and a robot of the
 * simulation.
 *
 * <p>Read first {@link simrobot.control.SimRobot}, which holds the whole program below its console or window, then
 * {@link simrobot.control.RobotControl}. Two threads meet here: the simulation's owns robots and verifiers, the stations'
 * owns modems; {@link simrobot.control.ModemLink} is where they post to each other, and nowhere else.
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
