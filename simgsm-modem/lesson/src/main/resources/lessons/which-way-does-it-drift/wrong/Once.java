import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/** Stands, and is done. */
public class Once implements Behaviour {
    private boolean isDone;

    @Override
    public Steering decide(Senses senses) {
        isDone = true;
        System.out.println("0 0");
        return Steering.STOP;
    }

    @Override
    public boolean isDone() {
        return isDone;
    }
}
