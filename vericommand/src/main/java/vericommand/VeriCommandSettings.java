package vericommand;

import java.util.Locale;
import java.util.Objects;
import java.util.Set;

/**
 * How a robot is to be commanded.
 *
 * @param language of the reply texts; English unless Spanish
 * @param operators the numbers that may command; empty: every subscriber
 */
public record VeriCommandSettings(Locale language, Set<String> operators, OnHangup onHangup) {
    /** What becomes of the motion under way when the call that ordered it is lost. */
    public enum OnHangup {
        /** The robot brakes: nobody holds it any more. */
        STOP,
        /** The present instruction ends as it would, the ones behind it are dropped. */
        FINISH
    }

    /** English, every subscriber, stop. */
    public static final VeriCommandSettings DEFAULT = new VeriCommandSettings(Locale.ENGLISH, Set.of(), OnHangup.STOP);

    public VeriCommandSettings {
        Objects.requireNonNull(language);
        Objects.requireNonNull(onHangup);
        operators = Set.copyOf(operators);
    }

    /** @param number as the network vouches for it; empty when the network does not say */
    public boolean permits(String number) {
        return operators.isEmpty() || operators.contains(number);
    }

    /** What a caller hears first: accepted, or denied because the robot is off or the caller is not allowed. */
    public ReplyTone admission(String caller, RobotStatus status) {
        return permits(caller) && status != RobotStatus.DISCONNECTED
                ? ReplyTone.CONNECTION_ACCEPTED
                : ReplyTone.CONNECTION_DENIED;
    }
}
