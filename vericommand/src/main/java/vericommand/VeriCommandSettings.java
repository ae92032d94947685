package vericommand;

import java.util.Locale;
import java.util.Objects;
import java.util.Set;

/**
 * Who may command a robot, and how it replies.
 *
 * @param language of the reply texts; English unless Spanish
 * @param operators the numbers that may command; empty: every number
 */
public record VeriCommandSettings(Locale language, Set<String> operators, OnHangup onHangup) {
    /** What happens to the motion under way when the call that ordered it ends. */
    public enum OnHangup {
        /** The robot brakes: it must not run on without an operator. */
        STOP,
        /** The current instruction is finished, the following ones are dropped. */
        FINISH
    }

    /** English, every number, stop. */
    public static final VeriCommandSettings DEFAULT = new VeriCommandSettings(Locale.ENGLISH, Set.of(), OnHangup.STOP);

    public VeriCommandSettings {
        Objects.requireNonNull(language);
        Objects.requireNonNull(onHangup);
        operators = Set.copyOf(operators);
    }

    /** @param number as authenticated by the network; empty when the network does not say */
    public boolean permits(String number) {
        return operators.isEmpty() || operators.contains(number);
    }

    /** The first tone of a call: accepted, or denied because the robot is off or the caller is not permitted. */
    public ReplyTone admission(String caller, RobotStatus status) {
        return permits(caller) && status != RobotStatus.DISCONNECTED
                ? ReplyTone.CONNECTION_ACCEPTED
                : ReplyTone.CONNECTION_DENIED;
    }
}
