/**
 * Autonomous processes of robots: small rules that hear the sonars ten times a second and say how to go on. Read
 * {@link simrobot.behaviour.Behaviour} first; {@link simrobot.behaviour.BehaviourKind} lists what there is.
 *
 * <p>A rule knows no robot, no floor and no time; who runs it gives it its beat. Metres, radians anticlockwise, seconds.
 */
package simrobot.behaviour;
