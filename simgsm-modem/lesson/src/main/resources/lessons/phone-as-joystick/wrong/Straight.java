import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/** Drives ahead whatever is keyed. */
public class Straight implements Behaviour {
    @Override
    public Steering decide(Senses senses) {
        return Steering.ofDegrees(0.3, 0);
    }
}
