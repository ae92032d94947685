package simgsm.tools.load;

import simgsm.air.Msisdn;
import simgsm.console.HostPort;

/**
 * The options of a load run.
 *
 * @param center address of the centre
 * @param firstNumber the first station's number; the others count up from it
 * @param phones stations to attach
 * @param calls calls to hold at the same time, each between two stations without another call
 * @param messages short messages to send in total
 * @param seconds duration of the calls, and least time that the stations stay attached
 * @param answerAfterMillis ringing time of a called station
 */
public record LoadOptions(
        HostPort center, long firstNumber, int phones, int calls, int messages, int seconds, int answerAfterMillis) {
    /** A centre accepts 20 000 terminals unless its options say otherwise. */
    public static final int MOST_PHONES = 100_000;

    public static final int MOST_MESSAGES = 1_000_000;
    /** 24 h. */
    public static final int MOST_SECONDS = 86_400;

    /** Ringing timeout of a caller. */
    public static final int MOST_RINGING_MILLIS = 20_000;

    /** The highest number with an IMSI in an open network. */
    private static final long LAST_NUMBER = 9_999_999_999L;

    /** IllegalArgumentException names the option that is out of range. */
    public LoadOptions {
        require("--phones", phones, 1, MOST_PHONES);
        require("--sms", messages, 0, MOST_MESSAGES);
        require("--seconds", seconds, 1, MOST_SECONDS);
        require("--answer-after", answerAfterMillis, 0, MOST_RINGING_MILLIS);
        require("--first-number", firstNumber, 1, LAST_NUMBER - phones + 1);
        if (calls < 0 || calls > phones / 2) {
            throw new IllegalArgumentException("--calls: expected 0 to " + phones / 2 + ", since a call takes two of "
                    + phones + " phones, found " + calls);
        }
    }

    private static void require(String option, long found, long least, long most) {
        if (found < least || found > most) {
            throw new IllegalArgumentException(
                    option + ": expected a whole number of " + least + " to " + most + ", found " + found);
        }
    }

    Msisdn number(int phone) {
        return new Msisdn(String.valueOf(firstNumber + phone));
    }
}
