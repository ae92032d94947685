package simgsm.modem;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.station.MobileStation;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationEvent.MessageFailed;
import simgsm.station.context.StationEvent.MessageSent;

/**
 * Replies to short messages. A reply that fails for lack of service is kept and repeated at the next registration;
 * one refused by a congested network after 30 s. If only the acknowledgement of the first attempt was lost, the
 * receiver may get the reply twice.
 */
final class Replies {
    /** If more replies are kept, the oldest fails. */
    static final int MAX_KEPT = 20;
    /** Age at which a kept reply fails. */
    static final long MAX_AGE_NANOS = TimeUnit.MINUTES.toNanos(10);

    /**
     * Temporary network failures (TS 24.011, table 8.4) except 41, after which the network may have accepted the
     * message.
     */
    private static final Set<RpCause> TEMPORARY =
            EnumSet.of(RpCause.NETWORK_OUT_OF_ORDER, RpCause.CONGESTION, RpCause.RESOURCES_UNAVAILABLE);

    /** @param id of the first attempt */
    private record Reply(int id, Msisdn to, String text, long sinceNanos) {}

    private final MobileStation station;
    private final Consumer<StationEvent> listener;
    /** By the id of the current attempt. */
    private final Map<Integer, Reply> sending = new HashMap<>();

    private final Deque<Reply> kept = new ArrayDeque<>();

    /** @param listener receives the outcome with the id of the first attempt, and all other events */
    Replies(MobileStation station, Consumer<StationEvent> listener) {
        this.station = station;
        this.listener = listener;
    }

    /** @return the id of the first attempt */
    int send(Msisdn to, String text) {
        int id = station.sendMessage(to, text);
        sending.put(id, new Reply(id, to, text, station.nowNanos()));
        return id;
    }

    void accept(StationEvent event) {
        if (event instanceof MessageSent sent) {
            Reply reply = sending.remove(sent.id());
            listener.accept(reply == null ? sent : new MessageSent(reply.id(), sent.to(), sent.parts()));
        } else if (event instanceof MessageFailed failed) {
            failed(failed);
        } else {
            listener.accept(event);
            if (event instanceof StationEvent.StationRegistered) {
                sendKept();
            } else if (event instanceof StationEvent.ReminderDue) {
                reminded();
            }
        }
    }

    private void failed(MessageFailed failure) {
        Reply reply = sending.remove(failure.id());
        if (reply == null) {
            listener.accept(failure);
        } else if (TEMPORARY.contains(failure.cause()) && station.snapshot().powered()) {
            keep(reply);
        } else {
            fail(reply, failure.cause());
        }
    }

    private void keep(Reply reply) {
        if (kept.size() == MAX_KEPT) {
            fail(kept.remove(), RpCause.NETWORK_OUT_OF_ORDER);
        }
        kept.add(reply);
        station.remind();
    }

    private void fail(Reply reply, RpCause cause) {
        listener.accept(new MessageFailed(reply.id(), reply.to(), cause));
    }

    private void sendKept() {
        List<Reply> all = List.copyOf(kept);
        kept.clear();
        for (Reply reply : all) {
            sending.put(station.sendMessage(reply.to(), reply.text()), reply);
        }
    }

    private void reminded() {
        while (!kept.isEmpty() && station.nowNanos() - kept.element().sinceNanos() >= MAX_AGE_NANOS) {
            fail(kept.remove(), RpCause.NETWORK_OUT_OF_ORDER);
        }
        if (station.snapshot().registered()) {
            sendKept();
        } else if (!kept.isEmpty()) {
            station.remind();
        }
    }
}
