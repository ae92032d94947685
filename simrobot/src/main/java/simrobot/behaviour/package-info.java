/**
 * For processes of your own: a class that implements {@link simrobot.behaviour.Behaviour} maps what a robot
 * {@linkplain simrobot.behaviour.Senses measures} to the {@linkplain simrobot.behaviour.Steering speeds} of its wheels.
 *
 * <p>{@code docs/BEHAVIOUR.md} leads from an empty file to a driving robot.
 */
package simrobot.behaviour;
