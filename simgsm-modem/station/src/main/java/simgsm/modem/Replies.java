package simgsm.modem;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.station.MobileStation;

/**
 * Short messages that somebody waits for. The station gives one up that finds no service for 40 s; here it is kept and sent
 * anew as soon as there is service, or half a minute later where the network was there but refused for the time being. A
 * reply whose first dialogue broke off before its answer may come twice, which is better than never.
 */
final class Replies {
    /** So many are kept; of more the oldest is given up. */
    static final int MOST_KEPT = 20;
    /** Nobody waits longer. */
    static final long PATIENCE_NANOS = TimeUnit.MINUTES.toNanos(10);

    /** What passes, of the temporary network failures in TS 24.011, table 8.4; 41 may mean that the message was taken. */
    private static final Set<RpCause> PASSING =
            EnumSet.of(RpCause.NETWORK_OUT_OF_ORDER, RpCause.CONGESTION, RpCause.RESOURCES_UNAVAILABLE);

    private record Reply(int id, Msisdn to, String text, long sinceNanos) {}

    private final MobileStation station;
    private final ModemListener listener;
    /** By the reference of the present attempt. */
    private final Map<Integer, Reply> underWay = new HashMap<>();

    private final Deque<Reply> kept = new ArrayDeque<>();

    Replies(MobileStation station, ModemListener listener) {
        this.station = station;
        this.listener = listener;
    }

    /** @return the message reference of the first attempt, by which the reply is known to the listener */
    int send(Msisdn to, String text) {
        int id = station.sendMessage(to, text);
        underWay.put(id, new Reply(id, to, text, station.nowNanos()));
        return id;
    }

    void sent(int attempt, Msisdn to, int parts) {
        Reply reply = underWay.remove(attempt);
        listener.smsSent(reply == null ? attempt : reply.id(), to, parts);
    }

    void failed(int attempt, Msisdn to, RpCause cause) {
        Reply reply = underWay.remove(attempt);
        if (reply != null && PASSING.contains(cause) && station.snapshot().powered()) {
            keep(reply);
        } else {
            listener.smsFailed(reply == null ? attempt : reply.id(), to, cause);
        }
    }

    private void keep(Reply reply) {
        if (kept.size() == MOST_KEPT) {
            giveUp(kept.remove());
        }
        kept.add(reply);
        station.remind();
    }

    private void giveUp(Reply reply) {
        listener.smsFailed(reply.id(), reply.to(), RpCause.NETWORK_OUT_OF_ORDER);
    }

    void registered() {
        List<Reply> all = List.copyOf(kept);
        kept.clear();
        for (Reply reply : all) {
            underWay.put(station.sendMessage(reply.to(), reply.text()), reply);
        }
    }

    void reminded() {
        while (!kept.isEmpty() && station.nowNanos() - kept.element().sinceNanos() >= PATIENCE_NANOS) {
            giveUp(kept.remove());
        }
        if (station.snapshot().registered()) {
            registered();
        } else if (!kept.isEmpty()) {
            station.remind();
        }
    }
}
