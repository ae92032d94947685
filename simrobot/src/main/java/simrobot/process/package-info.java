/**
 * Processes of a robot: the robot steps {@link simrobot.process.RobotProcess}, users choose a {@link
 * simrobot.process.BehaviourKind} by its name, and {@link simrobot.process.BehaviourList} holds all that are available.
 * Two rules are built in.
 *
 * <p>No class here has a clock or a thread. Metres, radians anticlockwise, seconds.
 */
package simrobot.process;
