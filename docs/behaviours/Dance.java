import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/** Dances for 16 s to a beat of one second: forward, back, spin left, spin right. */
public class Dance implements Behaviour {
    private static final Steering[] STEPS = {
        Steering.ofDegrees(0.25, 0), Steering.ofDegrees(-0.25, 0), Steering.ofDegrees(0, 90), Steering.ofDegrees(0, -90),
    };

    private double seconds;

    @Override
    public Steering decide(Senses senses) {
        seconds = senses.seconds();
        Steering step = STEPS[(int) seconds % STEPS.length];

        // A dancer looks where it goes: with something nearer than 0.3 m it only spins.
        boolean ahead = step.metersPerSecond() > 0 && senses.nearestMeters(2, 5) < 0.3;
        boolean behind = step.metersPerSecond() < 0 && senses.nearestMeters(10, 13) < 0.3;
        return ahead || behind ? Steering.ofDegrees(0, 90) : step;
    }

    @Override
    public boolean isDone() {
        return seconds >= 16;
    }
}
