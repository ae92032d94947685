import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/**
 * The phone as a joystick: hold 2 to drive ahead, 8 to drive back, 4 and 6 to turn. Start it in a call with its number, and
 * end it with two stars. In front of a wall the robot stops and plays a 9, until the way is free or it is driven elsewhere.
 */
public class Joystick implements Behaviour {
    @Override
    public Steering decide(Senses senses) {
        switch (senses.key()) {
            case '2':
                if (senses.nearestMeters(2, 5) < 0.4) {
                    play("9");
                    return Steering.STOP;
                }
                return Steering.ofDegrees(0.3, 0);
            case '8':
                return Steering.ofDegrees(-0.2, 0);
            case '4':
                return Steering.ofDegrees(0, 45);
            case '6':
                return Steering.ofDegrees(0, -45);
            default:
                return Steering.STOP;
        }
    }
}
