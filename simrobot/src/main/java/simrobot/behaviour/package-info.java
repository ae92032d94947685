/**
 * Autonomous processes of robots: rules that compute the robot's speeds from the sonar ranges ten times a second. Read
 * {@link simrobot.behaviour.Behaviour} first; {@link simrobot.behaviour.BehaviourKind} lists the processes.
 *
 * <p>A rule has no access to robot, world and time; its caller sets the period. Metres, radians anticlockwise, seconds.
 */
package simrobot.behaviour;
