package simgsm.tools.load;

import java.util.Locale;
import java.util.Optional;
import simgsm.console.Event;

/**
 * The measurements of a run.
 *
 * @param callsLost calls that ended before their time
 * @param firstError station and cause of the first failure
 */
public record LoadResult(
        TaskWindow attached,
        TaskWindow called,
        int callsLost,
        long framesSent,
        long framesLost,
        DelayHistogram speechDelays,
        TaskWindow sent,
        DelayHistogram messageDelays,
        Optional<String> firstError) {

    /** True if every phone attached, every call was connected and held, and every message arrived. */
    public boolean isComplete() {
        return attached.done() == attached.count()
                && called.done() == called.count()
                && callsLost == 0
                && sent.done() == sent.count();
    }

    /** All figures in one line; {@code -} for a figure not requested. */
    public Event line() {
        return Event.of("load")
                .with("phones", attached.done())
                .with("attachrate", rate(attached))
                .with("calls", called.done())
                .with("callrate", rate(called))
                .with("callslost", callsLost)
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

    /** The missing phones, calls and messages in words. */
    public String shortfall() {
        return "attached " + attached.done() + " of " + attached.count() + " phones, connected " + called.done()
                + " of " + called.count() + " calls, of which " + callsLost + " ended early, delivered " + sent.done()
                + " of " + sent.count() + " messages"
                + firstError.map(error -> "; first " + error).orElse("");
    }

    private static String rate(TaskWindow window) {
        return window.done() == 0 ? "-" : String.format(Locale.ROOT, "%.1f", window.perSecond());
    }

    private static String millis(DelayHistogram delays, double share) {
        return delays.count() == 0 ? "-" : String.format(Locale.ROOT, "%.2f", delays.millis(share));
    }
}
