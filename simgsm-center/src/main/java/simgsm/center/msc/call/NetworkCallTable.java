package simgsm.center.msc.call;

import static simgsm.center.msc.call.NetworkCallAction.*;
import static simgsm.center.msc.call.NetworkCallEvent.*;
import static simgsm.center.msc.call.NetworkCallState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/**
 * Call control of the network (TS 24.008, 5.2 and 5.4). A message without a row is answered with STATUS, any other event
 * without a row is ignored.
 */
public final class NetworkCallTable {
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

    private static final Set<NetworkCallState> CLEARING = EnumSet.of(DISCONNECT_INDICATION, RELEASE_REQUEST);

    public static final StateTable<NetworkCallState, NetworkCallEvent, NetworkCallAction> ROWS =
            new StateTable<>("network call", NULL);

    static {
        originating();
        terminating();
        clearingByTheMobile();
        clearingByTheNetwork();
        timersAndLink();
    }

    private NetworkCallTable() {}

    /** 5.2.1. */
    private static void originating() {
        ROWS.on(NULL, SETUP_RECEIVED, CALL_INITIATED, TELL_OFFERED)
                .on(CALL_INITIATED, PROCEED, CALL_PROCEEDING, SEND_CALL_PROCEEDING)
                .on(CALL_PROCEEDING, ALERT, CALL_DELIVERED, SEND_ALERTING, PLAY_TONE)
                .on(EnumSet.of(CALL_PROCEEDING, CALL_DELIVERED), ANSWER, CONNECT_INDICATION, SEND_CONNECT)
                .on(CONNECT_INDICATION, CONNECT_ACKNOWLEDGE_RECEIVED, ACTIVE, TELL_ACTIVE);
    }

    /** 5.2.2. */
    private static void terminating() {
        ROWS.on(NULL, PAGE, MM_CONNECTION_PENDING)
                .on(MM_CONNECTION_PENDING, RADIO_CONNECTED, CALL_PRESENT, SEND_SETUP)
                .on(MM_CONNECTION_PENDING, PAGING_FAILED, NULL, TELL_CLEARED)
                .on(MM_CONNECTION_PENDING, CLEAR, NULL)
                .on(CALL_PRESENT, CALL_CONFIRMED_RECEIVED, CALL_CONFIRMED)
                .on(CALL_CONFIRMED, ALERTING_RECEIVED, CALL_RECEIVED, TELL_ALERTING)
                .on(
                        EnumSet.of(CALL_CONFIRMED, CALL_RECEIVED),
                        CONNECT_RECEIVED,
                        ACTIVE,
                        SEND_CONNECT_ACKNOWLEDGE,
                        TELL_ANSWERED);
    }

    /** 5.4.3. */
    private static void clearingByTheMobile() {
        ROWS.on(LIVE, DISCONNECT_RECEIVED, RELEASE_REQUEST, SEND_RELEASE, TELL_CLEARED)
                .on(LIVE, RELEASE_RECEIVED, NULL, SEND_RELEASE_COMPLETE, TELL_CLEARED)
                .on(LIVE, EnumSet.of(RELEASE_COMPLETE_RECEIVED, STATUS_NULL_RECEIVED), NULL, TELL_CLEARED);
    }

    /** 5.4.4; a call that is not yet accepted is rejected (5.4.2). */
    private static void clearingByTheNetwork() {
        Set<NetworkCallState> accepted = EnumSet.copyOf(LIVE);
        accepted.remove(CALL_INITIATED);
        ROWS.on(accepted, CLEAR, DISCONNECT_INDICATION, SEND_DISCONNECT, PLAY_TONE)
                .on(CALL_INITIATED, CLEAR, NULL, SEND_RELEASE_COMPLETE)
                .on(
                        EnumSet.of(DISCONNECT_INDICATION),
                        EnumSet.of(DISCONNECT_RECEIVED, T305_EXPIRED, T306_EXPIRED),
                        RELEASE_REQUEST,
                        SEND_RELEASE)
                .on(DISCONNECT_INDICATION, RELEASE_RECEIVED, NULL, SEND_RELEASE_COMPLETE)
                .on(EnumSet.of(RELEASE_REQUEST), EnumSet.of(RELEASE_RECEIVED, T308_EXPIRED_AGAIN), NULL)
                .on(RELEASE_REQUEST, T308_EXPIRED, RELEASE_REQUEST, START_T308, SEND_RELEASE)
                .on(CLEARING, EnumSet.of(RELEASE_COMPLETE_RECEIVED, STATUS_NULL_RECEIVED, LINK_LOST), NULL)
                // Messages that crossed the network's clearing message.
                .stay(CLEARING, CALL_CONFIRMED_RECEIVED)
                .stay(CLEARING, ALERTING_RECEIVED)
                .stay(CLEARING, CONNECT_RECEIVED)
                .stay(CLEARING, CONNECT_ACKNOWLEDGE_RECEIVED)
                .stay(EnumSet.of(RELEASE_REQUEST), DISCONNECT_RECEIVED);
    }

    private static void timersAndLink() {
        expiry(CALL_PRESENT, T303_EXPIRED);
        expiry(CALL_CONFIRMED, T310_EXPIRED);
        expiry(CALL_RECEIVED, T301_EXPIRED);
        expiry(CONNECT_INDICATION, T313_EXPIRED);
        ROWS.on(LIVE, LINK_LOST, NULL, TELL_CLEARED).on(MM_CONNECTION_PENDING, LINK_LOST, NULL, TELL_CLEARED);
    }

    private static void expiry(NetworkCallState state, NetworkCallEvent event) {
        ROWS.on(state, event, DISCONNECT_INDICATION, SEND_DISCONNECT, TELL_CLEARED);
    }
}
