package simrobot.behaviour;

/**
 * The robot's telephone at one moment.
 *
 * @param caller the number that called, or started the process by SMS, last; empty if there is none
 * @param key the key held or pressed since the last decision; {@link Senses#NO_KEY} if none
 * @param pressed the keys pressed since the last decision, in their order
 */
public record Call(String caller, char key, String pressed) {}
