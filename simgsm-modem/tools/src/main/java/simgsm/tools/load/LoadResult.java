package simgsm.tools.load;

import java.util.Locale;
import java.util.Optional;
import simgsm.console.Event;

/**
 * What a run has measured.
 *
 * @param firstTrouble the first thing that went wrong, for the operator
 */
public record LoadResult(
        Window attached,
        Window called,
        long framesSent,
        long framesLost,
        Delays speechDelays,
        Window sent,
        Delays messageDelays,
        Optional<String> firstTrouble) {

    /** Whether every phone attached, every call was put through and every message arrived. */
    public boolean isComplete() {
        return attached.done() == attached.count() && called.done() == called.count() && sent.done() == sent.count();
    }

    /** The one line that tells all; a figure of which nothing was asked is a dash. */
    public Event line() {
        return Event.of("load")
                .with("phones", attached.done())
                .with("attachrate", rate(attached))
                .with("calls", called.done())
                .with("callrate", rate(called))
                .with("frames", framesSent)
                .with("lost", framesLost)
                .with("p50ms", millis(speechDelays, 0.5))
                .with("p99ms", millis(speechDelays, 0.99))
                .with("sms", sent.done())
                .with("smslost", sent.count() - sent.done())
                .with("smsrate", rate(sent))
                .with("smsp50ms", millis(messageDelays, 0.5))
                .with("smsp99ms", millis(messageDelays, 0.99));
    }

    /** What is missing, in words. */
    public String shortfall() {
        return "attached " + attached.done() + " of " + attached.count() + " phones, put through " + called.done()
                + " of " + called.count() + " calls, delivered " + sent.done() + " of " + sent.count() + " messages"
                + firstTrouble.map(trouble -> "; first " + trouble).orElse("");
    }

    private static String rate(Window window) {
        return window.done() == 0 ? "-" : String.format(Locale.ROOT, "%.1f", window.perSecond());
    }

    private static String millis(Delays delays, double share) {
        return delays.count() == 0 ? "-" : String.format(Locale.ROOT, "%.2f", delays.millis(share));
    }
}
