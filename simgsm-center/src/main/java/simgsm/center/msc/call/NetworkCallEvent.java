package simgsm.center.msc.call;

import java.util.Arrays;
import simgsm.center.msc.link.NetworkTimer;

/** Events of a call leg on the network side. */
public enum NetworkCallEvent {
    // From the mobile.
    SETUP_RECEIVED,
    CALL_CONFIRMED_RECEIVED,
    ALERTING_RECEIVED,
    CONNECT_RECEIVED,
    CONNECT_ACKNOWLEDGE_RECEIVED,
    DISCONNECT_RECEIVED,
    RELEASE_RECEIVED,
    RELEASE_COMPLETE_RECEIVED,
    /** STATUS with call state 0: the mobile has no such call (TS 24.008, 8.4). */
    STATUS_NULL_RECEIVED,

    // From the call.
    PAGE,
    PROCEED,
    ALERT,
    ANSWER,
    CLEAR,

    // From the link.
    RADIO_CONNECTED,
    PAGING_FAILED,
    LINK_LOST,

    T301_EXPIRED(NetworkTimer.T301),
    T303_EXPIRED(NetworkTimer.T303),
    T305_EXPIRED(NetworkTimer.T305),
    T306_EXPIRED(NetworkTimer.T306),
    T308_EXPIRED(NetworkTimer.T308),
    /** T308 after the repeated RELEASE. */
    T308_EXPIRED_AGAIN,
    T310_EXPIRED(NetworkTimer.T310),
    T313_EXPIRED(NetworkTimer.T313);

    private final NetworkTimer timer;

    NetworkCallEvent() {
        this(null);
    }

    NetworkCallEvent(NetworkTimer timer) {
        this.timer = timer;
    }

    /** The expiry of a call control timer. */
    static NetworkCallEvent expiryOf(NetworkTimer timer) {
        return Arrays.stream(values())
                .filter(event -> event.timer == timer)
                .findFirst()
                .orElseThrow();
    }
}
