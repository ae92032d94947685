package simgsm.center.app;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import simgsm.center.msc.BroadcastView;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.call.CallView;
import simgsm.center.smsc.DeliveryAttempt;
import simgsm.center.smsc.MessageHistory;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.subscriber.Subscriber;
import simgsm.console.Event;

/** Console events of the exchange's events and lists. */
public final class CenterEventPrinter {
    private CenterEventPrinter() {}

    /** The first event of a console, with the ports that are open. */
    public static Event ready(Center center) {
        Event ready = Event.of("ready").with("port", center.port());
        return withPort(withPort(ready, "smpp", center.smppPort()), "http", center.httpPort());
    }

    private static Event withPort(Event event, String name, OptionalInt port) {
        return port.isPresent() ? event.with(name, port.getAsInt()) : event;
    }

    public static Event of(ExchangeEvent event) {
        if (event instanceof ExchangeEvent.Attached attached) {
            return Event.of("attached").with("number", attached.number());
        }
        if (event instanceof ExchangeEvent.Detached detached) {
            return Event.of("detached").with("number", detached.number());
        }
        if (event instanceof ExchangeEvent.CallChanged call) {
            return parties(Event.of("call"), call.from(), call.to()).with("state", word(call.state()));
        }
        ExchangeEvent.MessageChanged message = (ExchangeEvent.MessageChanged) event;
        return of(message);
    }

    /** Made from one map, since there are up to 10 000 of these per second. */
    private static Event of(ExchangeEvent.MessageChanged message) {
        Map<String, String> fields = new LinkedHashMap<>();
        fields.put("id", Long.toString(message.id()));
        fields.put("from", message.from().digits());
        fields.put("to", message.to().digits());
        fields.put("state", word(message.state()));
        return new Event("sms", fields);
    }

    public static Event of(Subscriber subscriber, boolean isBarred) {
        String otherwise = isBarred ? "barred" : "detached";
        return Event.of("subscriber")
                .with("number", subscriber.number())
                .with("state", subscriber.isAttached() ? "attached" : otherwise);
    }

    /** A row of the list of calls, with the seconds since the call became active. */
    public static Event of(CallView call) {
        return parties(Event.of("call"), call.from(), call.to())
                .with("state", word(call.state()))
                .with("seconds", call.activeSeconds());
    }

    /** A waiting message: its state is accepted. */
    public static Event of(ShortMessage message) {
        return parties(Event.of("queued").with("id", message.id()), message.from(), message.to())
                .with("state", word(MessageState.ACCEPTED));
    }

    /** The history of a message and its next attempt; times in UTC. */
    public static Event of(MessageHistory history) {
        ShortMessage message = history.message();
        Event event = parties(Event.of("message").with("id", message.id()), message.from(), message.to())
                .with("state", word(history.state()))
                .with("standing", word(history.waitReason()))
                .with("accepted", time(message.acceptedAt()))
                .with("expires", time(message.expiresAt()))
                .with("attempts", history.attemptCount());
        if (history.nextTry().isPresent()) {
            event = event.with("next", time(history.nextTry().get()));
        }
        return history.endedAt().isPresent()
                ? event.with("ended", time(history.endedAt().get()))
                : event;
    }

    public static Event of(DeliveryAttempt attempt) {
        return Event.of("attempt").with("at", time(attempt.at())).with("outcome", word(attempt.outcome()));
    }

    private static String time(Instant time) {
        return time.truncatedTo(ChronoUnit.SECONDS).toString();
    }

    public static Event of(BroadcastView broadcast) {
        Event event = Event.of("broadcast")
                .with("id", broadcast.id())
                .with("channel", broadcast.channel())
                .with("language", broadcast.language().orElse(""))
                .with("update", broadcast.update())
                .with("pages", broadcast.pages())
                .with("every", broadcast.period().toSeconds())
                .with("sent", broadcast.sent());
        return (broadcast.left().isPresent()
                        ? event.with("left", broadcast.left().getAsInt())
                        : event)
                .with("text", broadcast.text());
    }

    private static Event parties(Event event, Object from, Object to) {
        return event.with("from", from).with("to", to);
    }

    private static String word(Enum<?> state) {
        return state.name().toLowerCase(Locale.ROOT);
    }
}
