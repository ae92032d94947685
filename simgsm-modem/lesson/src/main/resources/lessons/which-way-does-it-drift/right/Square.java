import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/** Five rounds of a square of 1 m, clockwise, by the wheels alone. */
public class Square implements Behaviour {
    private static final double[][] CORNERS = {{1, 0}, {1, -1}, {0, -1}, {0, 0}};

    private int passed;

    @Override
    public Steering decide(Senses senses) {
        var believed = senses.odometry();
        double[] next = CORNERS[passed % CORNERS.length];
        double dx = next[0] - believed.xMeters();
        double dy = next[1] - believed.yMeters();
        if (Math.hypot(dx, dy) < 0.03) {
            passed++;
            if (passed % CORNERS.length == 2) {
                System.out.println("far");
            }
            if (passed % CORNERS.length == 0) {
                System.out.printf("%.2f %.2f%n", believed.xMeters(), believed.yMeters());
            }
            return Steering.STOP;
        }
        double error = Math.IEEEremainder(Math.atan2(dy, dx) - believed.headingRadians(), 2 * Math.PI);
        return Math.abs(error) > 0.2 ? new Steering(0, Math.signum(error) * 0.8) : new Steering(0.25, 2 * error);
    }

    @Override
    public boolean isDone() {
        return passed == 5 * CORNERS.length;
    }
}
