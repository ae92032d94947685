package simgsm.center.web;

import java.util.EnumMap;
import java.util.Map;
import java.util.TreeMap;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.smsc.MessageState;

/** Counts the exchange's events since its start. Owned by the exchange's thread. */
public final class EventCounts {
    private final Map<Integer, Long> releasedByCause = new TreeMap<>();
    private final Map<MessageState, Long> messages = new EnumMap<>(MessageState.class);
    private long callsInitiated;
    private long callsAnswered;

    /** Creates counts of 0. */
    public EventCounts() {}

    /** Counts an event. */
    public void accept(ExchangeEvent event) {
        if (event instanceof ExchangeEvent.MessageChanged message) {
            messages.merge(message.state(), 1L, Long::sum);
        } else if (event instanceof ExchangeEvent.CallChanged call) {
            callsInitiated += call.state() == CallProgress.INITIATED ? 1 : 0;
            callsAnswered += call.state() == CallProgress.ACTIVE ? 1 : 0;
            call.cause().ifPresent(cause -> releasedByCause.merge(cause.code(), 1L, Long::sum));
        }
    }

    long callsInitiated() {
        return callsInitiated;
    }

    long callsAnswered() {
        return callsAnswered;
    }

    /** Calls that were released, by the cause of TS 24.008. */
    Map<Integer, Long> releasedByCause() {
        return releasedByCause;
    }

    long messages(MessageState state) {
        return messages.getOrDefault(state, 0L);
    }
}
