package simgsm.center.web;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.IntSupplier;
import java.util.stream.Stream;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.smsc.MessageHistory;
import simgsm.center.smsc.MessageState;
import simgsm.event.EventForm;
import simgsm.web.JsonText;

/** The state of the exchange, as metrics and as JSON. On the exchange's thread; no list has more than 1000 elements. */
final class ExchangeReports {
    static final int MOST_ELEMENTS = 1_000;

    private static final EventForm SUBSCRIBER =
            EventForm.of(ExchangeSnapshot.SubscriberRow.class, "subscriber number= state= imsi= imei=");
    private static final EventForm MESSAGE = EventForm.of(
            MessageHistory.class,
            "message id=message.id from=message.sender.value to=message.to state= standing=waitReason"
                    + " accepted=message.acceptedAt expires=message.expiresAt [next=nextTry] [ended=endedAt]"
                    + " attempts=attemptCount");

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
        return list(
                exchange.subscribers().stream().map(exchange::row),
                (json, subscriber) -> json.object(SUBSCRIBER.values(subscriber, Map.of())));
    }

    String calls(Exchange exchange) {
        return list(exchange.calls().stream(), JsonText::object);
    }

    String queue(Exchange exchange) {
        return list(
                exchange.shortMessages().messages().waitingHistories(MOST_ELEMENTS).stream(), ExchangeReports::write);
    }

    private static <T> String list(Stream<T> elements, BiConsumer<JsonText, T> writer) {
        JsonText json = new JsonText().open('[');
        elements.limit(MOST_ELEMENTS).forEach(element -> writer.accept(json, element));
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
        json.open('{').fields(MESSAGE.values(history, Map.of())).name("latest").open('[');
        history.attempts().forEach(json::object);
        json.close(']').close('}');
    }

    private static String word(Enum<?> state) {
        return state.name().toLowerCase(Locale.ROOT);
    }
}
