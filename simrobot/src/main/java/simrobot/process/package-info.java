/**
 * Processes that a robot runs: {@link simrobot.process.RobotProcess} is what the robot steps,
 * {@link simrobot.process.BehaviourKind} a process that can be chosen by its name, and
 * {@link simrobot.process.BehaviourList} all that can be chosen now. Two rules are built in.
 *
 * <p>Nothing here has a clock or a thread. Metres, radians anticlockwise, seconds.
 */
package simrobot.process;
