import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/** Drives while a key is held; stops in front of a wall and says so by a tone. */
public class Stick implements Behaviour {
    /** Asked 20 times a second: a gap of half a second between two tones does not stop the robot. */
    private static final int GAP = 10;

    private boolean isReady;
    private char key = Senses.NO_KEY;
    private int silent;

    @Override
    public Steering decide(Senses senses) {
        if (!isReady) {
            isReady = true;
            System.out.println("ready for keys");
        }
        silent = senses.key() == Senses.NO_KEY ? silent + 1 : 0;
        if (silent == 0 || silent > GAP) {
            key = senses.key();
        }
        switch (key) {
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
