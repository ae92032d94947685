package simgsm.center.web;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntSupplier;
import simgsm.air.Imei;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.msc.call.CallView;
import simgsm.center.smsc.DeliveryAttempt;
import simgsm.center.smsc.MessageHistory;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.subscriber.Subscriber;
import simgsm.web.JsonText;

/** The state of the exchange, as metrics and as JSON. On the exchange's thread; no list has more than 1000 elements. */
final class ExchangeReports {
    static final int MOST_ELEMENTS = 1_000;

    private final EventCounts counts;
    private final IntSupplier applications;

    /** @param applications counts the bound SMPP sessions */
    ExchangeReports(EventCounts counts, IntSupplier applications) {
        this.counts = counts;
        this.applications = applications;
    }

    /** The metrics for Prometheus. */
    String metrics(Exchange exchange) {
        MetricsText text = new MetricsText();
        text.gauge("simgsm_subscribers_attached", "Attached subscribers.").value(exchange.attachedCount());
        text.gauge("simgsm_subscribers_known", "Subscribers that are listed or have ever registered.")
                .value(exchange.subscribers().size());
        text.gauge("simgsm_terminal_links", "Open connections of terminals.").value(exchange.linkCount());
        text.gauge("simgsm_smpp_sessions", "Bound sessions of applications.").value(applications.getAsInt());
        text.gauge("simgsm_calls", "Calls under way by state.");
        for (CallProgress state : CallProgress.values()) {
            if (state != CallProgress.RELEASED) {
                long count = exchange.calls().stream()
                        .filter(call -> call.state() == state)
                        .count();
                text.value("state", word(state), count);
            }
        }
        text.counter("simgsm_calls_initiated_total", "Calls begun.").value(counts.callsInitiated());
        text.counter("simgsm_calls_answered_total", "Calls that became active.").value(counts.callsAnswered());
        text.counter("simgsm_calls_released_total", "Calls cleared, by cause of TS 24.008.");
        counts.releasedByCause().forEach((cause, count) -> text.value("cause", "" + cause, count));
        text.counter("simgsm_speech_frames_total", "Speech frames of 20 ms passed on.")
                .value(exchange.speechFrames());
        text.gauge("simgsm_messages_waiting", "Short messages and reports that wait.")
                .value(exchange.shortMessages().waitingCount());
        text.counter("simgsm_messages_total", "Short messages that have entered a state.");
        for (MessageState state : MessageState.values()) {
            text.value("state", word(state), counts.messages(state));
        }
        Runtime runtime = Runtime.getRuntime();
        text.gauge("simgsm_heap_used_bytes", "Memory in use by the program.")
                .value(runtime.totalMemory() - runtime.freeMemory());
        text.gauge("simgsm_heap_max_bytes", "Memory that the program may use.").value(runtime.maxMemory());
        return text.toString();
    }

    String subscribers(Exchange exchange) {
        JsonText json = new JsonText().open('[');
        exchange.subscribers().stream().limit(MOST_ELEMENTS).forEach(subscriber -> write(json, exchange, subscriber));
        return json.close(']').toString();
    }

    private static void write(JsonText json, Exchange exchange, Subscriber subscriber) {
        String otherwise = exchange.isBarred(subscriber) ? "barred" : "detached";
        json.open('{')
                .name("number")
                .value(subscriber.number().digits())
                .name("state")
                .value(subscriber.isAttached() ? "attached" : otherwise)
                .name("imsi")
                .value(subscriber.imsi().digits())
                .name("imei")
                .value(subscriber.imei().map(Imei::digits).orElse(""))
                .close('}');
    }

    String calls(Exchange exchange) {
        JsonText json = new JsonText().open('[');
        exchange.calls().stream().limit(MOST_ELEMENTS).forEach(call -> write(json, call));
        return json.close(']').toString();
    }

    private static void write(JsonText json, CallView call) {
        json.open('{')
                .name("from")
                .value(call.from().digits())
                .name("to")
                .value(call.to())
                .name("state")
                .value(word(call.state()))
                .name("seconds")
                .value(call.activeSeconds())
                .close('}');
    }

    String queue(Exchange exchange) {
        JsonText json = new JsonText().open('[');
        exchange.shortMessages().messages().waitingHistories(MOST_ELEMENTS).forEach(history -> write(json, history));
        return json.close(']').toString();
    }

    /** The course of a message; empty if it is unknown, or has ended long ago. */
    Optional<String> message(Exchange exchange, long id) {
        return exchange.shortMessages().messages().history(id).map(history -> {
            JsonText json = new JsonText();
            write(json, history);
            return json.toString();
        });
    }

    private static void write(JsonText json, MessageHistory history) {
        ShortMessage message = history.message();
        json.open('{')
                .name("id")
                .value(message.id())
                .name("from")
                .value(message.sender().value())
                .name("to")
                .value(message.to().digits())
                .name("state")
                .value(word(history.state()))
                .name("standing")
                .value(word(history.waitReason()));
        time(json, "accepted", message.acceptedAt());
        time(json, "expires", message.expiresAt());
        history.nextTry().ifPresent(next -> time(json, "next", next));
        history.endedAt().ifPresent(end -> time(json, "ended", end));
        json.name("attempts").value(history.attemptCount()).name("latest").open('[');
        for (DeliveryAttempt attempt : history.attempts()) {
            json.open('{');
            time(json, "at", attempt.at());
            json.name("outcome").value(word(attempt.outcome())).close('}');
        }
        json.close(']').close('}');
    }

    private static void time(JsonText json, String name, Instant time) {
        json.name(name).value(time.truncatedTo(ChronoUnit.MILLIS).toString());
    }

    private static String word(Enum<?> state) {
        return state.name().toLowerCase(Locale.ROOT);
    }
}
