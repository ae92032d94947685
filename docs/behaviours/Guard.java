import java.util.Locale;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/**
 * A guard on patrol: it drives ahead, turns round at an obstacle, and reports the place by SMS to the number that called. Start
 * it by SMS, and it stays on patrol; the end of a call ends what the call has started.
 */
public class Guard implements Behaviour {
    /** A robot sends one SMS in 10 s; a little more than that between two reports. */
    private static final double SECONDS_BETWEEN_REPORTS = 11;

    private double turningUntil;
    private double nextReport;

    @Override
    public Steering decide(Senses senses) {
        if (senses.seconds() < turningUntil) {
            return Steering.ofDegrees(0, 60);
        }
        if (senses.nearestMeters(2, 5) < 0.5 || senses.isBlocked()) {
            turningUntil = senses.seconds() + 3;
            report(senses);
            return Steering.STOP;
        }
        return Steering.ofDegrees(0.3, 0);
    }

    private void report(Senses senses) {
        if (senses.seconds() >= nextReport && !senses.caller().isEmpty()) {
            nextReport = senses.seconds() + SECONDS_BETWEEN_REPORTS;
            sms(
                    senses.caller(),
                    String.format(Locale.ROOT, "Obstacle ahead of %.1f %.1f m.", senses.xMeters(), senses.yMeters()));
        }
    }
}
