/**
 * Processes of your own: a class that implements {@link simrobot.behaviour.Behaviour} maps a robot's {@linkplain
 * simrobot.behaviour.Senses measurements} to the {@linkplain simrobot.behaviour.Steering speeds} of its wheels.
 *
 * <p>{@code docs/BEHAVIOUR.md} is the tutorial.
 */
package simrobot.behaviour;
