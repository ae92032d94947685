package vericommand;

import java.util.Locale;
import java.util.Set;

/**
 * Who may command a robot, and how it replies.
 *
 * @param language of the reply texts; English unless Spanish
 * @param operators the numbers that may command, without a plus sign; {@code 6245*} is all that begin so; empty: every number
 * @param answered which short messages get a reply
 */
public record VeriCommandSettings(Locale language, Set<String> operators, OnHangup onHangup, Answered answered) {
    /** Which short messages are answered. */
    public enum Answered {
        ALL,
        /** Those that begin with {@code **}; others may be no order at all, and each reply is paid. */
        ORDERS,
        NONE
    }

    /** Treatment of the motion under way at the end of the call that ordered it. */
    public enum OnHangup {
        /** The robot brakes: it must not run on without an operator. */
        STOP,
        /** The current instruction is finished, the following ones are dropped. */
        FINISH
    }

    /** English, every number, stop. */
    public static final VeriCommandSettings DEFAULT = new VeriCommandSettings(Locale.ENGLISH, Set.of(), OnHangup.STOP);

    public VeriCommandSettings {
        operators = Set.copyOf(operators);
    }

    /** As above, answering all messages. */
    public VeriCommandSettings(Locale language, Set<String> operators, OnHangup onHangup) {
        this(language, operators, onHangup, Answered.ALL);
    }

    /** @param number as authenticated by the network; empty when the network does not say */
    public boolean permits(String number) {
        String digits = number.replaceFirst("^\\+", "");
        return operators.isEmpty()
                || operators.stream()
                        .anyMatch(it -> it.endsWith("*")
                                ? digits.startsWith(it.substring(0, it.length() - 1))
                                : digits.equals(it));
    }

    /** The first tone of a call: accepted, or denied because the robot is off or the caller is not permitted. */
    public ReplyTone admission(String caller, RobotStatus status) {
        return permits(caller) && status != RobotStatus.DISCONNECTED
                ? ReplyTone.CONNECTION_ACCEPTED
                : ReplyTone.CONNECTION_DENIED;
    }
}
