import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/** Drives while a key is held; stops in front of a wall and says so by a tone. */
public class Stick implements Behaviour {
    private boolean isReady;

    @Override
    public Steering decide(Senses senses) {
        if (!isReady) {
            isReady = true;
            System.out.println("ready for keys");
        }
        switch (senses.key()) {
            case '{ahead}':
                if (senses.nearestMeters(2, 5) < 0.5) {
                    play("{wall}");
                    return Steering.STOP;
                }
                return Steering.ofDegrees(0.3, 0);
            case '{back}':
                return senses.nearestMeters(10, 13) < 0.5 ? Steering.STOP : Steering.ofDegrees(-0.3, 0);
            case '{left}':
                return Steering.ofDegrees(0, 30);
            default:
                return Steering.STOP;
        }
    }
}
