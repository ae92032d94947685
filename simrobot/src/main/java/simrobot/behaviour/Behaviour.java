package simrobot.behaviour;

/**
 * A process of one robot, written by you: SimRobot asks it every 50 ms of simulated time for the robot's speeds.
 *
 * <p>The class needs a constructor without parameters; every robot that runs the process has its own object. All objects of a
 * file live in one process of the operating system and decide on its one thread. While a decision takes more than 50 ms
 * the robot brakes; one that takes 1 s ends the process, as does every exception.
 */
public interface Behaviour {
    /**
     * Makes one decision. It takes effect 50 ms of simulated time after the measurements.
     *
     * @param senses the robot's measurements; immutable. A run without a clock ({@code --run}) lets them be read during this call only
     * @return the speeds until the next decision
     */
    Steering decide(Senses senses);

    /**
     * Returns true to end the process; called after each decision. The robot brakes, and an order that started the
     * process is answered by 3.
     */
    default boolean isDone() {
        return false;
    }

    // ---- requests, valid in decide -------------------------------------------------------------------------------

    /** Sends an SMS through the robot's modem: at most one in 10 s, further ones are dropped. @param text at most 160 characters */
    default void sms(String number, String text) {
        BehaviourAnswer.ask(new BehaviourRequest.Sms(number, text));
    }

    /**
     * Plays keys to the caller, 150 ms each; dropped without a call, and while earlier keys sound.
     *
     * @param keys at most 16
     */
    default void play(String keys) {
        BehaviourAnswer.ask(new BehaviourRequest.Tones(keys));
    }

    /**
     * Drives to a goal, dock or home of the world, for as long as each decision asks for it: {@code return goTo("Library");}. The process
     * fails if there is no such place, or no way.
     */
    default Steering goTo(String place) {
        BehaviourAnswer.ask(new BehaviourRequest.DriveTo(place));
        return Steering.STOP;
    }

    /** Draws a line on the floor, metres. The robot's newest 500 lines and texts are shown until its next process. */
    default void drawLine(double x, double y, double toX, double toY) {
        BehaviourAnswer.ask(new BehaviourRequest.Mark(x, y, toX, toY, ""));
    }

    /** Writes on the floor, metres. @param text at most 60 characters */
    default void drawText(double x, double y, String text) {
        BehaviourAnswer.ask(new BehaviourRequest.Mark(x, y, x, y, text));
    }
}
