package simgsm.center.msc;

import static simgsm.center.msc.NetworkCallAction.*;
import static simgsm.center.msc.NetworkCallEvent.*;
import static simgsm.center.msc.NetworkCallState.*;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The network's call control as a table: (state, event) to (next state, actions). Clauses are those of TS 24.008. What
 * has no row is not allowed: a message is answered with STATUS, anything else does nothing.
 */
final class NetworkCallTable {
    record Transition(NetworkCallState next, List<NetworkCallAction> actions) {}

    private static final Map<NetworkCallState, Map<NetworkCallEvent, Transition>> TABLE =
            new EnumMap<>(NetworkCallState.class);

    /** From the first message over the air to the clearing. */
    private static final Set<NetworkCallState> LIVE = EnumSet.of(
            CALL_INITIATED,
            CALL_PROCEEDING,
            CALL_DELIVERED,
            CALL_PRESENT,
            CALL_RECEIVED,
            CALL_CONFIRMED,
            ACTIVE,
            CONNECT_INDICATION);

    static {
        // 5.2.1: the mobile calls.
        on(NULL, SETUP_RECEIVED, CALL_INITIATED, TELL_OFFERED);
        on(CALL_INITIATED, PROCEED, CALL_PROCEEDING, SEND_CALL_PROCEEDING);
        on(CALL_PROCEEDING, ALERT, CALL_DELIVERED, SEND_ALERTING);
        on(CALL_PROCEEDING, ANSWER, CONNECT_INDICATION, SEND_CONNECT);
        on(CALL_DELIVERED, ANSWER, CONNECT_INDICATION, SEND_CONNECT);
        on(CONNECT_INDICATION, CONNECT_ACKNOWLEDGE_RECEIVED, ACTIVE, TELL_ACTIVE);

        // 5.2.2: the mobile is called.
        on(NULL, PAGE, MM_CONNECTION_PENDING);
        on(MM_CONNECTION_PENDING, RADIO_CONNECTED, CALL_PRESENT, SEND_SETUP);
        on(MM_CONNECTION_PENDING, PAGING_FAILED, NULL, TELL_CLEARED);
        on(MM_CONNECTION_PENDING, CLEAR, NULL);
        on(CALL_PRESENT, CALL_CONFIRMED_RECEIVED, CALL_CONFIRMED);
        on(CALL_CONFIRMED, ALERTING_RECEIVED, CALL_RECEIVED, TELL_ALERTING);
        on(CALL_CONFIRMED, CONNECT_RECEIVED, ACTIVE, SEND_CONNECT_ACKNOWLEDGE, TELL_ANSWERED);
        on(CALL_RECEIVED, CONNECT_RECEIVED, ACTIVE, SEND_CONNECT_ACKNOWLEDGE, TELL_ANSWERED);

        // 5.4.3: the mobile clears.
        on(LIVE, DISCONNECT_RECEIVED, RELEASE_REQUEST, SEND_RELEASE, TELL_CLEARED);
        on(LIVE, RELEASE_RECEIVED, NULL, SEND_RELEASE_COMPLETE, TELL_CLEARED);
        on(LIVE, RELEASE_COMPLETE_RECEIVED, NULL, TELL_CLEARED);
        on(LIVE, STATUS_NULL_RECEIVED, NULL, TELL_CLEARED);

        // 5.4.4: the network clears; a call that was not yet accepted is rejected (5.4.2).
        on(LIVE, CLEAR, DISCONNECT_INDICATION, SEND_DISCONNECT);
        on(CALL_INITIATED, CLEAR, NULL, SEND_RELEASE_COMPLETE);
        on(DISCONNECT_INDICATION, DISCONNECT_RECEIVED, RELEASE_REQUEST, SEND_RELEASE);
        on(DISCONNECT_INDICATION, RELEASE_RECEIVED, NULL, SEND_RELEASE_COMPLETE);
        on(DISCONNECT_INDICATION, T305_EXPIRED, RELEASE_REQUEST, SEND_RELEASE);
        on(DISCONNECT_INDICATION, T306_EXPIRED, RELEASE_REQUEST, SEND_RELEASE);
        on(RELEASE_REQUEST, RELEASE_RECEIVED, NULL);
        on(RELEASE_REQUEST, T308_EXPIRED, RELEASE_REQUEST, SEND_RELEASE);
        on(RELEASE_REQUEST, T308_EXPIRED_AGAIN, NULL);

        for (NetworkCallState state : EnumSet.of(DISCONNECT_INDICATION, RELEASE_REQUEST)) {
            on(state, RELEASE_COMPLETE_RECEIVED, NULL);
            on(state, STATUS_NULL_RECEIVED, NULL);
            on(state, LINK_LOST, NULL);
            // Sent before our clearing message reached the mobile.
            on(state, CALL_CONFIRMED_RECEIVED, state);
            on(state, ALERTING_RECEIVED, state);
            on(state, CONNECT_RECEIVED, state);
            on(state, CONNECT_ACKNOWLEDGE_RECEIVED, state);
        }
        on(RELEASE_REQUEST, DISCONNECT_RECEIVED, RELEASE_REQUEST);

        // Timers of the live states, and the link.
        on(CALL_PRESENT, T303_EXPIRED, DISCONNECT_INDICATION, SEND_DISCONNECT, TELL_CLEARED);
        on(CALL_CONFIRMED, T310_EXPIRED, DISCONNECT_INDICATION, SEND_DISCONNECT, TELL_CLEARED);
        on(CALL_RECEIVED, T301_EXPIRED, DISCONNECT_INDICATION, SEND_DISCONNECT, TELL_CLEARED);
        on(CONNECT_INDICATION, T313_EXPIRED, DISCONNECT_INDICATION, SEND_DISCONNECT, TELL_CLEARED);
        on(MM_CONNECTION_PENDING, LINK_LOST, NULL, TELL_CLEARED);
        on(LIVE, LINK_LOST, NULL, TELL_CLEARED);
    }

    private NetworkCallTable() {}

    /** The row for this event in this state; empty where the standard expects no such event. */
    static Optional<Transition> of(NetworkCallState state, NetworkCallEvent event) {
        return Optional.ofNullable(TABLE.getOrDefault(state, Map.of()).get(event));
    }

    private static void on(
            Set<NetworkCallState> states, NetworkCallEvent event, NetworkCallState next, NetworkCallAction... actions) {
        states.forEach(state -> on(state, event, next, actions));
    }

    private static void on(
            NetworkCallState state, NetworkCallEvent event, NetworkCallState next, NetworkCallAction... actions) {
        TABLE.computeIfAbsent(state, any -> new EnumMap<>(NetworkCallEvent.class))
                .put(event, new Transition(next, List.of(actions)));
    }
}
